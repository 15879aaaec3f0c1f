// Guides that hold a rope only ahead of the carriage: one deck against a deck for each span with its guides by hand.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include "test/paths.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::app::ahead_of_test {

using taut_test::cell;
using taut_test::run_text;
using taut_test::table_of;

/// A line over three spans. `span`: empty: guides with `holds`, the whole line; else that span, with its guides by
/// hand.
struct Line {
  bool mirrored = false;  ///< at x = 180 m, and the ropes' ends swapped
  std::optional<int> span = std::nullopt;
  std::string uplift = "lift";
  std::string mainline = "length: 192 m";
  double guide_aside = 0;  ///< of the guides from the jacks, towards the tower, m
};

std::string path_text(std::vector<std::string> path, bool backwards) {
  if (backwards) std::reverse(path.begin(), path.end());
  return fmt::format("[{}]", fmt::join(path, ", "));
}

std::string deck(const Line& line, const std::string& analyses) {
  const auto at = [&](double x, double z) { return fmt::format("[{} m, 0 m, {} m]", line.mirrored ? 360 - x : x, z); };
  const int span = line.span.value_or(1);
  std::vector<std::string> skyline = {"{anchor: stump}", "{over: jack1}", "{over: jack2}", "{anchor: tower}"};
  skyline.insert(skyline.begin() + 1 + span, "{through: car}");
  std::vector<std::string> mainline = {"{anchor: block}", "{over: guide2}", "{over: guide1}", "{anchor: car}"};
  if (line.span) mainline.erase(mainline.begin() + 3 - span, mainline.begin() + 3);
  std::string guides;
  for (const auto& [name, x, z] : {std::tuple{"guide1", 110.0, 32.0}, {"guide2", 240.0, 77.0}}) {
    guides += fmt::format("    {}: {{at: {}, diameter: 300 mm, efficiency: 0.98, uplift: {}{}}}\n", name,
                          at(x + line.guide_aside, z), line.uplift, line.span ? "" : ", holds: ahead_of car");
  }
  const auto rope = [&](const char* name, const std::vector<std::string>& path, const std::string& given) {
    return fmt::format("    - {{rope: {}, path: {}, {}, haul: {}}}\n", name, path_text(path, line.mirrored), given,
                       line.mirrored ? "to_end" : "to_start");
  };
  return fmt::format(R"(taut: 1
machine:
  temperature: 15 degC
  points: {{stump: {}, tower: {}, block: {}}}
  ropes:
    skyline: {{mass: 1.6 kg/m, stiffness: 20 MN, breaking_force: 280 kN}}
    mainline: {{mass: 0.54 kg/m, stiffness: 7 MN, breaking_force: 110 kN}}
  supports:
    jack1: {{at: {}, diameter: 400 mm, friction: 0.1}}
    jack2: {{at: {}, diameter: 400 mm, friction: 0.1}}
  sheaves:
{}  carriages:
    car: {{mass: 350 kg, rides: skyline, hold: rolling, mainline: mainline}}
  reevings:
{}{}  loads: [{{at: car, mass: 1.5 t}}]
  terrain: {{x: [-20 m, 380 m], z: [-60 m, -60 m]}}
analyses:
{}
)",
                     at(0, 4), at(360, 124), at(360, 122), at(110, 33), at(240, 78), guides,
                     rope("skyline", skyline, "length: 382 m"), rope("mainline", mainline, line.mainline), analyses);
}

/// Values of the columns that both tables have, by x.
using Rows = std::map<int, std::map<std::string, double>>;

void take(const Table& t, bool mirrored, Rows& rows) {
  for (std::size_t i = 0; i < t.rows.size(); ++i) {
    const double x = cell(t, i, "x");
    auto& row = rows[static_cast<int>(std::lround(100 * (mirrored ? 360 - x : x)))];
    for (std::size_t c = 0; c < t.columns.size(); ++c) {
      const std::string& name = t.columns[c].name;
      const bool compared = name == "z" || name == "payload" || name.ends_with("T_max") || name.ends_with("T_in") ||
                            name.ends_with("T_out") || name.ends_with("unstretched") || name.ends_with("Fz");
      const auto* number = std::get_if<double>(&t.rows[i][c]);
      if (compared && number != nullptr && !std::isnan(*number)) row[name] = *number;
    }
  }
}

/// Ends swapped: T_in and T_out change places.
std::string swapped(const std::string& name) {
  if (name.ends_with("T_in")) return name.substr(0, name.size() - 2) + "out";
  if (name.ends_with("T_out")) return name.substr(0, name.size() - 3) + "in";
  return name;
}

void expect_same(const Rows& a, const Rows& b, double tolerance, bool ends_swapped = false) {
  ASSERT_EQ(a.size(), b.size());
  for (const auto& [x, row] : a) {
    ASSERT_TRUE(b.contains(x)) << x / 100.0;
    const auto& other = b.at(x);
    EXPECT_EQ(row.size(), other.size()) << x / 100.0;
    for (const auto& [name, value] : row) {
      const std::string key = ends_swapped ? swapped(name) : name;
      ASSERT_TRUE(other.contains(key)) << name << " at " << x / 100.0;
      EXPECT_NEAR(value, other.at(key), tolerance * std::max(1.0, std::abs(value))) << name << " at " << x / 100.0;
    }
  }
}

constexpr double spans[][2] = {{5, 107}, {113, 237}, {243, 345}};

/// The analysis over a part of the line, in steps of 2 m.
std::string over(const char* kind, double from, double to, bool mirrored, const char* rest) {
  if (mirrored) from = 360 - from, to = 360 - to;
  return fmt::format("  - {}: {{carriage: car, from: {} m, to: {} m, steps: {}{}}}", kind, from, to,
                     std::lround(std::abs(to - from) / 2), rest);
}

constexpr const char* limits =
    ", motion: in, limits: {skyline: {safety_factor: 3}, mainline: {safety_factor: 3.5}, break_angle: 35 deg}";

Rows by_hand(Line line, const char* kind, const char* rest) {
  Rows rows;
  for (int span = 0; span < 3; ++span) {
    line.span = span;
    const Result r = run_text(deck(line, over(kind, spans[span][0], spans[span][1], line.mirrored, rest)));
    EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    take(table_of(r, kind), line.mirrored, rows);
  }
  return rows;
}

Rows in_one(Line line, const char* kind, const char* rest) {
  line.span.reset();
  const Result r = run_text(deck(line, over(kind, spans[0][0], spans[2][1], line.mirrored, rest)));
  EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  Rows rows;
  take(table_of(r, kind), line.mirrored, rows);
  // between the spans of the decks by hand
  std::erase_if(rows, [](const auto& one) {
    return std::none_of(std::begin(spans), std::end(spans),
                        [&](const auto& s) { return one.first >= 100 * s[0] && one.first <= 100 * s[1]; });
  });
  return rows;
}

TEST(AheadOf, OneDeckIsTheDecksOfTheSpans) {
  for (const auto& [uplift, rest] : {std::pair{"lift", ""}, {"hold", ", motion: in"}}) {
    const Line line{.uplift = uplift};
    const Rows one = in_one(line, "load_path", rest);
    EXPECT_GT(one.size(), 150U);
    expect_same(by_hand(line, "load_path", rest), one, 1e-9);
  }
}

TEST(AheadOf, PayloadsToo) {
  const Line line;
  expect_same(by_hand(line, "payload", limits), in_one(line, "payload", limits), 1e-7);
}

TEST(AheadOf, GuidesBesideTheirJacks) {
  // between guide and jack the carriage has passed one of the two
  const Line line{.guide_aside = -3};
  const Result r = run_text(deck(line, "  - load_path: {carriage: car, from: 229 m, to: 239 m, steps: 10}"));
  const Table& t = table_of(r, "load_path");
  const std::string warnings = fmt::format("{}", fmt::join(r.warnings, "\n"));
  // but on the guide, and with 235.85, 238.15 and 238.8 m beside guide and jack in place of the nearer 236 and 238 m
  ASSERT_EQ(t.rows.size(), 11U) << warnings;
  for (std::size_t i = 0; i < t.rows.size(); ++i) {
    const double x = cell(t, i, "x");
    EXPECT_EQ(!std::isnan(cell(t, i, "mainline.guide2.T_in")), x < 237) << x;
  }
  EXPECT_NE(warnings.find("x = 237 m: the carriage is on 'guide2': left out"), std::string::npos) << warnings;
}

TEST(AheadOf, MirroredAndFromTheOtherEnd) {
  for (const char* rest : {"", ", motion: in"}) {
    expect_same(in_one({}, "load_path", rest), in_one({.mirrored = true}, "load_path", rest), 1e-9, true);
  }
}

TEST(AheadOf, AnEquilibriumAtAPlaceAndOneThatFindsItsPlace) {
  const Line line;
  for (const auto& [x, count] : {std::pair{60.0, 2}, {180.0, 1}, {300.0, 0}}) {
    const Result r = run_text(deck(line, fmt::format("  - equilibrium: {{carriage: car, x: {} m}}", x)));
    ASSERT_EQ(r.status, Status::ok) << r.message;
    const Table& sheaves = table_of(r, "sheaves");
    long guides = 0;
    for (std::size_t i = 0; i < sheaves.rows.size(); ++i)
      guides += taut_test::text_cell(sheaves, i, "name").starts_with("guide") ? 1 : 0;
    EXPECT_EQ(guides, count) << x;
  }
  // the mainline's length of that equilibrium puts the carriage there again
  const Result placed = run_text(deck(line, "  - equilibrium: {carriage: car, x: 170 m}"));
  const double length = taut_test::value_of(placed, "mainline.unstretched");
  Line free = line;
  free.mainline = fmt::format("length: {:.12g} m", length);
  const Result found = run_text(deck(free, "  - equilibrium: {}"));
  EXPECT_NEAR(taut_test::value_of(found, "car.x"), 170, 1e-6) << found.message;
}

TEST(AheadOf, ACarriageAtRestBeyondItsGuideIsFoundAgain) {
  // the carriage starts in the middle of its span, at 175 m, where it has passed the guide at 170 m
  Line line{.guide_aside = -70};
  const Result placed = run_text(deck(line, "  - equilibrium: {carriage: car, x: 165 m}"));
  line.mainline = fmt::format("length: {:.12g} m", taut_test::value_of(placed, "mainline.unstretched"));
  const Result found = run_text(deck(line, "  - equilibrium: {}"));
  EXPECT_NEAR(taut_test::value_of(found, "car.x"), 165, 1e-6) << found.message;
}

TEST(AheadOf, CycleAndEnvelopeGoOverAllSpans) {
  const auto file = taut_test::source_dir() / "examples/machines/skyline_over_jacks.yaml";
  std::ostringstream text;
  text << std::ifstream(file).rdbuf()
       << "  - envelope: {carriage: car, from: 40 m, to: 340 m, steps: 50, motions: [in, out], loads: [0 t, 1 t]}\n";
  const Result r = run(Job{.text = text.str(), .name = file.string(), .set = {}});
  EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  ASSERT_TRUE(r.missing.empty()) << r.missing.front().reason << r.missing.front().first;
  const Table& envelope = table_of(r, "envelope");
  const auto most = [&](const std::string& name) {
    double found = 0;
    for (std::size_t i = 0; i < envelope.rows.size(); ++i) {
      if (taut_test::text_cell(envelope, i, "name") == name && taut_test::text_cell(envelope, i, "quantity") == "T_in")
        found = cell(envelope, i, "max");
    }
    return found;
  };
  EXPECT_GT(most("mainline on guide1"), 1000);
  EXPECT_GT(most("mainline on guide2"), 1000);
  const Table& work = table_of(r, "cycle_work");
  double taken = 0, pull = 0;
  for (std::size_t i = 0; i < work.rows.size(); ++i) {
    taken += cell(work, i, "rope_taken_in");
    pull = std::max(pull, std::abs(cell(work, i, "pull_max")));
  }
  EXPECT_NEAR(taken, 0, 300 * pull / 7e6);  // out and in over 300 m: but for the stretch by the load
}

TEST(AheadOf, AMotionRefusesItByName) {
  const Result r = run_text(deck({}, "  - transient: {duration: 1 s}"));
  taut_test::expect_mistake(r, "machine.sheaves.guide1.holds: a motion can't take 'guide1' out of the path");
}

TEST(AheadOf, ASpanOfItsRopeIsNoCondition) {
  const Result r =
      run_text(deck({.mainline = "tension_at_start: 9 kN"},
                    "  - equilibrium: {carriage: car, x: 60 m, given: {reeving: mainline, sag: 1 m, span: 2}}"));
  taut_test::expect_mistake(r, "the spans of 'mainline' change at its guides");
}

}  // namespace taut::app::ahead_of_test
