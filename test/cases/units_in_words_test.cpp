#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <regex>
#include <string>
#include <variant>
#include <vector>

#include "taut/app/job.hpp"
#include "taut/calc/verdict.hpp"
#include "test/paths.hpp"

namespace units_in_words_test {

using namespace taut;
using testing::IsEmpty;

/// Nothing of the metric units, which a deck has where it says nothing, is left in any kind.
const std::vector<std::string> imperial = {"display.force=lbf",
                                           "display.length=ft",
                                           "display.stress=psi",
                                           "display.mass=lb",
                                           "display.speed=ft/s",
                                           "display.moment=ft lbf",
                                           "display.power=W",
                                           "display.energy=J",
                                           "display.angle=rad",
                                           "display.area=in^2",
                                           "display.mass per length=lb/ft"};

/// What a sentence quotes of others keeps its unit: names of ropes and yarders in the catalogue, its row of a carriage,
/// the formula phi2 = 1.1 + 0.34 v_h with the v_h that belongs to its numbers, rules of thumb in their own words,
/// values of the deck as it writes them (of a sweep).
std::string without_quotes(std::string text) {
  static const std::vector<std::regex> quoted = {std::regex("EN 12385-4 \\S+ [0-9]+ mm [0-9]+ MPa"),
                                                 std::regex("v_h = [0-9.]+ m/s"),
                                                 std::regex("class [0-9]+ m"),
                                                 std::regex("1 cm more for each metre down"),
                                                 std::regex("of 2 to 4 deg the safe end"),
                                                 std::regex("^car: mass .* in the catalogue .*"),
                                                 std::regex("loads\\[0\\]\\.mass = [0-9]+ kg")};
  for (const std::regex& one : quoted) text = std::regex_replace(text, one, "");
  return text;
}

bool has_metric(const std::string& text) {
  static const std::regex metric("[0-9] (kN m|kN|N m|N|MPa|GPa|m/s|km|cm|mm|m|kg/m|kg|t|kJ|kW|deg)(?![a-zA-Z0-9_/^])");
  return std::regex_search(without_quotes(text), metric);
}

std::vector<std::string> sentences_of(const Result& r) {
  std::vector<std::string> all = r.warnings;
  const auto add = [&](const std::vector<std::string>& more) { all.insert(all.end(), more.begin(), more.end()); };
  add(r.assumptions);
  add(r.unsafe);
  add(r.unmade);
  all.push_back(r.message);
  all.push_back(r.headline);
  if (const auto verdict = verdict_of(r)) all.push_back(verdict->reason);
  for (const Check& c : r.checks) add({c.rule, c.where});
  for (const Answer& one : r.answers) all.push_back(one.text);
  for (const Value& v : r.values) all.push_back(v.label);
  for (const MissingStates& m : r.missing) all.push_back(missing_words(m));
  for (const Table& t : r.tables) {
    all.push_back(t.title);
    for (const auto& row : t.rows) {
      for (const Cell& cell : row) {
        if (const auto* text = std::get_if<std::string>(&cell)) all.push_back(*text);
      }
    }
  }
  return all;
}

struct Example {
  std::string file;                   ///< below examples/
  std::vector<std::string> set = {};  ///< what makes it tell more
};

std::vector<std::string> metric_sentences(const Example& example) {
  auto job = app::read_job((taut_test::source_dir() / "examples" / example.file).string());
  if (!job) return {job.error().message};
  job->set = imperial;
  job->set.insert(job->set.end(), example.set.begin(), example.set.end());
  const Result r = app::run(*job);
  std::vector<std::string> metric;
  for (const Diagnostic& mistake : r.errors) metric.push_back(mistake.message);
  for (const std::string& one : sentences_of(r)) {
    if (has_metric(one)) metric.push_back(one);
  }
  return metric;
}

class UnitsInWords : public testing::TestWithParam<Example> {};

/// A person who reads lbf and ft reads every sentence in them: warnings, rules of checks, places, answers, notes.
TEST_P(UnitsInWords, AreThoseOfTheDisplay) { EXPECT_THAT(metric_sentences(GetParam()), IsEmpty()); }

INSTANTIATE_TEST_SUITE_P(
    Examples, UnitsInWords,
    testing::Values(Example{"design/crane_hoist.yaml"}, Example{"design/yarder_mast.yaml"},
                    Example{"machines/base_tension.yaml"}, Example{"machines/guys_pulled_in_turn.yaml"},
                    Example{"machines/six_part_tackle.yaml"}, Example{"machines/skyline_over_jacks.yaml"},
                    Example{"machines/skyline_over_terrain.yaml"}, Example{"machines/tower_yarder.yaml"},
                    Example{"machines/yarder_and_carriage.yaml"}, Example{"machines/two_section_loop.yaml"},
                    Example{"machines/rope_saw_drive.yaml"}, Example{"motion/tackle_hoist.yaml"},
                    Example{"motion/brake_stop.yaml"}, Example{"motion/rope_break.yaml"},
                    Example{"motion/skyline_load_drop.yaml"}, Example{"motion/longspan_sag.yaml"},
                    Example{"telescopic_boom/break_retraction_21_hook.yaml"},
                    // a line in the ground, a brake that does not hold
                    Example{"machines/skyline_over_terrain.yaml", {"machine.loads[0].mass=30 t"}},
                    Example{"motion/brake_stop.yaml", {"machine.bodies.hook.mass=6 t"}}),
    [](const testing::TestParamInfo<Example>& one) {
      std::string name = one.param.file;
      std::replace_if(
          name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
      return name + std::to_string(one.index);
    });

/// The test sees what it looks for.
TEST(UnitsInWords, AMetricNumberIsSeen) {
  EXPECT_TRUE(has_metric("tension 12.4 kN"));
  EXPECT_TRUE(has_metric("load path, x = 120 m"));
  EXPECT_TRUE(has_metric("sags by 3 m: more"));
  EXPECT_FALSE(has_metric("load path, x = 120 ft"));
  EXPECT_FALSE(has_metric("skyline EN 12385-4 6x36-IWRC 20 mm 1960 MPa, cut 900 ft"));
}

}  // namespace units_in_words_test
