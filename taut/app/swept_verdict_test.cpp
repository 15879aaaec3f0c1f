#include "taut/app/swept_verdict.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace taut::app::swept_verdict_test {

Result with(const std::string& warning, bool unsafe, double factor) {
  Result r;
  unsafe ? warn_unsafe(r, warning) : r.warnings.push_back(warning);
  r.checks.push_back(make_check("sky.safety_factor", factor, si::one,
                                {.sense = Sense::at_least, .limit = 3, .rule = "a rule", .trust = "user"}));
  return r;
}

TEST(SweptVerdict, KeepsAllChecksWithTheirStateAndEachWarningOnce) {
  SweptVerdict verdict;
  verdict.take(with("strained by 1.9 %", false, 4), "d = 20 mm");
  verdict.take(with("strained by 1.95 %", false, 2), "d = 18 mm");
  verdict.take(with("strained by 2.1 %", true, 1), "d = 16 mm");
  Result none;
  none.status = Status::infeasible;
  none.message = "no room";
  verdict.take(none, "d = 1 mm");
  Result r;
  verdict.put_into(r);
  ASSERT_EQ(r.checks.size(), 3U);
  EXPECT_EQ(r.checks[2].where, "d = 16 mm");
  EXPECT_FALSE(r.checks[2].passes);
  ASSERT_EQ(r.warnings.size(), 2U);  // a plain one does not hide the unsafe one of the same words
  EXPECT_EQ(r.warnings[0], "d = 20 mm: strained by 1.9 %");
  ASSERT_EQ(r.unsafe.size(), 1U);
  EXPECT_EQ(r.unsafe[0], "d = 16 mm: strained by 2.1 %");
  ASSERT_EQ(r.unmade.size(), 1U);
  EXPECT_EQ(r.unmade[0], "d = 1 mm: its checks have no answer: no room");
}

/// The least factor and the largest use, whatever the order; other values stay those of the deck.
TEST(SweptVerdict, KeepsTheWorstValueOfTheChecks) {
  const auto valued = [](double factor, double use, double tension) {
    Result r;
    const auto add = [&](const char* name, double value, const char* label) {
      r.values.push_back({.name = name, .value = value, .unit = si::one, .symbol = "", .label = label, .source = ""});
    };
    add("sky.dynamic_safety_factor", factor, "factor of sky (at rest)");
    add("mast.utilisation", use, "use of mast");
    add("sky.T_max", tension, "tension");
    return r;
  };
  SweptVerdict verdict;
  verdict.take(valued(4, 0.5, 10), "d = 20 mm");
  verdict.take(valued(2, 0.3, 20), "d = 16 mm");
  Result r = valued(3, 0.4, 15);
  std::move(verdict).put_numbers_into(r);
  ASSERT_EQ(r.values.size(), 3U);
  EXPECT_EQ(r.values[0].value, 2);
  EXPECT_EQ(r.values[0].label, "factor of sky (at rest), d = 16 mm");
  EXPECT_EQ(r.values[1].value, 0.5);
  EXPECT_EQ(r.values[2].value, 20);
  // the same state found once more keeps its words
  SweptVerdict again;
  again.take(valued(2 - 1e-12, 0.5, 20), "d = 16 mm");
  std::move(again).put_numbers_into(r);
  EXPECT_EQ(r.values[0].label, "factor of sky (at rest), d = 16 mm");
}

/// r1 and r2 are two ropes; 1 m and 2 m are the same of two states.
TEST(SweptVerdict, NamesWithNumbersAreNotTakenForAnother) {
  const auto left = [](const std::string& rope, const std::string& length) {
    Result r;
    r.unmade = {rope + ": its drum is not checked with " + length};
    return r;
  };
  SweptVerdict verdict;
  verdict.take(left("r1", "1.5 m"), "a = 1");
  verdict.take(left("r2", "-1.5e+03 m"), "a = 1");
  verdict.take(left("r2", "2 m"), "a = 2");
  verdict.take(left("'3'", "2 m"), "a = 2");
  verdict.take(left("'4'", "2 m"), "a = 2");
  Result r;
  verdict.put_into(r);
  ASSERT_EQ(r.unmade.size(), 4U);
  EXPECT_EQ(r.unmade[1], "r2: its drum is not checked with -1.5e+03 m");
  EXPECT_EQ(r.unmade[3], "'4': its drum is not checked with 2 m");
}

/// That no state loads a part falls with the first that loads it. What else is said of a state stays: each value of a
/// sweep is another machine, and what one shows says nothing of the others.
TEST(SweptVerdict, WhatOneStateLoadsIsNotMissingInAnother) {
  const auto none = [](const std::string& state) {
    Result r;
    leave_unmade(r, "a is not checked: nothing pulls at it (" + state + ")",
                 {.part = {.kind = PartKind::point, .name = "a"}, .no_load = "anchor a"});
    leave_unmade(r, "b.turn is not checked: it stands (" + state + ")",
                 {.part = {.kind = PartKind::drum, .name = "b"}});
    leave_unmade(r, "c is not checked: it has no diameter", {.part = {.kind = PartKind::rope, .name = "c"}});
    return r;
  };
  const auto all_of = [&](Result last) {
    SweptVerdict verdict;
    verdict.take(none("low"), "z = 1 m");
    verdict.take(none("high"), "z = 2 m");
    verdict.take(std::move(last), "z = 3 m");
    Result r = none("at rest");
    verdict.put_into(r);
    drop_loaded(r);
    return r;
  };
  const Result open = all_of({});
  const auto count = [](const Result& r, const std::string& begins) {
    return std::count_if(r.unmade.begin(), r.unmade.end(), [&](const auto& one) { return one.starts_with(begins); });
  };
  EXPECT_EQ(open.unmade[0], "a is not checked: nothing pulls at it (at rest)");
  EXPECT_EQ(count(open, "a"), 1);
  EXPECT_EQ(count(open, "b"), 3);
  Result shows;
  shows.loaded.insert("anchor a");
  shows.checks.push_back(make_check("b.turn", 1, si::one, {.limit = 2, .rule = "a rule", .trust = "user"}));
  const Result made = all_of(shows);
  EXPECT_EQ(count(made, "a"), 0);
  EXPECT_EQ(count(made, "b"), 3) << "a check of another machine";
  for (const std::string& one : made.warnings) EXPECT_EQ(one.find("a is not"), std::string::npos) << one;
}

}  // namespace taut::app::swept_verdict_test
