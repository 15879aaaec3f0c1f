#include "taut/methods/friction_drive/figures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "taut/math/degree.hpp"
#include "taut/methods/friction_drive/saw_drive_test.hpp"

namespace taut::friction_drive::figures_test {

Output solved(const Input& in) {
  Output out;
  EXPECT_TRUE(solve(in, out).ok());
  return out;
}

TEST(FrictionDriveFigures, SheavesGiveTheWrap) {
  for (const double wrap : {145.0, 170.0, 180.0, 200.0, 230.0}) {
    Input in = saw_drive();
    in.wrap = wrap * degree;
    const Layout at = layout_of(in);
    EXPECT_TRUE(at.to_scale);
    EXPECT_NEAR(std::numbers::pi + 2 * std::asin((at.driving_radius - at.idler_radius) / at.distance), in.wrap, 1e-12);
    EXPECT_GT(at.idler_radius, 0.2 * at.driving_radius);
    EXPECT_GT(at.distance, at.driving_radius + at.idler_radius) << "they don't touch";
  }
  for (const double wrap : {60.0, 300.0, 720.0}) {
    Input in = saw_drive();
    in.wrap = wrap * degree;
    EXPECT_FALSE(layout_of(in).to_scale);
  }
}

TEST(FrictionDriveFigures, ArcEndsAtTheBranches) {
  const Input in = saw_drive();
  const Output out = solved(in);
  const Plot p = arc_plot(in, out);
  EXPECT_NEAR(p.curves[0].y.front(), out.T_2_no_slip, 1e-9);
  EXPECT_NEAR(p.curves[0].y.back(), out.T_1_no_slip, 1e-9);
  EXPECT_NEAR(p.curves[1].y.back(), out.P_tight, 1e-6);
  EXPECT_LT(p.curves[2].y.back(), out.T_1) << "the paper's drive slips";
}

TEST(FrictionDriveFigures, WorkingPointLiesOnTheCurves) {
  const Input in = saw_drive();
  const Output out = solved(in);
  for (const Plot& p : {friction_plot(in, out, Display()), speed_plot(in, out)}) {
    const Curve& c = p.curves[0];
    std::size_t i = 0;
    while (i + 2 < c.x.size() && c.x[i + 1] < p.marks[0].x) ++i;
    const double t = (p.marks[0].x - c.x[i]) / (c.x[i + 1] - c.x[i]);
    EXPECT_NEAR(c.y[i] + t * (c.y[i + 1] - c.y[i]), in.cutting_force, 0.002 * in.cutting_force) << p.name;
  }
}

TEST(FrictionDriveFigures, ScrewLosesItsGrip) {
  const Input in = saw_drive();
  const Output out = solved(in);
  const Plot p = speed_plot(in, out);
  ASSERT_EQ(p.marks.size(), 2u);
  EXPECT_NEAR(2 * in.rope_mass * p.marks[1].x * p.marks[1].x, out.takeup_no_slip, 1e-9);
  EXPECT_EQ(p.curves[1].y.back(), 0);
  EXPECT_GT(p.curves[1].y.front(), 0);
}

TEST(FrictionDriveFigures, MasslessRopeKeepsItsGrip) {
  Input in = saw_drive();
  in.rope_mass = 0;
  const Output out = solved(in);
  EXPECT_TRUE(std::isnan(out.speed_of_lost_grip));
  EXPECT_EQ(speed_plot(in, out).marks.size(), 1u);
}

}  // namespace taut::friction_drive::figures_test
