#include "taut/machine/middle.hpp"

#include <gtest/gtest.h>

namespace taut::machine::middle_test {

Model between(const Vector3& from, const Vector3& to) {
  Model m;
  Reeving rope;
  rope.nodes.resize(3);
  rope.nodes[0].at = {ground, from};
  rope.nodes[1].at = {0, {0.1, 0.2, 0.3}};
  rope.nodes[2].at = {ground, to};
  m.reevings.push_back(rope);
  m.bodies.resize(1);
  m.bodies[0].position = (from + to) / 2;
  return m;
}

TEST(Middle, OfAMachineThatHoldsTheOriginIsNone) {
  EXPECT_EQ(far_middle(Model{}), Vector3::Zero());
  EXPECT_EQ(far_middle(between({0, 0, 42}, {190, 0, 2})), Vector3::Zero());
  EXPECT_EQ(far_middle(between({0, 0, 0.4}, {0, 0, 0.6})), Vector3::Zero());
}

TEST(Middle, IsCountedInWholeMetres) {
  const Model far = between({500000.25, 12, 3}, {500003.5, 14, 6});
  const Vector3 middle = far_middle(far);
  EXPECT_EQ(middle, Vector3(500002, 13, 5));
  const Model seen = counted_from(middle, far);
  EXPECT_EQ(seen.origin, middle);
  EXPECT_EQ(seen.reevings[0].nodes[0].at.at, Vector3(-1.75, -1, -2));
  EXPECT_EQ(seen.reevings[0].nodes[1].at.at, Vector3(0.1, 0.2, 0.3));  // on a body
  EXPECT_EQ(seen.bodies[0].position, Vector3(-0.125, 0, -0.5));
  EXPECT_EQ(far_middle(seen), Vector3::Zero());
}

}  // namespace taut::machine::middle_test
