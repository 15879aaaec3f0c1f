#include "taut/solve/rest/first_state.hpp"

#include <gtest/gtest.h>

#include "test/support/machines.hpp"

namespace taut::solve::first_state_test {

using namespace taut_test;

TEST(FirstState, WithoutAPlaceTheMachineAsDescribed) {
  const machine::Model m = with_carriage(true);
  const machine::State first = first_state(m, {}), described = machine::initial_state(m);
  EXPECT_EQ((first.bodies[0].position - described.bodies[0].position).norm(), 0);
  EXPECT_EQ(first.branches[0][0].length, described.branches[0][0].length);
}

TEST(FirstState, APrescribedCarriageIsOnTheLineBetweenItsNeighbours) {
  const machine::Model m = with_carriage(true);
  for (const double x : {95.0, 130.0, 195.0}) {
    EquilibriumOptions options;
    options.prescribed = machine::Prescribed{.carriage = 0, .x = x};
    const machine::State s = first_state(m, options);
    const Vector3& place = s.bodies[0].position;
    EXPECT_NEAR(place.x(), x, 1e-12);
    const double part = (x - 90) / 110;  // between the saddles
    EXPECT_NEAR(place.z(), 40 + 30 * part, 1e-9);
    EXPECT_NEAR(place.y(), 5 * part, 1e-9);
    // its mainline: neither slack by much nor stretched
    const double way = (Vector3(300, 0, 82) - place).norm();
    EXPECT_NEAR(s.branches[1][0].length / way, 1, 0.05) << x;
  }
}

TEST(FirstState, AlongAnotherDirectionItIsTheSameTurned) {
  const machine::Model m = with_carriage(true);
  EquilibriumOptions options;
  options.prescribed = machine::Prescribed{.carriage = 0, .x = 150};
  const machine::State straight = first_state(m, options);
  const double angle = 2.2;
  const Vector3 by(4, -9, 1), along(std::cos(angle), std::sin(angle), 0);
  options.prescribed = machine::Prescribed{.carriage = 0, .x = 150 + by.dot(along), .along = along};
  const machine::State other = first_state(turned(m, angle, by), options);
  EXPECT_NEAR(other.bodies[0].position.z(), straight.bodies[0].position.z() + 1, 1e-9);
  EXPECT_NEAR(other.branches[1][0].length, straight.branches[1][0].length, 1e-9);
}

}  // namespace taut::solve::first_state_test
