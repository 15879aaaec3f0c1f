#include "taut/solve/rest/newton.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "taut/solve/equilibrium.hpp"
#include "test/support/configured.hpp"
#include "test/support/machines.hpp"

namespace taut::solve::newton_test {

using namespace taut_test;

/// A machine at its equilibrium, laid out.
struct Solved {
  machine::Model model;
  EquilibriumResult at;
  mechanics::Layout laid_out;
  mechanics::Configuration c;
};

Solved solved(const machine::Model& m) {
  Solved s{.model = m, .at = equilibrium(m), .laid_out = {}, .c = {}};
  EXPECT_TRUE(s.at.outcome.ok()) << s.at.outcome.message;
  s.laid_out = mechanics::layout(m, s.at.state, {}, no_flow(m));
  s.c = mechanics::configuration_of(s.laid_out, s.at.state);
  return s;
}

double apart(const mechanics::Configuration& a, const mechanics::Configuration& b) {
  double far = 0;
  for (std::size_t i = 0; i < a.bodies.size(); ++i) {
    far = std::max(far, (a.bodies[i].position - b.bodies[i].position).norm());
  }
  for (std::size_t k = 0; k < a.branches.size(); ++k) {
    far = std::max(far, std::abs(a.branches[k].length - b.branches[k].length));
  }
  return far;
}

TEST(Newton, ComesBackFromBesideTheAnswer) {
  for (const machine::Model& m : {with_carriage(true), tackle(4, 1, 3000), rollers(2, 0.8, 0.3, 1000)}) {
    const Solved s = solved(m);
    const mechanics::System system{.model = s.model, .layout = s.laid_out, .coordinate = 0};
    mechanics::Configuration c = s.c;
    for (machine::Pose& p : c.bodies) p.position += Vector3(0.02, 0, -0.05);
    mechanics::Evaluation e;
    const Iteration i = newton(system, c, e, 1e-10, 60);
    EXPECT_TRUE(i.converged);
    EXPECT_LE(i.steps, 12);
    EXPECT_LT(apart(c, s.c), 1e-6);
    EXPECT_LT(mechanics::misfit(system, e).force, 1e-9 * e.largest_force);
  }
}

TEST(Newton, StandsStillAtTheAnswer) {
  const Solved s = solved(with_carriage(true));
  const mechanics::System system{.model = s.model, .layout = s.laid_out, .coordinate = 0};
  mechanics::Configuration c = s.c;
  mechanics::Evaluation e;
  const Iteration i = newton(system, c, e, 1e-9, 60);
  EXPECT_TRUE(i.converged);
  EXPECT_LE(i.steps, 2);
}

TEST(Newton, SaysWhatIsNotHeld) {
  machine::Model m = tackle(4, 1, 3000);
  m.bodies.push_back(body("loose", {3, 0, 0}, 10, "z"));
  const machine::State state = machine::initial_state(m);
  const mechanics::Layout l = mechanics::layout(m, state, {}, no_flow(m));
  const mechanics::System system{.model = m, .layout = l, .coordinate = 0};
  mechanics::Configuration c = mechanics::configuration_of(l, state);
  mechanics::Evaluation e;
  const Iteration i = newton(system, c, e, 1e-10, 60);
  EXPECT_FALSE(i.converged);
  EXPECT_TRUE(i.singular);
}

TEST(Relax, FallsToTheSameEquilibriumFromFarAway) {
  const Solved s = solved(tackle(4, 1, 3000));
  const mechanics::System system{.model = s.model, .layout = s.laid_out, .coordinate = 0};
  machine::Model above = s.model;
  above.bodies[0].position.z() += 3;  // all falls slack
  mechanics::Configuration c = mechanics::configuration_of(s.laid_out, machine::initial_state(above));
  mechanics::Evaluation e;
  EXPECT_TRUE(relax(system, c, e, 400, 10, 0.01).converged);
  EXPECT_LT(mechanics::misfit(system, e).force, 1e-3 * e.largest_force);
  EXPECT_TRUE(newton(system, c, e, 1e-10, 60).converged);
  EXPECT_LT(apart(c, s.c), 1e-6);
}

}  // namespace taut::solve::newton_test
