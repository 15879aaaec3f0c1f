#include "taut/methods/boom_ropes/drawing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "taut/methods/boom_ropes/printed_boom_test.hpp"

namespace taut::boom_ropes::drawing_test {

Input crane() {
  Input in = printed_boom();
  in.cases = {
      {.name = "lift", .operation = Operation::lift, .luffing_angle = 1.3, .suspended_weight = 100e3, .falls = 8}};
  in.sliding.emplace();
  in.sliding->boom_length = {21, 9, 15};
  in.sliding->luffing_angle = {0.5};
  in.sliding->suspended_weight = {20e3};
  return in;
}

const Drawing* drawing(const std::vector<Figure>& all, const std::string& name) {
  for (const Figure& f : all) {
    const auto* d = std::get_if<Drawing>(&f);
    if (d != nullptr && d->name == name) return d;
  }
  return nullptr;
}

std::vector<Figure> drawn(const Input& in) {
  Output out;
  EXPECT_TRUE(solve(in, out).ok());
  return figures(in, out, Display());
}

TEST(BoomDrawing, BoomReachesItsLength) {
  const auto all = drawn(crane());
  const Drawing* d = drawing(all, "boom");
  ASSERT_NE(d, nullptr);
  double reach = 0;
  for (const Shape& s : d->shapes) {
    const auto* line = std::get_if<Polyline>(&s);
    if (line == nullptr || !line->closed) continue;
    for (const Point& p : line->points) reach = std::max(reach, std::hypot(p.x, p.y));
  }
  EXPECT_NEAR(reach, 21, 0.05);
}

TEST(BoomDrawing, ForcesAlongSection3CloseAtZero) {
  const auto all = drawn(crane());
  for (const char* name : {"balance", "lowest_case"}) {
    const Drawing* d = drawing(all, name);
    ASSERT_NE(d, nullptr);
    double end = 1e9;
    for (const Shape& s : d->shapes) {
      const auto* arrow = std::get_if<ForceArrow>(&s);
      if (arrow != nullptr) end = arrow->at.x + arrow->fx;
    }
    EXPECT_NEAR(end, 0, 1e-3);
  }
}

TEST(BoomDrawing, PlotsRunWithTheBoomLength) {
  for (const Figure& f : drawn(crane())) {
    const auto* p = std::get_if<Plot>(&f);
    if (p == nullptr || p->name != "cylinder_force") continue;
    ASSERT_EQ(p->curves.size(), 1u);
    EXPECT_EQ(p->curves[0].x, (std::vector<double>{9, 15, 21}));
    return;
  }
  FAIL() << "no plot of the cylinder force";
}

TEST(BoomDrawing, StaticDeckHasItsOwnFigures) {
  Input in = crane();
  in.sliding.reset();
  const auto all = drawn(in);
  EXPECT_EQ(all.size(), 3u);
  EXPECT_EQ(drawing(all, "boom"), nullptr);
}

}  // namespace taut::boom_ropes::drawing_test
