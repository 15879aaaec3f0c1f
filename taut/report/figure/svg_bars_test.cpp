#include "taut/report/figure/svg_bars.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <regex>
#include <vector>

namespace svg_bars_test {

using namespace taut;
using namespace taut::report;

const double nan = std::numeric_limits<double>::quiet_NaN();

Bars forces(std::vector<Bars::Row> rows) {
  return {.name = "b",
          .title = "What moves T",
          .caption = "",
          .value = {.label = "T", .unit = si::N},
          .series = {"low", "high"},
          .rows = std::move(rows),
          .base = 10e3,
          .in_line = true};
}

Bars::Bar bar(double from, double to) { return {.from = from, .to = to, .low = nan, .high = nan}; }

/// Left edges and widths of the bars in the rows, without those of the legend.
std::vector<std::pair<double, double>> bars_in(const std::string& svg) {
  std::vector<std::pair<double, double>> all;
  const std::regex one("<rect class=\"bar\\d\" x=\"([\\d.]+)\" y=\"[\\d.]+\" width=\"([\\d.]+)\" height=\"11.0\"/>");
  for (std::sregex_iterator at(svg.begin(), svg.end(), one), end; at != end; ++at) {
    all.emplace_back(std::stod((*at)[1]), std::stod((*at)[2]));
  }
  return all;
}

TEST(SvgBars, BarsGoToBothSidesOfTheBaseToScale) {
  const auto all = bars_in(bars_svg(forces({{"mass", {bar(10e3, 8e3), bar(10e3, 14e3)}}}), Display{}));
  ASSERT_EQ(all.size(), 2U);
  EXPECT_NEAR(all[0].first + all[0].second, all[1].first, 0.11) << "they meet at the base";
  EXPECT_NEAR(all[1].second, 2 * all[0].second, 0.3) << "4 kN against 2 kN";
}

TEST(SvgBars, UnitNamesAndIntervalsAreThere) {
  Bars b = forces({{"mass", {{.from = 0, .to = 5e3, .low = 4e3, .high = 6e3}}}});
  b.base = 0;
  const std::string svg = bars_svg(b, Display{});
  EXPECT_NE(svg.find(" in kN"), std::string::npos);
  EXPECT_NE(svg.find(">mass<"), std::string::npos);
  EXPECT_NE(svg.find("class=\"interval\""), std::string::npos);
}

TEST(SvgBars, WhatHasNoNumberIsLeftOut) {
  const std::string svg = bars_svg(forces({{"a", {bar(10e3, nan), bar(10e3, 12e3)}}}), Display{});
  EXPECT_EQ(bars_in(svg).size(), 1U);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_NE(bars_svg(forces({{"a", {bar(10e3, nan)}}}), Display{}).find("No values"), std::string::npos);
  EXPECT_NE(bars_svg(forces({}), Display{}).find("No values"), std::string::npos);
}

TEST(SvgBars, OneValueForAllBarsHasAnAxisToo) {
  const std::string svg = bars_svg(forces({{"a", {bar(10e3, 10e3), bar(10e3, 10e3)}}}), Display{});
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_NE(svg.find("<svg"), std::string::npos);
}

}  // namespace svg_bars_test
