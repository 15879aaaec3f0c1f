#include "taut/machine/compile/path.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "taut/machine/compile.hpp"
#include "test/support/complaints.hpp"
#include "test/support/described.hpp"

namespace taut::machine::path_test {

using namespace described;
using taut_test::complaints_of;

/// A rope that comes back beside itself: from the mast to a carriage, round the tail block, and back to the carriage.
Machine running(double towards, double axis) {
  Machine m = line();
  m.points[0].at = {0, 0, 10};
  m.supports.clear();
  description::Round tail;
  tail.name = "tail_block";
  tail.at = {100 * towards, 0, 30};
  tail.diameter = 0.4;
  tail.axis = {0, axis, 0};
  m.sheaves = {tail};
  m.reevings[0].path = {anchor("head"), through("car"), over("tail_block"), anchor("car")};
  return m;
}

TEST(Sides, TheBranchWithTheCarriageIsTheUpperOne) {
  for (const double towards : {1.0, -1.0}) {
    for (const double axis : {1.0, -1.0}) {
      Machine m = running(towards, axis);
      ASSERT_TRUE(compile(m)) << complaints_of(m);
      // above the centre on the arriving branch: d x axis side points upwards
      EXPECT_EQ(compile(m)->reevings[0].nodes[2].side, towards * axis > 0 ? 1 : -1);
      std::reverse(m.reevings[0].path.begin(), m.reevings[0].path.end());
      EXPECT_EQ(compile(m)->reevings[0].nodes[1].side, towards * axis > 0 ? -1 : 1);
      m.reevings[0].path = {anchor("head"), over("tail_block"), anchor("head")};
      m.carriages.clear();
      m.reevings[1].path[1] = anchor("tail");
      ASSERT_TRUE(compile(m)) << complaints_of(m);
      EXPECT_EQ(compile(m)->reevings[0].nodes[1].side, towards * axis > 0 ? 1 : -1) << "arrives above";
    }
  }
}

TEST(Sides, ASmallBendTurnsATackleWhereNothingElseDoes) {
  for (const double lead : {0.15, -0.15}) {
    for (const double axis : {1.0, -1.0}) {
      Machine m = tackle(4, {anchor("lead"), falls(4, "head", "block"), anchor("pin")});
      m.points[0].at = {lead, 0, 0};
      m.points[1].at = {0, 0, 9.5};
      for (auto& sheave : m.sheaves) sheave.axis = {0, axis, 0};
      ASSERT_TRUE(compile(m)) << complaints_of(m);
      const bool from_left = lead < 0;
      const bool along_y = axis > 0;
      const bool clockwise = from_left == along_y;
      for (std::size_t i = 1; i <= 4; ++i) {
        // from the left over the top to the right: clockwise, seen with x to the right: positive about +y
        EXPECT_EQ(compile(m)->reevings[0].nodes[i].side, clockwise ? 1 : -1) << lead << " " << axis;
      }
    }
  }
}

}  // namespace taut::machine::path_test
