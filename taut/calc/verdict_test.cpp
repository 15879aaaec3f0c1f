#include "taut/calc/verdict.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace taut::verdict_test {

Check check(const std::string& name, double value, const std::string& trust = "verified") {
  return make_check(name, value, si::one,
                    {.sense = Sense::at_most, .limit = 1, .rule = "rule of " + name, .trust = trust});
}

VerdictKind kind_of(const Result& r) { return verdict_of(r)->kind; }

/// Passes all.
Result good() {
  Result r;
  r.checks = {check("a", 0.4), check("b", 0.9)};
  return r;
}

TEST(VerdictOf, TheFirstRowThatAppliesWins) {
  Result r = good();
  EXPECT_EQ(kind_of(r), VerdictKind::passes);
  warn_unsafe(r, "slack");
  EXPECT_EQ(kind_of(r), VerdictKind::passes_with_warnings);
  r.unjudged = {"haulback"};
  EXPECT_EQ(verdict_of(r)->verdict_class, "unasked");
  r.unmade = {"skyline: its strength is not checked"};
  EXPECT_EQ(verdict_of(r)->verdict_class, "unmade");
  r.status = Status::infeasible;
  r.message = "no equilibrium";
  EXPECT_EQ(kind_of(r), VerdictKind::no_answer);
  r.checks.push_back(check("c", 1.2));
  EXPECT_EQ(kind_of(r), VerdictKind::fails);
  EXPECT_NE(verdict_of(r)->reason.find("other states have no answer: no equilibrium"), std::string::npos);
  r.status = Status::bad_deck;
  EXPECT_FALSE(verdict_of(r));
}

TEST(VerdictOf, TheWorstFailureIsNamedFirstAndNoNumberIsWorst) {
  Result r = good();
  r.checks.push_back(check("c", 2));
  r.checks.push_back(check("d", 3));
  EXPECT_EQ(verdict_of(r)->reason.find("d "), 0U);
  EXPECT_NE(verdict_of(r)->reason.find("fails too: c"), std::string::npos);
  r.checks.push_back(check("e", std::nan("")));
  EXPECT_EQ(verdict_of(r)->reason.find("e "), 0U);
}

TEST(VerdictOf, FactsAloneAreNoLimit) {
  Result r;
  r.checks = {check("skyline.T_max", 0.2)};
  r.checks.front().limits = false;
  EXPECT_EQ(kind_of(r), VerdictKind::not_judged);
  EXPECT_EQ(exit_code(r), 0);
  EXPECT_EQ(exit_code(r, true), 4) << "strict";
  r.checks.front() = check("skyline.T_max", 1.2);
  r.checks.front().limits = false;
  EXPECT_EQ(kind_of(r), VerdictKind::fails) << "they can fail";
}

TEST(VerdictOf, AFactIsNearestToItsLimitToo) {
  Result r = good();
  r.checks.push_back(check("hoist.sheave_ratio", 0.98));
  r.checks.back().limits = false;
  EXPECT_EQ(kind_of(r), VerdictKind::passes);
  EXPECT_NE(verdict_of(r)->reason.find("nearest to its limit is hoist.sheave_ratio, utilisation 0.98"),
            std::string::npos)
      << verdict_of(r)->reason;
  r.checks.back().utilisation = std::nan("");
  EXPECT_EQ(verdict_of(r)->reason.find("sheave_ratio"), std::string::npos) << "no measure";
}

TEST(VerdictOf, AnUnverifiedLimitDecidesFromHalfOn) {
  Result r;
  r.checks = {check("a", 0.49, "UNVERIFIED: recalled")};
  EXPECT_EQ(kind_of(r), VerdictKind::passes);
  r.checks = {check("a", 0.5, "UNVERIFIED: recalled")};
  EXPECT_EQ(kind_of(r), VerdictKind::passes_with_warnings);
  r.checks.front().refused = true;
  r.checks.front().passes = false;
  EXPECT_EQ(verdict_of(r)->verdict_class, "unverified");
  EXPECT_EQ(exit_code(r), 4);
}

TEST(VerdictOf, MissingStatesAreNotJudged) {
  Result r = good();
  r.missing = {
      {.analysis = "load path", .missing = 3, .places = 96, .first = "x = 12 m", .reason = "the rope does not reach"}};
  EXPECT_EQ(verdict_of(r)->verdict_class, "unmade");
  EXPECT_NE(verdict_of(r)->reason.find("3 of 96 places, first x = 12 m"), std::string::npos);
}

TEST(VerdictOf, APublishedValueThatDecidesAndIsUnsafeIsAWarning) {
  Result r = good();
  r.comparisons.push_back({"tension", "T", si::N, 1, 2, 2, "corrected", true});
  EXPECT_EQ(kind_of(r), VerdictKind::passes) << "the corrected one decides";
  r.comparisons.back().corrected_decides = false;
  EXPECT_EQ(kind_of(r), VerdictKind::passes_with_warnings);
}

TEST(VerdictOf, SaysWhatTheDeckBreaksAndLeavesOut) {
  Result r = good();
  r.preface = "The deck breaks the skyline at 2 s";
  r.left_out = {"sweep"};
  EXPECT_EQ(verdict_of(r)->reason.find("The deck breaks the skyline at 2 s; "), 0U);
  EXPECT_NE(verdict_of(r)->reason.find("'judge: false': sweep"), std::string::npos);
}

TEST(VerdictOf, ExitCodes) {
  Result r = good();
  EXPECT_EQ(exit_code(r), 0);
  r.interrupted = true;
  EXPECT_EQ(exit_code(r), 130);
  r = good();
  r.checks.push_back(check("c", 2));
  EXPECT_EQ(exit_code(r), 4);
  r = good();
  r.status = Status::not_converged;
  EXPECT_EQ(exit_code(r), 3);
  r.checks.push_back(check("c", 2));
  EXPECT_EQ(exit_code(r), 4) << "what fails says more than what is missing";
  r.status = Status::bad_deck;
  EXPECT_EQ(exit_code(r), 2);
}

TEST(Severity, TheLastDigitsMakeNoOrderButAFailureDoes) {
  Check reached, beyond, other;
  reached.utilisation = 1 - 3e-15;
  other.utilisation = 1;
  reached.passes = other.passes = true;
  beyond.utilisation = 1 + 1e-12;
  EXPECT_EQ(severity(reached), severity(other));
  EXPECT_GT(severity(beyond), severity(other));
  other.utilisation = 1 - 1e-8;
  EXPECT_GT(severity(reached), severity(other));
  other.utilisation = std::nan("");
  EXPECT_EQ(severity(other), 0) << "no measure, and it passes";
  other.passes = false;
  EXPECT_GT(severity(other), severity(beyond));
}

TEST(IsUnverified, ByTheFirstWord) {
  EXPECT_TRUE(is_unverified("unverified"));
  EXPECT_TRUE(is_unverified("UNVERIFIED: second hand"));
  EXPECT_FALSE(is_unverified("verified"));
  EXPECT_FALSE(is_unverified(""));
}

// An angle of at most -60 deg, a length of at least 0 m: a quotient would have the wrong sign or size.
TEST(Severity, ALimitThatIsNoMeasureHasNoUtilisation) {
  const auto check = [](double value, Sense sense, double limit) {
    return make_check("a", value, si::one, {.sense = sense, .limit = limit, .rule = "", .trust = "user"});
  };
  const Check high = check(0.5, Sense::at_most, -1), low = check(-2, Sense::at_most, -1);
  EXPECT_TRUE(std::isnan(high.utilisation) && std::isnan(low.utilisation));
  EXPECT_TRUE(!high.passes && low.passes);
  EXPECT_TRUE(std::isinf(severity(high)));
  EXPECT_EQ(severity(low), 0);
  EXPECT_TRUE(std::isnan(check(-0.1, Sense::at_least, 3).utilisation));
  EXPECT_EQ(check(-1, Sense::at_most, 2).utilisation, -0.5);
}

TEST(Severity, OfTwoStatesTheWorseIsFoundWithoutUtilisations) {
  const auto left = [](double length) {
    return make_check("drum", length, si::m, {.sense = Sense::at_least, .limit = 0, .rule = "", .trust = "user"});
  };
  EXPECT_TRUE(worse_state(left(-2), left(-1)));
  EXPECT_FALSE(worse_state(left(-1), left(-2)));
  EXPECT_TRUE(worse_state(left(-1), left(5)));
  EXPECT_TRUE(worse_state(left(1), left(5)));
}

TEST(Verdict, AFailureIsSeenInItsNumbers) {
  const Check c =
      make_check("factor", 5.50911, si::one, {.sense = Sense::at_least, .limit = 5.50914, .rule = "r", .trust = ""});
  EXPECT_EQ(against_limit(c, Display()), "5.50911, limit at least 5.50914: r");
  const Check force =
      make_check("force", 279100.4, si::N, {.sense = Sense::at_most, .limit = 279100, .rule = "r", .trust = ""});
  EXPECT_EQ(against_limit(force, Display()), "279.1004 kN, limit at most 279.1 kN: r");
}

}  // namespace taut::verdict_test
