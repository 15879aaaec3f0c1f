#include "taut/methods/mast_section/figures.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace taut::mast_section::figures_test {

Input mast() {
  Input in;
  in.skyline_force = 100e3;
  in.mainline_force = 40e3;
  in.skyline_block_height = 8;
  in.mainline_block_height = 6;
  in.allowable_stress = 160e6;
  in.branch_angle = 0.2;
  return in;
}

Output solved(const Input& in) {
  Output out;
  EXPECT_TRUE(solve(in, out).ok());
  return out;
}

std::vector<ForceArrow> arrows(const Drawing& d) {
  std::vector<ForceArrow> all;
  for (const Shape& s : d.shapes) {
    if (const auto* a = std::get_if<ForceArrow>(&s)) all.push_back(*a);
  }
  return all;
}

TEST(MastSectionFigures, PolygonCloses) {
  for (const double angle : {-1.0, 0.0, 0.2, 1.4}) {
    Input in = mast();
    in.branch_angle = angle;
    const Output out = solved(in);
    const auto all = arrows(force_polygon(in, out));
    ASSERT_EQ(all.size(), 8u);
    double x = 0, y = 0;
    for (const ForceArrow& a : all) {
      if (a.role == Role::force) x += a.fx, y += a.fy;
    }
    EXPECT_NEAR(x, out.Q, 1e-6);
    EXPECT_NEAR(y, -out.N, 1e-6);
    EXPECT_NEAR(all[3].at.x, all[2].at.x + all[2].fx, 1e-6) << "the second triangle begins where the first ends";
  }
}

TEST(MastSectionFigures, ClampHoldsTheMast) {
  const Input in = mast();
  const Output out = solved(in);
  double x = 0, y = 0;
  for (const ForceArrow& a : arrows(mast_drawing(in, out))) {
    if (a.role == Role::force) continue;  // the branches are within the resultants
    x += a.fx, y += a.fy;
  }
  EXPECT_NEAR(x, 0, 1e-6);
  EXPECT_NEAR(y, 0, 1e-6);
}

TEST(MastSectionFigures, TheCaptionsSayWhichStateIsDrawn) {
  Input in = mast();
  Output out = solved(in);
  for (const Drawing& d : {mast_drawing(in, out), force_polygon(in, out)}) {
    EXPECT_TRUE(d.caption.starts_with("Ropes hauled in")) << d.caption;
    EXPECT_EQ(d.caption.find("carriage at"), std::string::npos) << d.caption;
  }
  out.x = 285;
  out.M_payout = 1.1 * out.M;
  EXPECT_TRUE(mast_drawing(in, out).caption.starts_with(
      "Ropes hauled in, carriage at 285 m. Ropes paid out, which are not drawn, bend the mast more. "));
}

TEST(MastSectionFigures, NothingLiesBelowTheGroundOrIsNotANumber) {
  for (const double angle : {-1.04, -0.3, 0.0, 0.5, 1.48}) {
    Input in = mast();
    in.branch_angle = angle;
    const Output out = solved(in);
    for (const Shape& s : mast_drawing(in, out).shapes) {
      const auto* line = std::get_if<Polyline>(&s);
      if (line == nullptr || line->role == Role::ground) continue;
      for (const Point& p : line->points) EXPECT_GE(p.y, -1e-9);
    }
  }
}

TEST(MastSectionFigures, MomentFallsFromTheClampToTheHead) {
  const Input in = mast();
  const Output out = solved(in);
  const Plot p = moment_plot(in, out);
  ASSERT_EQ(p.curves[0].x.size(), 4u);
  EXPECT_NEAR(p.curves[0].y.front(), out.M, 1e-6);
  EXPECT_NEAR(p.curves[0].y.back(), 0, 1e-6);
  EXPECT_NEAR(p.curves[0].y[1], out.R_sky * std::cos(out.gamma_sky) * 2, 1e-6) << "at the lower block";
}

TEST(MastSectionFigures, StressOfTheIdealTubeReachesTheLimitAtTheClamp) {
  const Input in = mast();
  const Output out = solved(in);
  const Plot p = stress_plot(in, out, std::nullopt);
  EXPECT_NEAR(p.curves[0].y.front(), 160e6, 1);
  ASSERT_EQ(p.marks.size(), 1u);
  EXPECT_EQ(p.marks[0].y, 160e6);
}

TEST(MastSectionFigures, AnglePlotHoldsTheCaseAtHand) {
  const Input in = mast();
  const Output out = solved(in);
  const Plot p = angle_plot(in, out);
  for (const Curve& c : p.curves) {
    ASSERT_EQ(c.x.size(), c.y.size());
    for (const double y : c.y) EXPECT_TRUE(std::isfinite(y));
  }
  EXPECT_EQ(p.marks[0].y, out.D_tube);
}

}  // namespace taut::mast_section::figures_test
