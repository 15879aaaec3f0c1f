#include "taut/solve/tables.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "test/support/machines.hpp"

namespace taut::solve::tables_test {

using namespace taut_test;

EquilibriumResult solved(const machine::Model& m, Motion motion = Motion::in) {
  EquilibriumOptions options;
  options.motion = motion;
  EquilibriumResult r = equilibrium(m, options);
  EXPECT_TRUE(r.outcome.ok()) << r.outcome.message;
  return r;
}

TEST(Tables, WhatHoldsTheEndsAndSupportsCarriesTheRope) {
  const machine::Model m = three_spans(316, 0.15);
  const EquilibriumResult r = solved(m);
  Vector3 sum = Vector3::Zero();
  double free = 0;
  const BranchResult &first = r.branches.front(), &last = r.branches.back();
  sum += rope::force_on_start(first.shape) + rope::force_on_end(last.shape);
  for (const ContactResult& c : r.contacts) sum += c.force;
  for (const BranchResult& s : r.branches) free += s.unstretched;
  EXPECT_NEAR(sum.x(), 0, 1e-6);
  EXPECT_NEAR(sum.y(), 0, 1e-6);
  EXPECT_NEAR(sum.z(), -20 * free, 1e-6) << "down on what holds it";
}

TEST(Tables, UnstretchedIsTheSameOfSpansAndRopes) {
  // cold, warm, and the rope on rounds and on points
  for (const double strain : {-6e-4, 0.0, 6e-4}) {
    for (const double radius : {0.0, 0.6}) {
      machine::Model m = three_spans(316, 0.15);
      m.reevings[0].thermal_strain = strain;
      for (std::size_t k = 1; k + 1 < m.reevings[0].nodes.size(); ++k) m.reevings[0].nodes[k].radius = radius;
      const EquilibriumResult r = solved(m);
      double free = 0, on_rounds = 0;
      for (const BranchResult& s : r.branches) {
        free += s.unstretched;
        EXPECT_NEAR(s.shape.rope.length, s.unstretched * (1 + strain), 1e-9);
      }
      for (const ContactResult& c : r.contacts) {
        const double strained = 1 + (c.T_in + c.T_out) / 2 / m.reevings[0].stiffness;
        on_rounds += radius * c.wrap / strained / (1 + strain);
      }
      EXPECT_NEAR(r.ropes[0].unstretched, 316, 1e-7) << "as given, at the reference temperature";
      EXPECT_NEAR(free + on_rounds, 316, radius > 0 ? 1e-5 : 1e-7) << strain << ", " << radius;
      EXPECT_EQ(on_rounds > 0, radius > 0);
    }
  }
}

TEST(Tables, ASpansRowIsItsShape) {
  for (const BranchResult& s : solved(with_carriage(true)).branches) {
    EXPECT_NEAR(std::hypot(s.H, s.V_from), s.T_from, 1e-9 * s.T_from);
    EXPECT_NEAR(std::hypot(s.H, s.V_to), s.T_to, 1e-9 * s.T_to);
    EXPECT_NEAR((s.end - s.start).norm(), s.chord, 1e-9 * s.chord);
    EXPECT_NEAR(s.V_to - s.V_from, s.shape.rope.weight * s.unstretched, 1e-7 * s.T_to);
    // the longest way from the chord by a fine grid
    double sag = 0;
    for (int i = 0; i <= 2000; ++i) {
      const Vector3 p = rope::point_at(s.shape, s.unstretched * i / 2000.0), chord = s.end - s.start;
      const double x = p.dot(s.shape.along) / std::hypot(chord.x(), chord.y());
      sag = std::max(sag, x * chord.z() - p.z());
    }
    EXPECT_NEAR(s.sag, sag, 1e-5 * s.chord);
    EXPECT_GE(s.stretched, s.chord * (1 - 1e-12));
  }
}

TEST(Tables, ARopesRowIsTheWorstOfItsSpans) {
  machine::Model m = with_carriage(true);
  m.reevings[0].breaking_force = 300e3;
  const EquilibriumResult r = solved(m);
  double most = 0;
  for (const BranchResult& s : r.branches) {
    if (s.reeving == 0) most = std::max({most, s.T_from, s.T_to});
  }
  EXPECT_EQ(r.ropes[0].T_max, most);
  EXPECT_NEAR(r.ropes[0].safety_factor, 300e3 / most, 1e-12);
  const BranchResult& worst = r.branches[static_cast<std::size_t>(r.ropes[0].branch)];
  EXPECT_EQ(r.ropes[0].at_end ? worst.T_to : worst.T_from, most);
  EXPECT_EQ(r.ropes[1].safety_factor, 0) << "not known";
}

TEST(Tables, AReactionIsWhatFixedDirectionsTake) {
  machine::Model m = tackle(4, 1, 3000);
  m.bodies[0].free.pop_back();  // the block on a vertical... slide along x only
  m.bodies[0].position = {0, 0, 5};
  const EquilibriumResult r = solved(m, Motion::at_rest);
  double pull = 0;
  for (const ContactResult& c : r.contacts) {
    if (m.reevings[0].nodes[static_cast<std::size_t>(c.node)].at.body == 0) pull += c.force.z();
  }
  pull += m.reevings[0].nodes.back().at.body == 0 ? rope::force_on_end(r.branches.back().shape).z() : 0;
  EXPECT_NEAR(r.reactions[0].z(), 3000 * m.gravity - pull, 1e-6);
  EXPECT_NEAR(r.reactions[0].x(), 0, 1e-6);
}

}  // namespace taut::solve::tables_test
