#include "taut/methods/mast_section/mast_section.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "taut/math/degree.hpp"
#include "taut/methods/mast_section/position.hpp"

namespace taut::mast_section::mast_section_test {

rc::Gen<double> between(double low, double high) {
  return rc::gen::map(rc::gen::inRange(0, 1000001), [=](int i) { return low + (high - low) * i * 1e-6; });
}

Input random_input() {
  Input in;
  in.skyline_force = *between(1e3, 500e3);
  in.mainline_force = *between(0, 200e3);
  in.skyline_block_height = *between(0.5, 25);
  if (*rc::gen::arbitrary<bool>()) in.mainline_block_height = *between(0.5, 25);
  in.block_friction = *between(0, 0.5);
  in.wrap = *rc::gen::element(Wrap::geometric, Wrap::paper);
  in.branch_angle = *between(-60 * degree, 85 * degree);
  in.allowable_stress = *between(50e6, 500e6);
  in.tube_ratio = *between(0, 0.98);
  return in;
}

Input random_span_input() {
  Input in = random_input();
  in.branch_angle.reset();
  Span span;
  span.length = *between(50, 800);
  span.chord_slope = *between(-40 * degree, 40 * degree);
  span.rope_weight = *between(2, 40);
  span.load = *between(0, 60e3);
  span.horizontal_tension = *between(20e3, 300e3);
  const int count = *rc::gen::inRange(1, 9);
  for (int i = 0; i < count; ++i) span.carriage_position.push_back(*between(0.01, 1) * span.length);
  in.span = span;
  return in;
}

Output solved(const Input& in) {
  Output out;
  RC_ASSERT(solve(in, out).ok());
  return out;
}

TEST(MastSection, EveryFieldIsDescribedOnce) {
  for (const Description* d :
       {&Input::describe(), &Output::describe(), &Span::describe(), &ChooseSection::describe()}) {
    auto keys = d->keys();
    std::sort(keys.begin(), keys.end());
    EXPECT_EQ(std::adjacent_find(keys.begin(), keys.end()), keys.end());
  }
}

RC_GTEST_PROP(MastSection, DoubleAndNumAgreeToTheLastBit, ()) {
  const Input in = *rc::gen::arbitrary<bool>() ? random_input() : random_span_input();
  Output plain, traced;
  Sheet<Num> s(about().short_source, Input::describe(), &in);
  const Outcome a = solve(in, plain), b = compute(in, s, traced);
  RC_ASSERT(a.status == b.status);
  const auto x = values_of(Output::describe(), &plain), y = values_of(Output::describe(), &traced);
  RC_ASSERT(x.size() == y.size());
  for (std::size_t i = 0; i < x.size(); ++i) RC_ASSERT(x[i].value == y[i].value);
}

RC_GTEST_PROP(MastSection, ForcesAndStressScaledTogetherLeaveTheSizes, ()) {
  const Input in = random_input();
  const double k = *between(0.1, 10);
  Input scaled = in;
  scaled.skyline_force *= k;
  scaled.mainline_force *= k;
  *scaled.allowable_stress *= k;
  const Output a = solved(in), b = solved(scaled);
  RC_ASSERT(std::abs(b.D_tube / a.D_tube - 1) < 1e-12);
  RC_ASSERT(std::abs(b.b_square / a.b_square - 1) < 1e-12);
  RC_ASSERT(std::abs(b.N / a.N / k - 1) < 1e-12);
}

RC_GTEST_PROP(MastSection, LengthsScaledLikeTheRootOfForcesScaleTheSizes, ()) {
  const Input in = random_input();
  const double k = *between(0.1, 10);
  Input scaled = in;
  scaled.skyline_block_height *= k;
  if (scaled.mainline_block_height) *scaled.mainline_block_height *= k;
  scaled.skyline_force *= k * k;
  scaled.mainline_force *= k * k;
  const Output a = solved(in), b = solved(scaled);
  RC_ASSERT(std::abs(b.D_tube / a.D_tube / k - 1) < 1e-12);
  RC_ASSERT(std::abs(b.B_hollow / a.B_hollow / k - 1) < 1e-12);
}

RC_GTEST_PROP(MastSection, RopesMayBeSwapped, ()) {
  Input in = random_input();
  in.mainline_force += 1;
  in.mainline_block_height = *between(0.5, 25);
  Input swapped = in;
  std::swap(swapped.skyline_force, swapped.mainline_force);
  std::swap(swapped.skyline_block_height, *swapped.mainline_block_height);
  const Output a = solved(in), b = solved(swapped);
  RC_ASSERT(std::abs(b.M / a.M - 1) < 1e-12);
  RC_ASSERT(std::abs(b.N / a.N - 1) < 1e-12);
  RC_ASSERT(std::abs(b.D_tube / a.D_tube - 1) < 1e-12);
}

RC_GTEST_PROP(MastSection, StressInEachSizeIsTheAllowableOne, ()) {
  const Input in = random_input();
  const Output o = solved(in);
  const double sigma = *in.allowable_stress, c = in.tube_ratio, pi = std::numbers::pi, b = o.b_square, B = o.B_hollow,
               D = o.D_tube;
  RC_ASSERT(std::abs((o.N / (b * b) + 6 * o.M / (b * b * b)) / sigma - 1) < 1e-10);
  RC_ASSERT(std::abs((o.N / (0.75 * B * B) + o.M / (1.25 * B * B * B / 8)) / sigma - 1) < 1e-10);
  const double area = pi * D * D * (1 - c * c) / 4, W = pi * D * D * D * (1 - std::pow(c, 4)) / 32;
  RC_ASSERT(std::abs((o.N / area + o.M / W) / sigma - 1) < 1e-10);
}

RC_GTEST_PROP(MastSection, LawOfCosinesAgreesWithVectors, ()) {
  const Input in = random_input();
  const Output o = solved(in);
  const double x = o.F_span_sky * std::cos(o.alpha), y = o.F_span_sky * std::sin(o.alpha) + in.skyline_force;
  RC_ASSERT(std::abs(std::hypot(x, y) - o.R_sky) < 1e-9 * in.skyline_force);
  RC_ASSERT(std::abs(o.N - (o.F_span_sky + o.F_span_main) * std::sin(o.alpha) - in.skyline_force - in.mainline_force) <
            1e-9 * in.skyline_force);
  RC_ASSERT(o.N > 0);
  RC_ASSERT(o.M > 0);
}

RC_GTEST_PROP(MastSection, MoreForceNeedsMore, ()) {
  const Input in = random_input();
  Input more = in;
  more.mainline_force += *between(1, 1e5);
  const Output a = solved(in), b = solved(more);
  RC_ASSERT(b.D_tube > a.D_tube);
  RC_ASSERT(b.b_square > a.b_square);
  Input higher = in;
  higher.skyline_block_height *= 1.1;
  RC_ASSERT(solved(higher).D_tube > a.D_tube);
}

RC_GTEST_PROP(MastSection, OrderOfPositionsDoesNotCount, ()) {
  const Input in = random_span_input();
  Input reversed = in;
  std::reverse(reversed.span->carriage_position.begin(), reversed.span->carriage_position.end());
  Output a, b;
  RC_ASSERT(solve(in, a).ok() == solve(reversed, b).ok());
  if (!std::isnan(a.D_tube)) RC_ASSERT(a.D_tube == b.D_tube && a.b_square == b.b_square && a.B_hollow == b.B_hollow);
}

TEST(MastSection, NoFrictionGivesTheIsoscelesTriangle) {
  Input in;
  in.skyline_force = 50e3;
  in.mainline_force = 0;
  in.skyline_block_height = 6;
  in.allowable_stress = 160e6;
  in.block_friction = 0;
  in.branch_angle = 20 * degree;
  Output out;
  ASSERT_TRUE(solve(in, out).ok());
  EXPECT_NEAR(out.R_sky, 2 * 50e3 * std::cos(35 * degree), 1e-6);  // bisector of the 70 degrees between the branches
  EXPECT_NEAR(out.gamma_sky, 55 * degree, 1e-12);
  EXPECT_EQ(out.R_main, 0);
}

TEST(MastSection, HigherBlockBelowTheLowerOne) {
  Input in;
  in.skyline_force = 50e3;
  in.mainline_force = 30e3;
  in.skyline_block_height = 5;
  in.mainline_block_height = 9;
  in.allowable_stress = 160e6;
  in.block_friction = 0;
  in.branch_angle = 0;
  Output out;
  ASSERT_TRUE(solve(in, out).ok());
  EXPECT_NEAR(out.M, 50e3 * 5 + 30e3 * 9, 1e-6);
  EXPECT_NEAR(out.N, 80e3, 1e-6);
  EXPECT_NEAR(out.Q, 80e3, 1e-6);
}

}  // namespace taut::mast_section::mast_section_test
