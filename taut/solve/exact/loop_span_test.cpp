#include "taut/solve/exact/loop_span.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace taut::solve::loop_span_test {

struct Given {
  double weight, stiffness, H, x, z;
};

const std::vector<Given> cases = {
    {.weight = 10, .stiffness = 1e7, .H = 4e4, .x = 100, .z = 30},
    {.weight = 10, .stiffness = std::numeric_limits<double>::infinity(), .H = 4e4, .x = 100, .z = -30},
    {.weight = 40, .stiffness = 2e6, .H = 3e3, .x = 150, .z = 80},
    {.weight = 0, .stiffness = 1e6, .H = 5e3, .x = 60, .z = -10},
    {.weight = 100, .stiffness = 5e5, .H = 2e3, .x = 90, .z = 0}};

TEST(LoopSpan, IsTheCatenaryOfItsLength) {
  for (const Given& g : cases) {
    const auto s = span_at_tension(g.weight, g.stiffness, g.H, g.x, g.z);
    ASSERT_TRUE(s.has_value());
    EXPECT_LT(s->closure, 1e-11 * g.x);
    if (std::isinf(g.stiffness)) continue;  // a taut one: the length fixes the tension to few digits only
    const auto c = rope::solve_catenary(s->rope, g.x, g.z);
    ASSERT_TRUE(c.has_value());
    EXPECT_NEAR(c->force.H, g.H, 1e-8 * g.H);
    EXPECT_NEAR(c->force.V + g.weight * s->rope.length / 2, s->V_end, 1e-8 * s->T_end);
  }
}

TEST(LoopSpan, RatesAreTheDerivatives) {
  for (const Given& g : cases) {
    const LoopSpanRates r = rates_of(*span_at_tension(g.weight, g.stiffness, g.H, g.x, g.z));
    const auto expect = [&](double dH, double dx, double dz, double V_start, double V_end, double L) {
      const auto up = span_at_tension(g.weight, g.stiffness, g.H + dH, g.x + dx, g.z + dz);
      const auto down = span_at_tension(g.weight, g.stiffness, g.H - dH, g.x - dx, g.z - dz);
      const double h = 2 * (dH + dx + dz);
      const double size = std::abs(V_start) + std::abs(V_end) + 1e-3;
      EXPECT_NEAR((up->V_start - down->V_start) / h, V_start, 1e-5 * size);
      EXPECT_NEAR((up->V_end - down->V_end) / h, V_end, 1e-5 * size);
      EXPECT_NEAR((up->rope.length - down->rope.length) / h, L, 1e-5 * (std::abs(L) + 1e-4));
    };
    expect(1e-3 * g.H, 0, 0, r.V_start_H, r.V_end_H, r.L_H);
    expect(0, 1e-3, 0, r.V_start_x, r.V_end_x, r.L_x);
    expect(0, 0, 1e-3, r.V_start_z, r.V_end_z, r.L_z);
  }
}

TEST(LoopSpan, NoneWithoutTensionOrBackwards) {
  EXPECT_FALSE(span_at_tension(10, 1e7, 1e-3, 100, 0).has_value());
  EXPECT_FALSE(span_at_tension(10, 1e7, 1e4, -1, 0).has_value());
  EXPECT_FALSE(span_at_tension(10, 1e7, 0, 100, 0).has_value());
}

}  // namespace taut::solve::loop_span_test
