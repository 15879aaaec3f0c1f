#include "taut/mechanics/configuration.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "taut/math/index.hpp"
#include "test/support/configured.hpp"
#include "test/support/machines.hpp"

/// From a state to the unknowns and back, and starts whose branches have a shape.
namespace taut::mechanics::configuration_test {

struct Laid {
  machine::Model m = taut_test::with_carriage(true);
  machine::State state = machine::initial_state(m);
  Layout layout = mechanics::layout(m, state, {}, taut_test::no_flow(m));
  System system() const { return {.model = m, .layout = layout}; }
};

TEST(Configuration, ComesBackAsItWas) {
  Laid l;
  Configuration c = configuration_of(l.layout, l.state);
  ASSERT_EQ(c.branches.size(), l.layout.branches.size());
  for (std::size_t k = 0; k < c.branches.size(); ++k) c.branches[k].length = 100 + static_cast<double>(k);
  c.bodies.front().position = {1, 2, 3};
  machine::State other = l.state;
  keep(l.layout, c, other);
  EXPECT_EQ(other.bodies.front().position, Vector3(1, 2, 3));
  const Configuration again = configuration_of(l.layout, other);
  for (std::size_t k = 0; k < c.branches.size(); ++k) EXPECT_EQ(again.branches[k].length, c.branches[k].length);
}

TEST(Configuration, OnlyBranchesWithoutAShapeAreDrawnTaut) {
  Laid l;
  const Configuration as_it_is = configuration_of(l.layout, l.state);
  // a rope of no length at all has no shape between two places
  const Layout::Branch& first = l.layout.branches.front();
  l.state.branches[first.reeving][first.from].length = -1;
  const Configuration usable = usable_start(l.system(), l.state);
  const double straight = machine::straight_length(l.state, l.m.reevings[first.reeving].nodes[first.from],
                                                   l.m.reevings[first.reeving].nodes[first.to]);
  EXPECT_NEAR(usable.branches.front().length, 0.999 * straight, 1e-12 * straight);
  for (std::size_t k = 1; k < usable.branches.size(); ++k) {
    EXPECT_EQ(usable.branches[k].length, as_it_is.branches[k].length);
  }
  Evaluation e;
  Configuration c = usable;
  EXPECT_FALSE(evaluate(l.system(), c, e));
}

TEST(Configuration, RopesThatDoNotStretchAreNotDrawnTaut) {
  Laid l;
  l.m.reevings.front().stiffness = std::numeric_limits<double>::infinity();
  const Configuration as_it_is = configuration_of(l.layout, l.state), taut = taut_start(l.system(), l.state);
  for (std::size_t k = 0; k < taut.branches.size(); ++k) {
    const Layout::Branch& laid = l.layout.branches[k];
    const machine::Reeving& rope = l.m.reevings[laid.reeving];
    const double straight = machine::straight_length(l.state, rope.nodes[laid.from], rope.nodes[laid.to]);
    const double expected = laid.reeving == 0 ? as_it_is.branches[k].length : 0.999 * straight;
    EXPECT_NEAR(taut.branches[k].length, expected, 1e-12 * straight) << k;
  }
}

}  // namespace taut::mechanics::configuration_test
