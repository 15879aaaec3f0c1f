#include "taut/app/compare.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "test/paths.hpp"
#include "test/support/machine_decks.hpp"

namespace taut_test::compare_test {

namespace fs = std::filesystem;

/// A folder with a deck of a weight on a rope, 9806.65 N, and a set.
class Compare : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / fmt::format("taut_compare_{}", info->name());
    fs::create_directories(folder_);
    write("hanging.yaml", R"(taut: 1
parameters: {mass: 1 t}
machine:
  points: {top: [0 m, 0 m, 10 m]}
  ropes: {line: {mass: 0 kg/m, stiffness: 10 MN}}
  bodies: {hook: {mass: = mass, at: [0 m, 0 m, 5 m], free: [x, z]}}
  reevings: [{rope: line, path: [{anchor: top}, {anchor: hook}], length: 5 m}]
)");
  }
  void TearDown() override { fs::remove_all(folder_); }
  void write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }
  taut::Result run(const std::string& values, const std::string& display = {}) {
    write("compare.part.yaml", "taut: 1\ntitle: A set\n" + display + "compare:\n  source: a paper\n  values:\n" +
                                   values + "  errata: [the paper errs]\n");
    const auto job = taut::app::read_set(folder_.string());
    EXPECT_TRUE(job.has_value());
    return taut::app::compare(*job);
  }

  fs::path folder_;
};

TEST_F(Compare, ShowsTheUnitsOfItsDisplay) {
  const std::string row = "    - {what: b, deck: hanging.yaml, value: T_max, published: 9 kN, tolerance: 1 %}\n";
  const taut::Result r = run(row, "display: {force: kgf}\n");
  ASSERT_EQ(r.warnings.size(), 1U) << r.message << to_text(r.errors);
  EXPECT_EQ(r.warnings[0], "b: 1000 kgf instead of 917.74 kgf (published); no reason is stated");
  EXPECT_EQ(text_cell(table_of(r, "compared"), 0, "taut"), "1000 kgf");
  EXPECT_EQ(r.display.at("force"), "kgf") << "of the checks and the page";
  expect_mistake(run(row, "display: {force: kgm}\n"), "display: ");
}

// What a deck says of itself stays beside its values: a check that fails, once for all its rows, and each deck's
// verdict.
TEST_F(Compare, TellsWhatItsDecksSayAgainstThemselves) {
  write("weak.yaml", R"(taut: 1
machine:
  points: {top: [0 m, 0 m, 10 m]}
  ropes: {line: {mass: 0 kg/m, stiffness: 10 MN, breaking_force: 20 kN}}
  bodies: {hook: {mass: 1 t, at: [0 m, 0 m, 5 m], free: [x, z]}}
  reevings: [{rope: line, path: [{anchor: top}, {anchor: hook}], length: 5 m}]
checks: {ropes: {line: {safety_factor: 3}}}
)");
  const taut::Result r =
      run("    - {what: a, deck: weak.yaml, value: T_max, published: 9.8 kN, tolerance: 1 %}\n"
          "    - {what: b, deck: weak.yaml, value: line.T_max, published: 9.8 kN, tolerance: 1 %}\n"
          "    - {what: c, deck: hanging.yaml, value: T_max, published: 9.8 kN, tolerance: 1 %}\n");
  ASSERT_EQ(r.status, taut::Status::ok) << r.message << to_text(r.errors);
  ASSERT_EQ(r.warnings.size(), 1U) << fmt::format("{}", fmt::join(r.warnings, "\n"));
  EXPECT_NE(r.warnings[0].find("weak.yaml, by its own checks: "), std::string::npos) << r.warnings[0];
  EXPECT_NE(r.warnings[0].find("line.safety_factor"), std::string::npos) << r.warnings[0];
  const taut::Table& t = table_of(r, "compared");
  EXPECT_EQ(text_cell(t, 0, "deck_verdict"), "Fails");
  EXPECT_EQ(text_cell(t, 2, "deck_verdict").substr(0, 10), "Not judged");
  for (const taut::Check& c : r.checks) EXPECT_TRUE(c.passes) << c.name;
}

// 9806.65 N come out of an iteration with a last digit of their own: "9.8066 kN instead of 9.8066 kN" helped nobody.
TEST_F(Compare, RoundingIsNoMissAndAMissReadsAsOne) {
  const taut::Result r =
      run("    - {what: a, deck: hanging.yaml, value: T_max, published: 9806.65 N, tolerance: 0 N}\n"
          "    - {what: b, deck: hanging.yaml, value: T_max, published: 9806.6501 N, tolerance: 0 N}\n"
          "    - {what: c, deck: hanging.yaml, value: T_max, published: 9806.650000005 N, tolerance: 0 N}\n");
  ASSERT_EQ(r.checks.size(), 3U) << r.message << to_text(r.errors);
  EXPECT_TRUE(r.checks[0].passes) << r.checks[0].value;
  EXPECT_FALSE(r.checks[1].passes);
  EXPECT_TRUE(r.checks[2].passes) << "1e-12 of it";
  ASSERT_EQ(r.warnings.size(), 1U);
  EXPECT_EQ(r.warnings[0].substr(0, 60), "b: 9.8066 kN instead of 9.8067 kN (published); no reason is ");
}

TEST_F(Compare, PutsPublishedReferenceAndResultBesideEachOther) {
  const taut::Result r =
      run("    - {what: a, deck: hanging.yaml, value: T_max, published: 9.8 kN, tolerance: 1 %, reference: 9807 N, "
          "reference_tolerance: 1 N}\n"
          "    - {what: b, deck: hanging.yaml, value: T_max, published: 9 kN, tolerance: 1 kN, set: [parameters.mass=2 "
          "t]}\n"
          "    - {what: c, deck: hanging.yaml, value: T_max, published: 9 kN}\n"
          "    - {what: d, deck: hanging.yaml, value: T_max, published: 9.8 kN, tolerance: 1 %, reference: 9 kN, "
          "reference_tolerance: 1 %, note: the rope is old}\n");
  ASSERT_EQ(r.status, taut::Status::ok) << r.message << to_text(r.errors);
  EXPECT_EQ(r.title, "A set");
  ASSERT_EQ(r.warnings.size(), 2U);  // what misses, and why
  EXPECT_EQ(r.warnings[0], "b: 19.613 kN instead of 9 kN (published); no reason is stated");
  EXPECT_EQ(r.warnings[1], "d: 9.8066 kN instead of 9 kN (reference); the rope is old");
  EXPECT_EQ(exit_code(r), 4);
  const taut::Table& t = table_of(r, "compared");
  EXPECT_EQ(text_cell(t, 0, "verdict"), "agrees");
  EXPECT_EQ(text_cell(t, 0, "taut").substr(0, 5), "9.806");
  EXPECT_EQ(text_cell(t, 0, "to_published"), "+0.068 % (may 1 %)");
  EXPECT_EQ(text_cell(t, 1, "verdict"), "off the published value");
  EXPECT_EQ(text_cell(t, 1, "taut"), "19.613 kN");
  EXPECT_EQ(text_cell(t, 2, "verdict"), "shown only");
  EXPECT_EQ(text_cell(t, 3, "verdict"), "off the reference");
  ASSERT_EQ(r.checks.size(), 5U);
  EXPECT_TRUE(r.checks[0].passes);
  EXPECT_TRUE(r.checks[1].passes);
  EXPECT_FALSE(r.checks[2].passes);
  EXPECT_TRUE(r.checks[3].passes);
  EXPECT_FALSE(r.checks[4].passes);
  ASSERT_EQ(r.assumptions.size(), 1U);
  EXPECT_EQ(r.assumptions[0], "Erratum of the source: the paper errs");
}

TEST_F(Compare, WhatIsMissingFails) {
  const taut::Result r =
      run("    - {what: a, deck: hanging.yaml, value: T_least, published: 9 kN, tolerance: 1 %}\n"
          "    - {what: b, deck: hanging.yaml, value: T_least, published: 9 kN}\n");
  EXPECT_EQ(exit_code(r), 4);
  ASSERT_EQ(r.checks.size(), 1U);
  EXPECT_FALSE(r.checks[0].passes);
  EXPECT_EQ(text_cell(table_of(r, "compared"), 0, "verdict"), "no value 'T_least'");
}

// a row that is only shown shows nothing
TEST_F(Compare, ARowOnlyShownWithoutItsValueIsNotJudged) {
  const std::string kept = "    - {what: a, deck: hanging.yaml, value: T_max, published: 9.8 kN, tolerance: 1 %}\n";
  EXPECT_EQ(exit_code(run(kept)), 0);
  const taut::Result r = run(kept + "    - {what: b, deck: hanging.yaml, value: T_least, published: 9 kN}\n");
  ASSERT_EQ(r.unmade.size(), 1U);
  EXPECT_EQ(r.unmade[0], "b: no value 'T_least'");
  EXPECT_EQ(exit_code(r), 4);
}

// The line of a row without a value says why, and nothing of how far it is off.
TEST_F(Compare, ARowWithoutAValueIsNotOffByAnything) {
  const taut::Result r =
      run("    - {what: a, deck: hanging.yaml, value: T_least, published: 9 kN, tolerance: 1 %}\n"
          "    - {what: b, deck: hanging.yaml, value: T_max, published: 9 kN, tolerance: 1 %}\n");
  std::vector<std::string> worst;
  for (const taut::Answer& one : r.answers) {
    if (one.label == "Worst") worst.push_back(one.text);
  }
  ASSERT_EQ(worst.size(), 2U);
  EXPECT_EQ(worst[0], "a: no value 'T_least'");
  EXPECT_TRUE(worst[1].ends_with("from the published value")) << worst[1];
}

// 9806.65 N is 0.07 % off the published value, of which 0.1 % may be, and 2.2 % off the reference, of which 1 % may be.
TEST_F(Compare, TheWorstIsSaidOfTheSideThatIsOffMore) {
  const taut::Result r =
      run("    - {what: a, deck: hanging.yaml, value: T_max, published: 9.8 kN, tolerance: 0.1 %, reference: 9.6 kN, "
          "reference_tolerance: 1 %}\n"
          "    - {what: b, deck: hanging.yaml, value: T_max, published: 9 kN, tolerance: 1 %, reference: 9.6 kN, "
          "reference_tolerance: 1 %}\n");
  std::vector<std::string> worst;
  for (const taut::Answer& one : r.answers) {
    if (one.label == "Worst") worst.push_back(one.text);
  }
  ASSERT_EQ(worst.size(), 2U);
  EXPECT_EQ(worst[0], "b: 9.8066 kN, +9 % (may 1 %) from the published value");
  EXPECT_EQ(worst[1], "a: 9.8066 kN, +2.2 % (may 1 %) from the reference");
  ASSERT_EQ(r.warnings.size(), 2U);
  EXPECT_EQ(r.warnings[0], "a: 9.8066 kN instead of 9.6 kN (reference); no reason is stated");
  EXPECT_EQ(r.warnings[1], "b: 9.8066 kN instead of 9 kN (published); no reason is stated");
}

// The check of a row and its words have one tolerance: 9806.65 N are 1 N off 9805.65 N, up to the last digits.
TEST_F(Compare, AValueOnTheEndOfItsToleranceAgrees) {
  const taut::Result r =
      run("    - {what: a, deck: hanging.yaml, value: T_max, published: 9805.65 N, tolerance: 1 N}\n"
          "    - {what: b, deck: hanging.yaml, value: T_max, published: 9807.65 N, tolerance: 1 N}\n"
          "    - {what: c, deck: hanging.yaml, value: T_max, published: 9805.65 N, tolerance: 0.99999 N}\n");
  ASSERT_EQ(r.checks.size(), 3U) << r.message << to_text(r.errors);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(r.checks[i].passes, i < 2);
    EXPECT_EQ(text_cell(table_of(r, "compared"), i, "verdict"), i < 2 ? "agrees" : "off the published value");
  }
  EXPECT_EQ(r.warnings.size(), 1U);
}

// The value comes from another analysis of the deck than the one that has no answer.
TEST_F(Compare, AValueOfADeckWithoutAnAnswerIsNotJudged) {
  write("line.yaml", R"(taut: 1
machine:
  points: {head: [0 m, 0 m, 40 m], tail: [200 m, 0 m, 40 m]}
  ropes: {skyline: {mass: 1.6 kg/m, stiffness: 20 MN}}
  carriages: {car: {mass: 300 kg, rides: skyline, hold: clamped}}
  reevings: [{rope: skyline, path: [{anchor: head}, {through: car}, {anchor: tail}], length: 201 m}]
analyses:
  - load_path: {carriage: car, from: 50 m, to: 150 m, steps: 4}
  - equilibrium: {carriage: car, x: 500 m}
)");
  const taut::Result r = run("    - {what: a, deck: line.yaml, value: T_max, published: 20 kN, tolerance: 100 kN}\n");
  ASSERT_EQ(r.checks.size(), 1U) << r.message << to_text(r.errors);
  EXPECT_TRUE(r.checks[0].passes);
  ASSERT_EQ(r.unmade.size(), 1U);
  EXPECT_EQ(exit_code(r), 4);
}

// A deck with a value in degC: a tolerance is a difference of two, whose zero is none of the scale.
TEST_F(Compare, ATemperatureMayBeOffByADifferenceInKelvin) {
  const auto row = [](const std::string& published, const std::string& tolerance) {
    return fmt::format("    - {{what: a, deck: {}, value: sweep_end_cold, published: {}, tolerance: {}}}\n",
                       (source_dir() / "examples/machines/base_tension.yaml").string(), published, tolerance);
  };
  for (const char* tolerance : {"1 K", "1 degC"}) {
    const taut::Result near = run(row("29.5 degC", tolerance)), far = run(row("0 degC", tolerance));
    ASSERT_EQ(near.checks.size(), 1U) << near.message << to_text(near.errors);
    EXPECT_TRUE(near.checks[0].passes);
    EXPECT_NEAR(near.checks[0].utilisation, 0.5, 1e-9);
    EXPECT_FALSE(far.checks[0].passes) << tolerance;
    EXPECT_EQ(text_cell(table_of(far, "compared"), 0, "to_published"), "30 K (may 1 K)");
    EXPECT_EQ(text_cell(table_of(run(row("0 degC", tolerance), "display: {temperature: degC}\n"), "compared"), 0,
                        "to_published"),
              "30 K (may 1 K)");
  }
  expect_mistake(run(row("20 degC", "5 %")), "tolerance: a share of a temperature would depend on the zero");
}

TEST_F(Compare, AToleranceBelowZeroIsAMistake) {
  const std::string row = "    - {what: a, deck: hanging.yaml, value: T_max, published: 9.8 kN, ";
  for (const std::string key : {"tolerance", "reference_tolerance"}) {
    for (const std::string width : {"-3 %", "-1 kN"}) {
      const std::string reference = key == "tolerance" ? "" : "reference: 9.8 kN, ";
      std::string wrong = key;
      wrong += ": " + width;
      const taut::Result r = run(fmt::format("{}{}{}}}\n", row, reference, wrong));
      EXPECT_EQ(exit_code(r), 2) << key;
      EXPECT_NE(to_text(r.errors).find("error: " + wrong + " is below 0"), std::string::npos) << to_text(r.errors);
    }
  }
  EXPECT_TRUE(run(row + "tolerance: 0 %}\n").errors.empty());
}

TEST_F(Compare, MistakesAreToldAtTheirPlace) {
  const auto reported = [&](const std::string& values) { return to_text(run(values).errors); };
  EXPECT_NE(reported("    - {what: a, deck: hung.yaml, value: T_max}\n").find("can't be read: No such file"),
            std::string::npos);
  EXPECT_NE(
      reported("    - {what: a, deck: hanging.yaml, value: T_max, published: 9 m}\n").find("6:62: error: published: "),
      std::string::npos)
      << reported("    - {what: a, deck: hanging.yaml, value: T_max, published: 9 m}\n");
  EXPECT_NE(reported("    - {what: a, deck: hanging.yaml, value: T_max, published: 9 kN, reference_tolerance: 1 %}\n")
                .find("is of 'reference', which the row does not give"),
            std::string::npos);
  EXPECT_NE(reported("    - {what: a, deck: hanging.yaml}\n").find("lacks 'value'"), std::string::npos);
  EXPECT_NE(reported("    - {what: a, deck: hanging.yaml, value: T_max, set: [machine.gravty=1]}\n").find("gravty"),
            std::string::npos);
  write("other.part.yaml", "taut: 1\nmethod: x\n");
  const auto job = taut::app::read_set((folder_ / "other.part.yaml").string());
  ASSERT_TRUE(job);
  const std::string text = to_text(taut::app::compare(*job).errors);
  EXPECT_NE(text.find("'method' is not a key of a set"), std::string::npos) << text;
  EXPECT_NE(text.find("there is nothing to compare"), std::string::npos) << text;
  EXPECT_FALSE(taut::app::read_set((folder_ / "nowhere").string()));
}

}  // namespace taut_test::compare_test
