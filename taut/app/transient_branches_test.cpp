#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "taut/app/job.hpp"
#include "taut/io/file_reader.hpp"

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

/// 99.98 m of rope with 3 kg/m between anchors 100 m apart: straight 30 MN (100/99.98 - 1) = 6.001 kN. With its sag
/// T = H (1 + (w l/H)^2/24 ...) stretches l by 0.2 mm/m less: H^3 - 6.001 kN H^2 = 30 MN (3 kN)^2/24, H = 24.6 kN.
Result taut_span(const std::string& transient, const std::string& more = "", const std::string& saved = "") {
  const std::string deck = fmt::format(R"(taut: 1
machine:
  gravity: 10 m/s^2
  points: {{a: [0 m, 0 m, 20 m], b: [100 m, 0 m, 20 m]}}
  ropes: {{r: {{mass: 3 kg/m, stiffness: 30 MN, breaking_force: 60 kN, diameter: 20 mm, damping_ratio: 0.1}}}}
  reevings: [{{name: line, rope: r, path: [{{anchor: a}}, {{anchor: b}}], length: 99.98 m}}]
{}
analyses: [{{transient: {{duration: 0.1 s, tolerance: 1e-3{}}}}}]
checks: {{ropes: {{r: {{safety_factor: 3}}}}}}
)",
                                       more, transient);
  return app::run(
      app::Job{.text = deck,
               .name = "deck.yaml",
               .set = {},
               .progress = {},
               .read = [&](const std::string&) -> tl::expected<std::string, io::Unreadable> { return saved; }});
}

std::string unmade_of(const Result& r) { return fmt::format("{}", fmt::join(r.unmade, "; ")); }

TEST(TransientBranches, AForceAlongARopeDoesNotHideItsSag) {
  const std::string load = "  rope_loads: [{name: cut, rope: line, between: [a, b], tangential: 2 kN, position: 0.5}]";
  for (const char* branches : {"straight", "by_weight", "catenary"}) {
    for (const char* more : {"", ", quasi_static: true"}) {
      const Result r = taut_span(fmt::format(", branches: {}{}", branches, more), load);
      ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
      EXPECT_EQ(unmade_of(r),
                "transient: 'line' begins straight with 6.001 kN; with its sag it has 24.63 kN: the force along it "
                "keeps it straight: give it 'segments'");
    }
  }
  // no statics has the place that is described
  const Result assembled = taut_span(", branches: catenary, start: assembled", load);
  EXPECT_EQ(unmade_of(assembled),
            "transient: 'line' is straight, though a free part of it weighs 50 % of its tension: the force along it "
            "keeps it straight: give it 'segments'");
}

TEST(TransientBranches, AMotionThatGoesOnTellsOfItsSagToo) {
  const Result first = taut_span(", save: state.json");
  ASSERT_EQ(first.attachments.size(), 1U);
  const std::string words =
      "transient: 'line' begins straight with 6.001 kN; with its sag it has 24.63 kN: use "
      "'branches: catenary'";
  EXPECT_EQ(unmade_of(first), words);
  const Result second = taut_span(", restart: state.json", "", first.attachments[0].text);
  ASSERT_EQ(second.status, Status::ok) << second.message << to_text(second.errors);
  EXPECT_EQ(unmade_of(second), words);
}

}  // namespace transient_branches_test
