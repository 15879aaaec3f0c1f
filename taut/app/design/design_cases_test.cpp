#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "taut/app/design/design_space.hpp"
#include "test/support/machine_decks.hpp"

/// Of design_space.hpp the load cases.
namespace taut::app::design_cases_test {

using design::Depth;
using design::DesignCase;
using design::DesignRun;
using taut_test::cell;
using taut_test::text_cell;
using testing::ElementsAre;
using testing::HasSubstr;

const std::vector<DesignCase> three = {
    {.name = "empty", .settings = {}}, {.name = "loaded", .settings = {}}, {.name = "storm", .settings = {}}};

/// A run whose one check has this utilisation.
DesignRun run_with(double utilisation, double tension = 0) {
  DesignRun run{.result = {}, .tension = tension};
  run.result.checks = {make_check("rope.T_max", utilisation, si::one,
                                  {.sense = Sense::at_most, .limit = 1, .rule = "", .trust = "user"})};
  run.result.warnings = {"the same in every case"};
  return run;
}

/// Cases with their runs, and the order in which they are asked.
struct Asked {
  std::map<std::string, DesignRun> runs;
  std::vector<std::string> order = {};
  std::size_t first = 0;

  DesignRun operator()(Depth depth) {
    order.clear();
    return run_cases(three, depth, first, [&](const DesignCase* one, Depth how) {
      order.push_back(one->name + (how == Depth::report ? "!" : ""));
      DesignRun run = runs.at(one->name);
      run.result.title = one->name;
      return run;
    });
  }
};

std::vector<std::string> checks_of(const Result& r) {
  std::vector<std::string> names;
  names.reserve(r.checks.size());
  for (const Check& c : r.checks) names.push_back(c.name);
  return names;
}

// What keeps one case from passing keeps the design, whichever case governs.
TEST(DesignCases, WhatIsUnsafeOrNotJudgedInAnyCaseStays) {
  Asked asked{.runs = {{"empty", run_with(0.2)}, {"loaded", run_with(0.9)}, {"storm", run_with(0.5)}}};
  asked.runs["empty"].result.unsafe = {"two turns are left"};
  asked.runs["storm"].result.unjudged = {"side"};
  asked.runs["storm"].result.unmade = {"a state is missing"};
  for (const Depth depth : {Depth::checks, Depth::report}) {
    const Result r = asked(depth).result;
    EXPECT_THAT(r.unsafe, ElementsAre("two turns are left"));
    EXPECT_THAT(r.unjudged, ElementsAre("side"));
    EXPECT_THAT(r.unmade, ElementsAre("a state is missing"));
  }
}

TEST(DesignCases, WithoutAnyThereIsOneRunAsItIs) {
  std::size_t first = 0;
  int asked = 0;
  const DesignRun run = run_cases({}, Depth::quick, first, [&](const DesignCase* one, Depth how) {
    ++asked;
    EXPECT_EQ(one, nullptr);
    EXPECT_EQ(how, Depth::quick);
    return run_with(0.5, 7e3);
  });
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(run.tension, 7e3);
  EXPECT_THAT(checks_of(run.result), ElementsAre("rope.T_max"));
}

TEST(DesignCases, TheWorstGovernsAndTheChecksAreThoseOfAll) {
  Asked ask{.runs = {{"empty", run_with(0.4, 5e3)}, {"loaded", run_with(1.3, 9e3)}, {"storm", run_with(0.8, NAN)}}};
  const DesignRun run = ask(Depth::checks);
  EXPECT_THAT(ask.order, ElementsAre("empty", "loaded", "storm")) << "a case that fails ends a quick look only";
  EXPECT_EQ(run.result.title, "loaded");
  EXPECT_EQ(run.tension, 9e3);
  EXPECT_THAT(checks_of(run.result),
              testing::UnorderedElementsAre("rope.T_max [empty]", "rope.T_max [loaded]", "rope.T_max [storm]"));
  EXPECT_THAT(run.result.warnings, ElementsAre("the same in every case"));
  EXPECT_TRUE(run.result.tables.empty());
  ask.runs["storm"] = run_with(NAN);
  EXPECT_EQ(ask(Depth::checks).result.title, "storm") << "a check without a number is worse than any";
}

TEST(DesignCases, AQuickLookEndsAtACaseThatFailsAndBeginsThereTheNextTime) {
  Asked ask{.runs = {{"empty", run_with(0.4)}, {"loaded", run_with(1.3)}, {"storm", run_with(0.8)}}};
  EXPECT_EQ(ask(Depth::quick).result.title, "loaded");
  EXPECT_THAT(ask.order, ElementsAre("empty", "loaded"));
  ask(Depth::quick);
  EXPECT_THAT(ask.order, ElementsAre("loaded"));
  ask.runs["loaded"] = run_with(0.9);
  EXPECT_EQ(ask(Depth::quick).result.title, "loaded");
  EXPECT_THAT(ask.order, ElementsAre("loaded", "storm", "empty")) << "what passes has passed all cases";
}

TEST(DesignCases, ACaseWithoutAnAnswerIsNamedAndEndsTheRun) {
  Asked ask{.runs = {{"empty", run_with(2)}, {"loaded", run_with(0)}, {"storm", run_with(3)}}};
  ask.runs["loaded"].result.status = Status::infeasible;
  ask.runs["loaded"].result.message = "the rope is too short";
  const DesignRun run = ask(Depth::checks);
  EXPECT_THAT(ask.order, ElementsAre("empty", "loaded"));
  EXPECT_EQ(run.result.status, Status::infeasible);
  EXPECT_EQ(run.result.message, "case loaded: the rope is too short");
  ask.runs["loaded"].result.status = Status::ok;
  ask.runs["loaded"].result.interrupted = true;
  ask.first = 0;
  EXPECT_TRUE(ask(Depth::checks).result.interrupted);
  EXPECT_THAT(ask.order, ElementsAre("empty", "loaded"));
}

// That case may be wrong in the deck: whether it is the only obstacle is known of the others alone.
TEST(DesignCases, AQuickLookGoesOnBehindACaseWithoutAnAnswer) {
  Asked ask{.runs = {{"empty", run_with(0.2)}, {"loaded", run_with(0)}, {"storm", run_with(0.9)}}};
  ask.runs["loaded"].result.status = Status::infeasible;
  ask.runs["loaded"].result.message = "the rope is too short";
  DesignRun run = ask(Depth::quick);
  EXPECT_THAT(ask.order, ElementsAre("empty", "loaded", "storm"));
  EXPECT_EQ(run.result.message, "case loaded: the rope is too short");
  EXPECT_THAT(run.cases.with, ElementsAre("empty", "storm"));
  EXPECT_THAT(run.cases.without, ElementsAre(testing::Pair("loaded", "the rope is too short")));
  EXPECT_TRUE(run.cases.others_pass);
  ask.runs["storm"] = run_with(1.2);
  ask.first = 0;
  run = ask(Depth::quick);
  EXPECT_EQ(run.result.status, Status::infeasible) << "what has no answer is worse than what fails";
  EXPECT_FALSE(run.cases.others_pass);
}

TEST(DesignCases, AReportIsThatOfTheOneThatGovernsWithATableOfAll) {
  Asked ask{.runs = {{"empty", run_with(0.4)}, {"loaded", run_with(0.7)}, {"storm", run_with(0.95)}}, .first = 1};
  const DesignRun run = ask(Depth::report);
  EXPECT_THAT(ask.order, ElementsAre("loaded", "storm", "empty", "storm!"));
  EXPECT_EQ(run.result.checks.size(), 3U);
  ASSERT_EQ(run.result.tables.size(), 1U);
  const Table& t = run.result.tables[0];
  EXPECT_EQ(t.name, cases_words().name);
  ASSERT_EQ(t.rows.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(text_cell(t, i, "case"), three[i].name) << "in the order of the deck";
  EXPECT_EQ(cell(t, 2, "utilisation"), 0.95);
  EXPECT_EQ(text_cell(t, 2, "governs"), "rope.T_max");
  EXPECT_EQ(text_cell(t, 2, "passes"), "yes");
  ASSERT_EQ(run.result.assumptions.size(), 1U);
  EXPECT_THAT(run.result.assumptions[0], HasSubstr("the one that governs, storm"));
}

}  // namespace taut::app::design_cases_test
