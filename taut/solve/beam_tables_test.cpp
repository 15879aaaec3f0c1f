#include "taut/solve/beam_tables.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "taut/machine/compile/beam_build.hpp"
#include "taut/mechanics/beam_piece.hpp"
#include "test/support/configured.hpp"
#include "test/support/machines.hpp"

/// What is reported of a beam in a state set by hand, against the formulas of a cantilever; and each verdict on one.
namespace taut::solve::beam_tables_test {

constexpr double h = 9;

machine::StraightBeam cantilever(structure::BeamOrder order = structure::BeamOrder::first) {
  machine::StraightBeam b;
  b.name = "mast";
  b.to.at = {0, 0, h};
  b.section = structure::tube_section(0.4, 0.012);
  b.order = order;
  return b;
}

struct SetByHand {
  machine::Model m;
  mechanics::Layout layout;
  mechanics::Configuration c;

  explicit SetByHand(const machine::StraightBeam& b) {
    machine::add_beam(m, b);
    const machine::State state = machine::initial_state(m);
    layout = mechanics::layout(m, state, std::nullopt, taut_test::no_flow(m));
    c = mechanics::configuration_of(layout, state);
  }
  mechanics::System system() const { return {.model = m, .layout = layout}; }
};

TEST(BeamTables, PointsOfACantileverAreTheTextbooks) {
  SetByHand one(cantilever());
  const structure::BeamSection section = structure::tube_section(0.4, 0.012);
  const double H = 6e3, N = 80e3, M = 70e3, EI = section.EI_x;
  one.c.pieces[0].force = {0, H, -N};
  one.c.pieces[0].moment = {-M, 0, 0};  // bends it towards +y
  const BeamResult r = beam_results(one.system(), one.c).at(0);
  EXPECT_EQ(r.base_force, Vector3(0, -H, N));
  EXPECT_EQ(r.base_moment, Vector3(M, 0, 0));
  const auto turn = [&](double s) { return (M * s - H * s * s / 2) / EI; };
  const auto deflection = [&](double s) { return (M / 2 - H * s / 6) * s * s / EI; };
  ASSERT_GT(r.points.size(), 10U);
  EXPECT_EQ(r.points.front().s, 0);
  EXPECT_NEAR(r.points.back().s, h, 1e-12);
  for (const BeamPoint& p : r.points) {
    EXPECT_NEAR(p.N, -N, 1e-9 * N);
    EXPECT_NEAR(p.V, H, 1e-9 * N);
    EXPECT_NEAR(p.M, std::abs(M - H * p.s), 1e-9 * M);
    EXPECT_NEAR(p.bends_to_y, M - H * p.s, 1e-9 * M);
    EXPECT_NEAR(p.stress, N / section.area + std::abs(M - H * p.s) / section.W_x, 1e-9 * 200e6);
    EXPECT_NEAR(p.w, deflection(p.s), 1e-12);
    EXPECT_NEAR(p.deflection.z(), -N * p.s / section.EA, 1e-12);
    EXPECT_NEAR(p.torsion, 0, 1e-9 * M);
  }
  EXPECT_EQ(r.most_bent, 0U);
  EXPECT_EQ(r.most_stressed, 0U);
  EXPECT_NEAR(r.compression, N, 1e-9 * N);
  const double top = deflection(h), sinks = N * h / section.EA;
  EXPECT_NEAR(r.top_displacement, std::hypot(top, sinks), 1e-12);
  EXPECT_NEAR(r.lean, std::atan2(top, h - sinks), 1e-12);
  EXPECT_NEAR(r.bend, std::atan(turn(h)), 1e-12);
}

/// What the ends feel of a beam, and its weight, are the same.
TEST(BeamTables, ForcesOnItsEndsAddUpToItsWeight) {
  machine::StraightBeam b = cantilever(structure::BeamOrder::second);
  b.section.weight = 1100;
  b.stations = {0.35};
  SetByHand one(b);
  one.c.pieces[0].force = {4e3, -3e3, -90e3};
  one.c.pieces[1].force = {1e3, 2e3, -20e3};
  std::vector<Vector3> on(one.m.bodies.size() + 1, Vector3::Zero());
  Vector3 outside = Vector3::Zero();
  act_beams(
      one.system(), one.c, [&](int body, const Vector3& F) { on.at(static_cast<std::size_t>(body) + 1) += F; },
      outside);
  EXPECT_LT((outside - Vector3(0, 0, -1100 * h)).norm(), 1e-9);
  EXPECT_LT((on[0] - Vector3(4e3, -3e3, -90e3)).norm(), 1e-9);                   // the ground
  EXPECT_LT((on[2] + Vector3(1e3, 2e3, -20e3 + 1100 * 0.65 * h)).norm(), 1e-7);  // its top
  EXPECT_LT((on[0] + on[1] + on[2] - outside).norm(), 1e-7);
}

/// The message about a beam; empty: it stays.
std::string verdict(SetByHand& one, double* factor = nullptr) {
  taut::Array<BeamResult> results = beam_results(one.system(), one.c);
  const Outcome reported = check_beams(one.system(), one.c, results);
  EXPECT_EQ(beams_stay(one.system(), one.c).status, reported.status);
  EXPECT_EQ(reported.ok(), reported.message.empty());
  if (factor) *factor = results.at(0).critical_factor;
  return reported.message;
}

TEST(BeamTables, ABeamBucklesAtEulersLoadAndNotBefore) {
  machine::StraightBeam b = cantilever(structure::BeamOrder::second);
  b.section.EA *= 1e5;  // it keeps its length
  SetByHand one(b);
  const double critical = std::pow(std::numbers::pi / (2 * h), 2) * structure::tube_section(0.4, 0.012).EI_x;
  double factor = 0;
  one.c.pieces[0].force = {0, 0, -0.98 * critical};
  EXPECT_EQ(verdict(one, &factor), "");
  EXPECT_NEAR(factor, 1 / 0.98, 1e-3);
  one.c.pieces[0].force = {0, 0, -1.02 * critical};
  const std::string message = verdict(one, &factor);
  EXPECT_NE(message.find("'mast' buckles"), std::string::npos) << message;
  EXPECT_NEAR(factor, 1 / 1.02, 1e-3);
}

TEST(BeamTables, ABeamThatIsBentTooFarGivesWay) {
  SetByHand one(cantilever());
  const double EI = structure::tube_section(0.4, 0.012).EI_x;
  for (const double turn : {0.99 * most_bend, 1.01 * most_bend}) {
    const double M = std::tan(turn) * EI / h;
    one.c.pieces[0].moment = {0, M, 0};
    one.c.pieces[0].force = {0, 0, 0};
    const std::string message = verdict(one);
    EXPECT_EQ(message.find("'mast' gives way") != std::string::npos, turn > most_bend) << message;
  }
}

TEST(BeamTables, ABeamThatLeansTooFarHasFallen) {
  machine::StraightBeam b = cantilever(structure::BeamOrder::second);
  b.base = machine::BeamHold::hinged;
  for (double* stiffness : {&b.section.EI_x, &b.section.EI_y, &b.section.EA}) *stiffness *= 1e5;
  SetByHand one(b);
  for (const double lean : {0.99 * most_lean, 1.01 * most_lean}) {
    one.c.pieces[0].axes = Eigen::AngleAxisd(lean, Vector3::UnitX()).toRotationMatrix();
    one.c.pieces[0].force = {0, 0, -100e3};
    EXPECT_NEAR(beam_results(one.system(), one.c).at(0).lean, lean, 1e-5);
    const std::string message = verdict(one);
    // nothing holds it in either case; the one has fallen, the other would
    EXPECT_EQ(message.find("'mast' falls over: where it comes to rest") != std::string::npos, lean > most_lean)
        << message;
    EXPECT_EQ(message.find("falls over at the least push") != std::string::npos, lean < most_lean) << message;
  }
}

}  // namespace taut::solve::beam_tables_test
