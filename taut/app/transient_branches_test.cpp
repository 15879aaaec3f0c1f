#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "taut/app/job.hpp"

// Branches that sag, from decks.
namespace transient_branches_test {

using namespace taut;

std::string span_deck(const std::string& analyses) {
  return fmt::format(R"(taut: 1
machine:
  points: {{head: [0 m, 0 m, 30 m], tail: [220 m, 0 m, 70 m]}}
  ropes: {{skyline: {{mass: 2 kg/m, stiffness: 20 MN}}}}
  carriages: {{car: {{mass: 900 kg, rides: skyline, hold: clamped, length_before: 104 m}}}}
  reevings: [{{rope: skyline, path: [{{anchor: head}}, {{through: car}}, {{anchor: tail}}], length: 228 m}}]
analyses: {}
)",
                     analyses);
}

Result run(const std::string& analyses) {
  return app::run(app::Job{.text = span_deck(analyses), .name = "deck.yaml", .set = {}});
}

double value(const Result& r, const std::string& name) {
  for (const auto& v : r.values) {
    if (v.name == name) return v.value;
  }
  return NAN;
}

double span_column(const Result& r, const std::string& column, std::size_t row) {
  for (const Table& t : r.tables) {
    for (std::size_t i = 0; t.name == "spans" && i < t.columns.size(); ++i) {
      if (t.columns[i].name == column) return std::get<double>(t.rows[row][i]);
    }
  }
  return NAN;
}

TEST(TransientBranches, ASettledMotionStaysAtTheEquilibrium) {
  const Result rest = run("[equilibrium: {motion: at_rest}]");
  const Result r = run("[transient: {duration: 1 s, branches: catenary}]");
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_NEAR(value(r, "skyline.T_start_min") / span_column(rest, "T_from", 0), 1, 1e-9);
  EXPECT_NEAR(value(r, "skyline.T_start_max") / span_column(rest, "T_from", 0), 1, 1e-9);
  EXPECT_NEAR(value(r, "skyline.T_end_end") / span_column(rest, "T_to", 1), 1, 1e-9);
  const Result straight = run("[transient: {duration: 1 s}]");
  EXPECT_GT(std::abs(value(straight, "skyline.T_end_end") / span_column(rest, "T_to", 1) - 1), 1e-4);
  const auto tells = [](const Result& of) {
    return std::any_of(of.assumptions.begin(), of.assumptions.end(), [](const std::string& words) {
      return words.find("hang as the catenary") != std::string::npos;
    });
  };
  EXPECT_TRUE(tells(r));
  EXPECT_FALSE(tells(straight));
}

TEST(TransientBranches, VibrationsOfASaggingSpan) {
  const Result r = run("[modes: {count: 2, branches: catenary}]");
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const Result straight = run("[modes: {count: 2, branches: straight}]");
  EXPECT_GT(value(r, "frequency_1"), 0.05);
  EXPECT_GT(std::abs(value(r, "frequency_1") / value(straight, "frequency_1") - 1), 1e-4);
}

TEST(TransientBranches, AnotherWordIsAMistakeAtItsPlace) {
  const Result r = run("[transient: {duration: 1 s, branches: catenaries}]");
  EXPECT_EQ(r.status, Status::bad_deck);
  ASSERT_FALSE(r.errors.empty());
  EXPECT_NE(to_text(r.errors).find("catenary"), std::string::npos) << to_text(r.errors);
}

}  // namespace transient_branches_test
