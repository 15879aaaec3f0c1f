#include "taut/mechanics/arc_length.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace taut::mechanics::arc_length_test {

const double never = std::numeric_limits<double>::infinity();

/// ds/(1 + T/EA) along the arc, by Simpson's rule: at rest on the round where the rope comes on, slipping where it
/// goes.
double summed(const Arc& a) {
  const double T_e = a.flow > 0 ? a.T_in : a.T_out, T_x = a.flow > 0 ? a.T_out : a.T_in;
  const double slips = std::min(a.wrap, std::abs(std::log(T_x / T_e)) / a.friction);
  const double mu = slips > 0 ? std::log(T_x / T_e) / slips : 0;
  double sum = 0;
  const int n = 2000;
  for (int i = 0; i <= n; ++i) {
    const double T = T_e * std::exp(mu * slips * i / n);
    sum += (i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2) / (1 + T / a.stiffness);
  }
  return a.radius * ((a.wrap - slips) / (1 + T_e / a.stiffness) + slips * sum / (3 * n));
}

std::vector<Arc> arcs() {
  std::vector<Arc> all;
  for (const int flow : {1, -1}) {
    for (const double friction : {0.08, 0.3, 0.8}) {
      for (const double ratio : {0.3, 0.9, 1.2, 4.0})
        all.push_back({0.4, 2.9, 20e3, 20e3 * ratio, 2e6, friction, flow});
    }
  }
  return all;
}

TEST(ArcLength, IsTheSumOverTheArc) {
  for (const Arc& a : arcs()) {
    // a saddle's ratio fits its wrap; a ratio beyond it is only met on the way to an answer
    EXPECT_NEAR(arc_length(a).length, summed(a), 1e-12) << a.friction << " " << a.T_out / a.T_in << " " << a.flow;
  }
}

TEST(ArcLength, ARopeThatDoesNotSlipKeepsTheTensionItCameWith) {
  const Arc a{.radius = 0.4, .wrap = 3, .T_in = 20e3, .T_out = 22e3, .stiffness = 2e6, .friction = never, .flow = 1};
  EXPECT_NEAR(arc_length(a).length, 1.2 / (1 + 20e3 / 2e6), 1e-15);
  Arc back = a;
  back.flow = -1;
  EXPECT_NEAR(arc_length(back).length, 1.2 / (1 + 22e3 / 2e6), 1e-15);
}

TEST(ArcLength, AtRestTheMeanAndWithoutStretchTheArc) {
  EXPECT_NEAR(arc_length({0.4, 3, 20e3, 22e3, 2e6, 0.3, 0}).length, 1.2 / (1 + 21e3 / 2e6), 1e-15);
  EXPECT_NEAR(arc_length({0.4, 3, 20e3, 22e3, never, 0.3, 1}).length, 1.2, 1e-15);
  EXPECT_EQ(arc_length({0, 3, 20e3, 22e3, 2e6, 0.3, 1}).length, 0);
  EXPECT_NEAR(arc_length({0.4, 3, 20e3, -1, 2e6, 0.3, 1}).length, 1.2 / (1 + 9999.5 / 2e6), 1e-12);
}

TEST(ArcLength, TheSameAgainstThePath) {
  for (const Arc& a : arcs()) {
    Arc turned = a;
    std::swap(turned.T_in, turned.T_out);
    turned.flow = -a.flow;
    EXPECT_EQ(arc_length(turned).length, arc_length(a).length);
    EXPECT_EQ(arc_length(turned).by_in, arc_length(a).by_out);
  }
}

TEST(ArcLength, DerivativesAreThoseOfDifferences) {
  for (const Arc& a : arcs()) {
    const ArcLength l = arc_length(a);
    const auto slope = [&](double Arc::*member, double h) {
      Arc ahead = a, back = a;
      ahead.*member += h;
      back.*member -= h;
      return (arc_length(ahead).length - arc_length(back).length) / (2 * h);
    };
    const double scale = a.radius * a.wrap / a.stiffness;
    EXPECT_NEAR(slope(&Arc::T_in, 1), l.by_in, 1e-6 * scale) << a.friction << " " << a.T_out / a.T_in;
    EXPECT_NEAR(slope(&Arc::T_out, 1), l.by_out, 1e-6 * scale) << a.friction << " " << a.T_out / a.T_in;
    EXPECT_NEAR(slope(&Arc::wrap, 1e-5), l.by_wrap, 1e-8) << a.friction;
  }
}

}  // namespace taut::mechanics::arc_length_test
