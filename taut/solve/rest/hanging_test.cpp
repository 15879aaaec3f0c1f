// Answers of the equations that no machine takes: hanging.hpp and far_loop.hpp.
#include "taut/solve/rest/hanging.hpp"

#include <gtest/gtest.h>

#include "taut/solve/equilibrium.hpp"
#include "taut/solve/rest/far_loop.hpp"
#include "test/support/configured.hpp"
#include "test/support/machines.hpp"

namespace taut::solve::hanging_test {

using namespace taut_test;

/// A machine evaluated in a state.
struct Evaluated {
  Evaluated(const machine::Model& m, const machine::State& state,
            const std::optional<machine::Prescribed>& prescribed = {})
      : model(m),
        laid_out(mechanics::layout(model, state, prescribed, no_flow(m))),
        system{.model = model, .layout = laid_out, .coordinate = 0},
        c(mechanics::configuration_of(laid_out, state)) {
    for (int i = 0; i < 4; ++i) EXPECT_FALSE(mechanics::evaluate(system, c, e));
  }
  machine::Model model;
  mechanics::Layout laid_out;
  mechanics::System system;
  mechanics::Configuration c;
  mechanics::Evaluation e;
};

TEST(Hanging, AnAnswerHangsBelowItsRope) {
  const machine::Model m = rollers(2, 0.8, 0.3, 1000);
  const EquilibriumResult r = equilibrium(m);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  const Evaluated at(m, r.state);
  EXPECT_TRUE(hanging(at.system, at.c, at.e).outcome.ok());
}

TEST(Hanging, TurnedOverItIsRefused) {
  const machine::Model m = rollers(2, 0.8, 0.3, 1000);
  machine::State over = equilibrium(m).state;
  over.bodies[0].orientation.col(0) *= -1;
  over.bodies[0].orientation.col(2) *= -1;  // half a turn about y
  const Evaluated at(m, over);
  const Hanging h = hanging(at.system, at.c, at.e);
  EXPECT_EQ(h.outcome.status, Status::infeasible);
  EXPECT_NE(h.outcome.message.find("'car' would turn over"), std::string::npos) << h.outcome.message;
}

TEST(Hanging, APullUpwardsLiftsItOff) {
  machine::Model m = rollers(1, 0, 0, 100);
  m.reevings[0].nodes[1].support = -Vector3::UnitZ();
  machine::State state = equilibrium(m).state;
  state.bodies[0].position.z() += 30;  // as if something had drawn it up: the rope pulls it down
  const Evaluated at(m, state);
  const Hanging h = hanging(at.system, at.c, at.e);
  EXPECT_TRUE(h.lifted);
  EXPECT_NE(h.outcome.message.find("'car' would lift off 'skyline'"), std::string::npos) << h.outcome.message;
}

TEST(FarLoop, AMainlineOfTenTimesItsWayIsNone) {
  const machine::Model m = with_carriage(true);
  EquilibriumOptions options;
  options.prescribed = machine::Prescribed{.carriage = 0, .x = 150};
  const EquilibriumResult r = equilibrium(m, options);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  const Evaluated at(m, r.state, options.prescribed);
  EXPECT_TRUE(no_far_loop(at.system, at.c, at.e).ok());
  machine::State far = r.state;
  far.branches[1][0] = {};
  far.branches[1][0].length = 20 * 155;
  const Evaluated loop(m, far, options.prescribed);
  EXPECT_EQ(no_far_loop(loop.system, loop.c, loop.e).status, Status::infeasible);
}

}  // namespace taut::solve::hanging_test
