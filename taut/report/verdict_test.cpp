#include "taut/report/verdict.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace verdict_test {

using namespace taut;
using namespace taut::report;

Result with_check(double value) {
  Result r;
  r.checks = {
      make_check("a", value, si::one, {.sense = Sense::at_most, .limit = 1, .rule = "rule", .trust = "verified"})};
  return r;
}

TEST(Banner, ColourWordAndSentenceFollowTheVerdict) {
  EXPECT_EQ(banner(with_check(0.5)).mood, Mood::good);
  EXPECT_EQ(banner(with_check(0.5)).headline, "Passes");
  EXPECT_EQ(banner(with_check(2)).mood, Mood::bad);
  EXPECT_EQ(banner(with_check(2)).headline, "Fails");
  EXPECT_EQ(banner(Result{}).mood, Mood::neutral) << "nothing is checked";
  EXPECT_EQ(banner(Result{}).headline, "Not judged");
  Result doubtful = with_check(0.5);
  warn_unsafe(doubtful, "the haulback is slack");
  EXPECT_EQ(banner(doubtful).mood, Mood::warning);
  EXPECT_NE(banner(doubtful).detail.find("haulback"), std::string::npos);
}

TEST(Banner, ADeckWithMistakesHasNoVerdict) {
  Result r;
  r.status = Status::bad_deck;
  r.errors.resize(2);
  EXPECT_EQ(banner(r).headline, "The deck has 2 mistakes");
}

TEST(Banner, SaysWhatTheVerdictLeavesOut) {
  Result r = with_check(0.5);
  r.exempt = {"drop"};
  r.beside = {"anchors head, tail"};
  EXPECT_NE(banner(r).scope.find("drop"), std::string::npos);
  EXPECT_NE(banner(r).scope.find("anchors head, tail"), std::string::npos);
}

TEST(Banner, Utilisation) {
  EXPECT_EQ(utilisation_text(0.8234), "0.823");
  EXPECT_EQ(utilisation_text(0.96), "0.960");
  EXPECT_EQ(utilisation_text(1), "1.00");
  EXPECT_EQ(utilisation_text(250), "250");
  EXPECT_EQ(utilisation_text(1e-5), "< 0.001");
  EXPECT_EQ(utilisation_text(0), "0");
  EXPECT_EQ(utilisation_text(std::nan("")), "-");
}

}  // namespace verdict_test
