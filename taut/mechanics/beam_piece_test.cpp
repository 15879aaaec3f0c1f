#include "taut/mechanics/beam_piece.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "taut/machine/compile/beam_build.hpp"
#include "test/support/configured.hpp"
#include "test/support/machines.hpp"

/// Rows of a piece against a textbook's cantilever, against the balance of a free body, and against plain rotations.
namespace taut::mechanics::beam_piece_test {

using machine::BeamHold;
using machine::BeamTop;
using taut_test::body;

/// A machine with one beam from `b.from` to `b.to`, as built, with the forces at its start still open.
struct OneBeam {
  machine::Model m;
  Layout layout;
  Configuration c;
  Evaluation e;

  OneBeam(machine::Model with, const machine::StraightBeam& b) : m(std::move(with)) {
    machine::add_beam(m, b);
    const machine::State state = machine::initial_state(m);
    layout = mechanics::layout(m, state, std::nullopt, taut_test::no_flow(m));
    c = mechanics::configuration_of(layout, state);
  }
  const Eigen::VectorXd& residual() {
    e.residual.setZero(layout.size);
    add_beams({.model = m, .layout = layout}, c, e);
    return e.residual;
  }
};

machine::StraightBeam upright(double height) {
  machine::StraightBeam b;
  b.name = "mast";
  b.to.at = {0, 0, height};
  b.section = structure::tube_section(0.3, 0.01);
  b.section.EI_y *= 0.4;
  b.section.weight = 900;
  return b;
}

TEST(BeamPiece, ACantileverOfFirstOrderEndsWhereTheTextbookSays) {
  machine::StraightBeam b = upright(8);
  b.order = structure::BeamOrder::first;
  OneBeam beam({}, b);
  const double l = 8, Fx = 3e3, Fy = -2e3, Fz = -50e3, Mx = 7e3, My = 11e3, Mz = 5e3, w = 900;
  beam.c.pieces[0].force = {Fx, Fy, Fz};
  beam.c.pieces[0].moment = {Mx, My, Mz};
  const Eigen::VectorXd& r = beam.residual();
  const Eigen::Index row = beam.layout.pieces[0].unknown;
  const auto& [EI_x, EI_y, EA, GJ] = std::tie(b.section.EI_x, b.section.EI_y, b.section.EA, b.section.GJ);
  // M_y(s) = M_y - F_x s bends towards x, M_x(s) = M_x + F_y s against y
  EXPECT_NEAR(r[row], (My / 2 - Fx * l / 6) * l * l / EI_x, 1e-12);
  EXPECT_NEAR(r[row + 1], -(Mx / 2 + Fy * l / 6) * l * l / EI_y, 1e-12);
  EXPECT_NEAR(r[row + 2], (Fz + w * l / 2) * l / EA, 1e-12);
  EXPECT_NEAR(r[row + 3], (Mx + Fy * l / 2) * l / EI_y, 1e-6);  // a turn as its sine
  EXPECT_NEAR(r[row + 4], (My - Fx * l / 2) * l / EI_x, 1e-6);
  EXPECT_NEAR(r[row + 5], Mz * l / GJ, 1e-6);
  // on the body at its top
  const Vector3 F(Fx, Fy, Fz + w * l), M(Mx + Fy * l, My - Fx * l, Mz);
  EXPECT_LT((r.segment<3>(0) + F).norm(), 1e-9 * F.norm());
  EXPECT_LT((r.segment<3>(3) + M).norm(), 1e-9 * M.norm());
}

/// Whatever its unknowns are, open or not: a beam gives its two ends its weight and no moment more.
TEST(BeamPiece, WhatItGivesToItsEndsIsItsWeight) {
  for (const double weight : {0.0, 700.0}) {
    machine::Model m;
    m.bodies = {body("foot", {0.4, -0.2, 1}, 0, "xyzXYZ"), body("head", {2, 3, 9}, 0, "xyzXYZ")};
    m.bodies[0].orientation = Eigen::AngleAxisd(0.7, Vector3(1, -2, 0.5).normalized());
    machine::StraightBeam b = upright(8);
    b.from = {.body = 0, .at = {0.3, 0.1, -0.2}};
    b.to = {.body = 1, .at = {-0.1, 0.2, 0.3}};
    b.top = BeamTop::clamped;
    b.bow = 1.0 / 250;
    b.sense = {1, -1, 0};
    b.section.weight = weight;
    OneBeam beam(m, b);
    beam.c.pieces[0].force = {30e3, -12e3, -150e3};
    beam.c.pieces[0].moment = {40e3, 25e3, -8e3};
    const Eigen::VectorXd& r = beam.residual();
    const Vector3 foot = r.segment<3>(0), head = r.segment<3>(6);
    const double length = beam.m.beams[0].length;  // along the bow
    EXPECT_LT((foot + head + Vector3(0, 0, weight * length)).norm(), 1e-9 * 150e3);
    if (weight > 0) continue;
    // moments about the ground's origin; the end's force acts where the piece ends, not where the body has its place
    const Vector3 open = r.segment<3>(beam.layout.pieces[0].unknown);
    EXPECT_GT(open.norm(), 0.01);
    const Vector3 moment = m.bodies[0].position.cross(foot) + Vector3(r.segment<3>(3)) +
                           m.bodies[1].position.cross(head) + Vector3(r.segment<3>(9)) + open.cross(head);
    EXPECT_LT(moment.norm(), 1e-7 * 150e3 * length);
  }
}

TEST(BeamPiece, AHingeLeansFreelyAndDoesNotTurnAboutItsAxis) {
  machine::StraightBeam b = upright(6);
  b.base = BeamHold::hinged;
  b.section.weight = 0;
  OneBeam beam({}, b);
  const Layout::Piece& p = beam.layout.pieces[0];
  ASSERT_TRUE(p.hinged);
  const Matrix3 built = beam.c.pieces[0].axes;
  const auto twist = [&](const Vector3& by) {
    Configuration moved = beam.c;
    Eigen::VectorXd step = Eigen::VectorXd::Zero(beam.layout.size);
    step.segment<3>(p.unknown + 4) = by;
    move_beams({.model = beam.m, .layout = beam.layout}, step, 1, moved);
    std::swap(beam.c, moved);
    const double open = beam.residual()[p.unknown + 6];
    const Vector3 lean = piece_start({.model = beam.m, .layout = beam.layout}, beam.c, 0).axes.col(2);
    EXPECT_NEAR(lean.z(), by.z() == 0 ? std::cos(by.norm()) : 1, 1e-12);
    std::swap(beam.c, moved);
    return open;
  };
  EXPECT_NEAR(twist({0.4, 0, 0}), 0, 1e-12);
  EXPECT_NEAR(twist({0.3, -0.5, 0}), 0, 1e-12);
  EXPECT_NEAR(twist({0, 0, 0.3}), std::sin(0.3), 1e-12);
  // its torque is all of the moment there: none across the axis
  beam.c.pieces[0].axes = built;
  beam.c.pieces[0].torque = 900;
  EXPECT_LT((piece_start({beam.m, beam.layout}, beam.c, 0).moment - Vector3(0, 0, 900)).norm(), 1e-9);
}

/// A ball joint at the end leaves a moment open that has to vanish: a force; a clamped one a turn: a length.
TEST(BeamPiece, TheMisfitTellsForcesFromLengths) {
  for (const BeamTop top : {BeamTop::hinged, BeamTop::clamped}) {
    machine::Model m;
    m.bodies.push_back(body("head", {0, 0, 5}, 0, "z"));
    machine::StraightBeam b = upright(5);
    b.to = {.body = 0, .at = Vector3::Zero()};
    b.top = top;
    b.section.weight = 0;
    OneBeam beam(m, b);
    beam.c.pieces[0].force = {200, 0, 0};
    beam.residual();
    double force = 0, length = 0;
    add_beam_misfit({.model = beam.m, .layout = beam.layout}, beam.e, force, length);
    const double EI = b.section.EI_x, place = 200.0 * 125 / (6 * EI), turn = 200.0 * 25 / (2 * EI);
    const double size = beam.layout.length;
    EXPECT_NEAR(force, top == BeamTop::hinged ? 200 * 5 / size : 0, 1e-3);
    EXPECT_NEAR(length, top == BeamTop::hinged ? place : std::max(place, turn * size), 1e-3 * place);
  }
}

}  // namespace taut::mechanics::beam_piece_test
