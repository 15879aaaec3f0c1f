#include "taut/solve/rest/far_loop.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "test/support/configured.hpp"
#include "test/support/machines.hpp"

/// The bound of ten times the way, from both sides, and whose rope it speaks of: lengths set by hand.
namespace taut::solve::far_loop_test {

/// A carriage on a skyline at x = 150 m by its mainline; each rope is as long as its chords times a factor.
std::string reported(std::optional<machine::Prescribed> prescribed, double mainline, double skyline) {
  const machine::Model m = taut_test::with_carriage(true);
  const machine::State state = machine::initial_state(m);
  const mechanics::Layout layout = mechanics::layout(m, state, prescribed, taut_test::no_flow(m));
  mechanics::Configuration c = mechanics::configuration_of(layout, state);
  mechanics::Evaluation e;
  e.branches.resize(layout.branches.size());
  for (std::size_t k = 0; k < layout.branches.size(); ++k) {
    e.branches[k].chord = {30.0, -40.0, 10.0 * static_cast<double>(k)};
    c.branches[k].length = (layout.branches[k].reeving == 1 ? mainline : skyline) * e.branches[k].chord.norm();
  }
  const Outcome found = no_far_loop({.model = m, .layout = layout, .coordinate = prescribed ? prescribed->x : 0}, c, e);
  EXPECT_EQ(found.status, found.message.empty() ? Status::ok : Status::infeasible);
  return found.message;
}

TEST(FarLoop, TheRopeThatPutsTheCarriageMayBeTenTimesItsWay) {
  const machine::Prescribed at{.carriage = 0, .x = 150};
  EXPECT_EQ(reported(at, 1, 1), "");
  EXPECT_EQ(reported(at, 9.999, 1), "");
  const std::string message = reported(at, 10.001, 1);
  EXPECT_NE(message.find("'mainline'"), std::string::npos) << message;
  // its one branch is the fifth: 10.001 times the length of (30, -40, 40)
  EXPECT_NE(message.find(fmt::format("{:.4g} m", 10.001 * std::hypot(50, 40))), std::string::npos) << message;
}

TEST(FarLoop, OfOtherRopesItSaysNothing) {
  EXPECT_EQ(reported(machine::Prescribed{0, 150}, 1, 50), "");  // the length of the skyline is given
  EXPECT_EQ(reported(std::nullopt, 50, 50), "");                // both are
}

}  // namespace taut::solve::far_loop_test
