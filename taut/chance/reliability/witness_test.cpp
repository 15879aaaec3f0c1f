// FORM, SORM, importance sampling and distributions against OpenTURNS 1.20 (Debian's python3-openturns); its numbers
// are in test/witness/chance_numbers.csv, the cases stand in chance_numbers.py beside it, too.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>

#include "taut/chance/reliability/importance.hpp"
#include "taut/chance/standard_laws.hpp"
#include "test/paths.hpp"

namespace taut::chance::witness_test {

using Numbers = std::map<std::string, double>;

std::map<std::string, Numbers> stored() {
  std::ifstream file(taut_test::source_dir() / "test/witness/chance_numbers.csv");
  std::map<std::string, Numbers> all;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    std::string name;
    std::string key;
    std::string value;
    std::getline(cells, name, ',');
    std::getline(cells, key, ',');
    std::getline(cells, value, ',');
    all[name][key] = std::stod(value);
  }
  return all;
}

Correlation correlations(std::size_t inputs, const std::vector<CorrelatedPair>& pairs) {
  return *correlation(pairs, std::vector<std::string>(inputs, "x"));
}

struct Case {
  std::string name;
  Inputs inputs;
  std::function<double(const Point&)> output;
  double at_least = 0;
};

std::vector<Case> cases() {
  const std::vector<Distribution> standard(3, {Normal{}});
  return {
      {.name = "worked",
       .inputs = {.of = {{.law = Lognormal{.mean = 400, .sd = 16}},
                         {.law = Normal{.mean = 25, .sd = 3}},
                         {.law = Normal{.mean = 0.06, .sd = 0.004}},
                         {.law = Gumbel{.mode = 1.05, .scale = 0.03}}}},
       .output = [](const Point& x) { return x[0] / (x[3] * x[1] / (4 * x[2])); },
       .at_least = 3},
      {.name = "correlated",
       .inputs = {.of = {{.law = Lognormal{.mean = 100, .sd = 10}},
                         {.law = Normal{.mean = 50, .sd = 7}},
                         {.law = Weibull{.shape = 2.5, .scale = 12}}},
                  .correlation =
                      correlations(3, {{.first = 0, .second = 1, .r = -0.4}, {.first = 1, .second = 2, .r = 0.6}})},
       .output = [](const Point& x) { return x[0] - x[1] - x[2]; }},
      {.name = "curved",
       .inputs = {.of = standard},
       .output = [](const Point& x) { return 2 + 0.4 * x[1] * x[1] - 0.1 * x[2] * x[2] + 0.2 * x[1] * x[2] - x[0]; }},
      {.name = "two_points",
       .inputs = {.of = {{.law = Normal{}}, {.law = Normal{}}}},
       .output = [](const Point& x) { return (x[0] + 2.5) * (3 - x[0]) + 0.4 * x[1]; }},
      {.name = "rare",
       .inputs = {.of = {{.law = Lognormal{.mean = 10, .sd = 0.7}},
                         {.law = Normal{.mean = 5, .sd = 0.7}},
                         {.law = Uniform{.low = 0.9, .high = 1.1}}}},
       .output = [](const Point& x) { return x[0] - x[1] * x[2]; }},
      {.name = "gumbel",
       .inputs = {.of = {{.law = Normal{.mean = 20, .sd = 0.5}},
                         {.law = Gumbel{.mode = 5, .scale = 2}},
                         {.law = Normal{.mean = 1, .sd = 0.02}}}},
       .output = [](const Point& x) { return x[0] * x[2] - x[1]; }}};
}

TEST(Witness, form_sorm_and_importance_sampling) {
  const auto numbers = stored();
  for (const Case& c : cases()) {
    const Numbers& other = numbers.at(c.name);
    const LimitState state(c.inputs,
                           [&](std::span<const Point> points) {
                             std::vector<std::vector<double>> rows;
                             for (const Point& x : points) rows.push_back({c.output(x)});
                             return rows;
                           },
                           0, {.bound = Bound::at_least, .value = c.at_least});
    const Form f = form(state);
    ASSERT_EQ(f.status, FormStatus::found) << c.name << f.reason;
    // theirs in the order of their starts, ours the nearest first
    std::vector<std::pair<double, std::string>> points;
    for (std::size_t k = 0; other.contains("beta_" + std::to_string(k)); ++k) {
      points.emplace_back(other.at("beta_" + std::to_string(k)), std::to_string(k));
    }
    std::sort(points.begin(), points.end());
    ASSERT_EQ(f.points.size(), points.size()) << c.name;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const std::string& own = points[k].second;
      EXPECT_NEAR(f.points[k].beta, points[k].first, 2e-4) << c.name;
      EXPECT_NEAR(f.points[k].breitung / other.at("breitung_" + own), 1, 2e-3) << c.name;
      for (std::size_t i = 0; i < c.inputs.of.size(); ++i) {
        EXPECT_NEAR(f.points[k].values[i], other.at("design_" + own + "_" + std::to_string(i)),
                    5e-3 * sd(c.inputs.of[i]))
            << c.name << ' ' << i;
      }
    }
    const ImportanceSampling s = importance_sampling(state, f);
    ASSERT_EQ(s.status, ImportanceStatus::found) << c.name << s.reason;
    const double error = std::hypot(s.counted.standard_error, other.at("standard_error"));
    EXPECT_NEAR(s.counted.value, other.at("probability"), 4 * error) << c.name;
    EXPECT_LT(s.counted.variation, 0.03) << c.name;
    EXPECT_EQ(s.rests_on.empty(), s.counted.value > 1e-4) << c.name;
  }
}

TEST(Witness, distributions) {
  const std::map<std::string, Distribution> own{
      {"lognormal", {.law = Lognormal{.mean = 400, .sd = 16}}},
      {"gumbel", {.law = Gumbel{.mode = 1.5, .scale = 0.2}}},
      {"weibull", {.law = Weibull{.shape = 1.7, .scale = 3, .shift = 0.5}}},
      {"triangular", {.law = Triangular{.low = 1, .mode = 2, .high = 5}}},
      {"normal_cut", {.law = Normal{.mean = 20, .sd = 1.2}, .from = 18, .to = 25}},
      {"gumbel_cut", {.law = Gumbel{.mode = 1.5, .scale = 0.2}, .from = 1, .to = 2.5}}};
  const auto numbers = stored();
  for (const auto& [name, d] : own) {
    const double width = sd(d);
    int values = 0;
    for (const auto& [key, value] : numbers.at("law_" + name)) {
      if (key == "mean") {
        EXPECT_NEAR(mean(d), value, 1e-7 * width) << name;
      } else if (key == "sd") {
        EXPECT_NEAR(width, value, 1e-7 * width) << name;
      } else {
        ++values;
        EXPECT_NEAR(value_at_score(d, std::stod(key.substr(3))), value, 1e-8 * (std::abs(value) + width))
            << name << key;
      }
    }
    EXPECT_EQ(values, 7);
  }
}

}  // namespace taut::chance::witness_test
