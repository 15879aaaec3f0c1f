#include "taut/study/line/bend_onto.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace taut::study::bend_onto_test {

constexpr double degree = M_PI / 180;

machine::Node point(const Vector3& support) {
  machine::Node node;
  node.kind = machine::NodeKind::contact;
  node.support = support;
  return node;
}

/// A direction that rises by `slope` towards `plan`, rad.
Vector3 towards(double plan, double slope) {
  return {std::cos(plan) * std::cos(slope), std::sin(plan) * std::cos(slope), std::sin(slope)};
}

TEST(BendOnto, OfAPointIsTheBendInUprightPlanes) {
  const machine::Node saddle = point(up());
  for (const double plan : {0.0, 0.4, -1.2, 2.9}) {
    for (const double turn : {0.0, 0.3, -1.0}) {
      const Vector3 in = 70e3 * towards(plan, 12 * degree), out = 50e3 * towards(plan + turn, 5 * degree);
      EXPECT_NEAR(bend_onto(saddle, 1, in, out), 7 * degree, 1e-12);
      EXPECT_NEAR(bend_onto(saddle, 1, -out, -in), 7 * degree, 1e-12) << "with its ends swapped";
      EXPECT_NEAR(bend_onto(saddle, 1, out, in), -7 * degree, 1e-12) << "lifts";
      EXPECT_NEAR(bend_onto(point(-up()), 1, out, in), 7 * degree, 1e-12) << "a carriage below its rope";
      EXPECT_NEAR(bend_onto(point(Vector3::Zero()), 1, in, out), 7 * degree, 1e-12) << "held both ways";
    }
  }
}

TEST(BendOnto, OfARoundOrAnUprightAxisIsTheWrap) {
  machine::Node round = point(up());
  round.radius = 0.2;
  EXPECT_EQ(bend_onto(round, 0.3, towards(0, 0.1), towards(0.5, 0)), 0.3);
  machine::Node aside = point(Vector3::Zero());
  aside.axis = up();
  EXPECT_EQ(bend_onto(aside, 0.5, towards(0, 0), towards(0.5, 0)), 0.5);
}

}  // namespace taut::study::bend_onto_test
