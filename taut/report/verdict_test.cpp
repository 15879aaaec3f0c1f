#include "taut/report/verdict.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace verdict_test {

using namespace taut;
using namespace taut::report;

Check check(const std::string& name, double value, const std::string& trust = "verified") {
  return make_check(name, value, Sense::at_most, 1, si::one, "rule", trust);
}

TEST(Verdict, NamesTheWorstFailingCheckFirst) {
  Result r;
  r.checks = {check("a", 0.5), check("b", 1.1), check("c", 2), check("d", std::nan(""))};
  const Verdict v = verdict(r);
  EXPECT_EQ(v.mood, Mood::bad);
  EXPECT_EQ(v.headline, "Fails 3 of 4 checks");
  EXPECT_LT(v.detail.find("d ("), v.detail.find("c ("));
  EXPECT_LT(v.detail.find("c ("), v.detail.find("b ("));
  EXPECT_EQ(v.detail.find("a ("), std::string::npos);
}

TEST(Verdict, NamesTheClosestWhenAllPass) {
  Result r;
  r.checks = {check("a", 0.5), check("b", 0.9)};
  EXPECT_EQ(verdict(r).mood, Mood::good);
  EXPECT_EQ(verdict(r).detail, "Closest to its limit: b (utilisation 0.9).");
  r.checks.pop_back();
  EXPECT_EQ(verdict(r).headline, "Passes its check");
}

TEST(Verdict, SaysWhenALimitIsUnverified) {
  Result r;
  r.checks = {check("a", 0.5, "UNVERIFIED: second hand")};
  EXPECT_NE(verdict(r).detail.find("unverified limit"), std::string::npos);
  EXPECT_TRUE(is_unverified("unverified"));
  EXPECT_FALSE(is_unverified("verified"));
  EXPECT_FALSE(is_unverified(""));
}

TEST(Verdict, OtherEndsCarryTheirMessage) {
  Result r;
  EXPECT_EQ(verdict(r).headline, "Computed");
  r.message = "slack rope: raise the pretension";
  for (const Status s : {Status::infeasible, Status::not_converged, Status::bad_deck}) {
    r.status = s;
    EXPECT_EQ(verdict(r).mood, Mood::bad);
    EXPECT_NE(verdict(r).detail.find("slack rope"), std::string::npos);
  }
}

TEST(Verdict, Utilisation) {
  EXPECT_EQ(utilisation_text(0.8234), "0.823");
  EXPECT_EQ(utilisation_text(1e-5), "< 0.001");
  EXPECT_EQ(utilisation_text(0), "0");
  EXPECT_EQ(utilisation_text(std::nan("")), "-");
}

}  // namespace verdict_test
