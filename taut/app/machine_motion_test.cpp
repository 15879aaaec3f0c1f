#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "taut/app/job.hpp"

// The words of the motion, from decks: which side of a contact is the tight one, whatever the order of the path.
namespace machine_motion_test {

using namespace taut;

struct Row {
  double T_in = 0, T_out = 0, T_in_min = 0, T_in_max = 0, T_out_min = 0, T_out_max = 0, wrap = 0;
  std::string state;
};

/// A weight on a rope over a saddle or sheave and down to a drum; `swapped`: the path from the weight's end.
Row over(const std::string& round, const std::string& motion, bool swapped, bool mirrored = false) {
  const std::string there = "[{drum: winch}, {over: jack}, {anchor: hook}]";
  const std::string back = "[{anchor: hook}, {over: jack}, {drum: winch}]";
  const std::string deck = fmt::format(R"(taut: 1
machine:
  ropes: {{line: {{mass: 0 kg/m, stiffness: 20 MN}}}}
  bodies: {{hook: {{mass: 1 t, at: [{} m, 0 m, 2 m], free: [x, z]}}}}
  supports: {{jack: {{at: [0 m, 0 m, 12 m], diameter: 600 mm, uplift: hold, {}}}}}
  drums: {{winch: {{at: [{} m, 0 m, 1 m], core_diameter: 300 mm}}}}
  reevings: [{{rope: line, path: {}, length: 28 m}}]
analyses: [equilibrium: {{motion: {}}}]
)",
                                       mirrored ? -0.3 : 0.3, round, mirrored ? 9 : -9, swapped ? back : there, motion);
  const Result r = app::run(app::Job{.text = deck, .name = "deck.yaml", .set = {}});
  EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  Row row;
  for (const Table& t : r.tables) {
    if (t.name != "sheaves" || t.rows.empty()) continue;
    const auto read = [&](const char* column, double& to) {
      for (std::size_t i = 0; i < t.columns.size(); ++i) {
        if (t.columns[i].name == column) to = std::get<double>(t.rows[0][i]);
      }
    };
    read("T_in", row.T_in);
    read("T_out", row.T_out);
    read("T_in_min", row.T_in_min);
    read("T_in_max", row.T_in_max);
    read("T_out_min", row.T_out_min);
    read("T_out_max", row.T_out_max);
    read("wrap", row.wrap);
    for (std::size_t i = 0; i < t.columns.size(); ++i) {
      if (t.columns[i].name == "state") row.state = std::get<std::string>(t.rows[0][i]);
    }
  }
  if (swapped) {  // as if the path ran from the drum
    std::swap(row.T_in, row.T_out);
    std::swap(row.T_in_min, row.T_out_min);
    std::swap(row.T_in_max, row.T_out_max);
  }
  return row;
}

constexpr const char* saddle = "friction: 0.12";
constexpr const char* sheave = "law: sheave, efficiency: 0.95";
constexpr double weight = 1000 * 9.80665;

TEST(MachineMotion, ASaddlesTightSideIsTheDrumsWhenHaulingInHoweverThePathRuns) {
  for (const char* word : {"hoist", "in", "lower", "out"}) {
    const bool in = word == std::string("hoist") || word == std::string("in");
    for (const bool swapped : {false, true}) {
      for (const bool mirrored : {false, true}) {
        const Row row = over(saddle, word, swapped, mirrored);
        EXPECT_NEAR(row.T_out, weight, 1e-6 * weight) << "the weight hangs at the other side";
        EXPECT_NEAR(row.T_in, weight * std::exp((in ? 0.12 : -0.12) * row.wrap), 1e-6 * weight) << word << swapped;
        EXPECT_EQ(row.state, "slipping");
      }
    }
  }
}

TEST(MachineMotion, ASheaveLosesItsEfficiencyTheSameWay) {
  for (const bool swapped : {false, true}) {
    EXPECT_NEAR(over(sheave, "hoist", swapped).T_in, weight / 0.95, 1e-6 * weight);
    EXPECT_NEAR(over(sheave, "lower", swapped).T_in, weight * 0.95, 1e-6 * weight);
    EXPECT_EQ(over(sheave, "hoist", swapped).state, "turning");
  }
}

TEST(MachineMotion, AtRestACapstanHoldsTheBandBetweenBoth) {
  for (const bool swapped : {false, true}) {
    const Row row = over(saddle, "at_rest", swapped);
    EXPECT_EQ(row.state, "stuck");
    EXPECT_NEAR(row.T_in, weight, 1e-6 * weight);
    EXPECT_NEAR(row.T_in_max, weight * std::exp(0.12 * row.wrap), 1e-4 * weight);
    EXPECT_NEAR(row.T_in_min, weight * std::exp(-0.12 * row.wrap), 1e-4 * weight);
    EXPECT_NEAR(row.T_out_min, weight, 1e-6 * weight);
    EXPECT_NEAR(row.T_out_max, weight, 1e-6 * weight);
  }
}

TEST(MachineMotion, ASignIsByThePath) {
  // 1: the rope runs from the path's first element to its last, so that the tension grows that way
  EXPECT_GT(over(saddle, "{jack: -1}", false).T_in, weight) << "to the drum, which comes first";
  EXPECT_LT(over(saddle, "{jack: 1}", false).T_in, weight);
  EXPECT_GT(over(saddle, "{jack: 1}", true).T_in, weight) << "the drum comes last";
}

}  // namespace machine_motion_test
