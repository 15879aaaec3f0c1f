#include "taut/methods/closed_loop/drawing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "taut/units/display.hpp"
#include "test/cases/closed_loop_example.hpp"

namespace taut::closed_loop::drawing_test {

using namespace taut_test;

Output solved(const Input& in) {
  Output out;
  EXPECT_TRUE(solve(in, out).ok());
  return out;
}

template <class S>
std::vector<S> shapes_of(const Drawing& d) {
  std::vector<S> all;
  for (const Shape& shape : d.shapes) {
    if (const S* s = std::get_if<S>(&shape)) all.push_back(*s);
  }
  return all;
}

TEST(ClosedLoopDrawing, ThePolygonOfForcesCloses) {
  for (double alpha : {-20.0, 0.0, 20.0}) {
    Input in = example();
    in.slope = alpha * degree;
    in.carriage_weight = 900;
    const Output out = solved(in);
    double x = 0;
    double y = 0;
    const auto forces = shapes_of<ForceArrow>(force_polygon(in, out));
    EXPECT_EQ(forces.size(), 5U);
    for (const ForceArrow& f : forces) {
      EXPECT_NEAR(f.at.x, x, 1e-6);
      EXPECT_NEAR(f.at.y, y, 1e-6);
      x += f.fx;
      y += f.fy;
    }
    EXPECT_NEAR(x, 0, 1e-8 * out.T_lA);
    EXPECT_NEAR(y, 0, 1e-8 * out.T_lA);
  }
}

TEST(ClosedLoopDrawing, RopesEndAtSupportsAndCarriage) {
  Input in = example();
  in.slope = 10 * degree;
  in.branch_distance = 1.5;
  const Drawing d = loop_drawing(in, solved(in), Display());
  int ropes = 0;
  for (const Polyline& line : shapes_of<Polyline>(d)) {
    if (line.role != Role::second_rope) continue;
    ++ropes;
    EXPECT_NEAR(line.points.front().x, 0, 1e-12);
    EXPECT_NEAR(line.points.back().x, 100, 1e-12);
    EXPECT_NEAR(line.points.back().y, 100 * std::tan(10 * degree) - 10, 1e-9);
  }
  EXPECT_EQ(ropes, 1);
  EXPECT_GE(d.vertical_scale, 1);
}

TEST(ClosedLoopDrawing, ArrowsAreTheTensionsOfTheResult) {
  Input in = two_section_example();
  in.slope = -9 * degree;
  const Output out = solved(in);
  const std::map<std::string, double> wanted = {
      {"T_lA", out.T_lA}, {"T_uA", out.T_uA}, {"T_lB", out.T_lB}, {"T_uB", out.T_uB}, {"N", out.N}};
  std::size_t found = 0;
  for (const ForceArrow& f : shapes_of<ForceArrow>(loop_drawing(in, out, Display()))) {
    const auto at = wanted.find(f.label);
    if (at == wanted.end()) continue;
    ++found;
    EXPECT_NEAR(std::hypot(f.fx, f.fy), at->second, 1e-9 * at->second) << f.label;
  }
  EXPECT_EQ(found, wanted.size());
}

TEST(ClosedLoopDrawing, TensionsAreDrawnOverTheSpan) {
  const Input in = example();
  Ropes ropes;
  ASSERT_TRUE(ropes_of(in, ropes).ok());
  const auto rows = sweep(in, ropes);
  const Plot p = tension_plot(in, ropes, rows);
  ASSERT_EQ(p.curves.size(), 4U);
  EXPECT_GT(p.curves[0].x.size(), 30U);
  ASSERT_EQ(p.marks.size(), 1U);
  EXPECT_EQ(p.marks[0].y, rows[0].out.T_end_max);
}

TEST(ClosedLoopDrawing, ErrorsCrossZeroOnTheLevel) {
  const Input in = example();
  Ropes ropes;
  ASSERT_TRUE(ropes_of(in, ropes).ok());
  const Plot p = error_plot(in, ropes, solved(in));
  const std::size_t level = p.curves[0].y.size() / 2;
  EXPECT_NEAR(p.curves[0].x[level], 0, 1e-12);
  EXPECT_NEAR(p.curves[0].y[level], 0, 0.001);
  EXPECT_GT(p.curves[0].y.front(), 0.02);   // uphill (1) is too large
  EXPECT_LT(p.curves[2].y.front(), -0.02);  // and (9) unsafe
}

}  // namespace taut::closed_loop::drawing_test
