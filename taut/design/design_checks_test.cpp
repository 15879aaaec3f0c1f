#include "taut/design/design_checks.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace taut::design::design_checks_test {

Check check(const char* name, double value, Sense sense, double limit, const char* part = "") {
  Check c = make_check(name, value, si::N, {.sense = sense, .limit = limit, .rule = "rule", .trust = "user"});
  c.part = part;
  return c;
}

TEST(DesignChecks, the_worst_that_fails_governs) {
  Result r;
  r.checks = {check("a", 0.8, Sense::at_most, 1), check("b", 4, Sense::at_least, 3)};
  EXPECT_TRUE(trial_of(r).passes);
  EXPECT_EQ(trial_of(r).governs, "a");
  r.checks.push_back(check("slack", -5, Sense::at_least, 3));  // a ratio of -0.6 is no reserve
  EXPECT_FALSE(trial_of(r).passes);
  EXPECT_EQ(trial_of(r).governs, "slack");
  EXPECT_GT(trial_of(r).utilisation, 1);
  r.status = Status::infeasible;
  r.message = "no equilibrium";
  EXPECT_TRUE(std::isnan(trial_of(r).utilisation));
}

// As many at every place, by name; <= 0 where the check passes, whatever its sense and sign.
TEST(DesignChecks, constraints_keep_their_places) {
  CheckConstraints constraints;
  Result first;
  first.checks = {check("a", 0.8, Sense::at_most, 1), check("b", 4, Sense::at_least, 3),
                  check("a", 2, Sense::at_most, 1)};
  const auto at_first = constraints.of(first);
  ASSERT_EQ(at_first.size(), 4U);
  Result then;
  then.checks = {check("new", 3, Sense::at_most, 2), check("b", -1, Sense::at_least, 3),
                 check("a", 1, Sense::at_most, 1), check("nan", std::nan(""), Sense::at_most, 2)};
  const auto over = constraints.of(then);
  ASSERT_EQ(over.size(), 4U);
  EXPECT_NEAR(at_first[0], -0.2, 1e-12);
  EXPECT_NEAR(at_first[1], -0.25, 1e-12);
  EXPECT_NEAR(at_first[2], 1, 1e-12);
  EXPECT_EQ(over[0], 0);
  EXPECT_GT(over[1], 0);
  EXPECT_LT(over[2], -1);  // not there: kept
  EXPECT_EQ(over[3], 10);  // the worst of all that are new; NaN never passes
  EXPECT_EQ(constraints.nothing(), std::vector<double>(4, 10));
}

// A candidate that fails by 1.5 with every other choice is left out after two of them; one that others help is not.
TEST(DesignChecks, hopeless_candidates) {
  const std::map<std::string, std::size_t> list_of = {{"rope", 0}, {"mast", 1}};
  const auto result = [](double rope, double mast) {
    Result r;
    r.checks = {check("rope.T", rope, Sense::at_most, 1, "rope"), check("mast.N", mast, Sense::at_most, 1, "mast"),
                check("else", 9, Sense::at_most, 1)};
    return r;
  };
  CandidateRecord steady(list_of);
  steady.take({0, 0}, result(1.5, 0.9));
  EXPECT_FALSE(steady.hopeless({0, 1}));
  steady.take({0, 1}, result(1.52, 0.8));
  ASSERT_TRUE(steady.hopeless({0, 2}));
  EXPECT_EQ(steady.hopeless({0, 2})->governs, "rope.T");
  EXPECT_FALSE(steady.hopeless({0, 2})->passes);
  EXPECT_FALSE(steady.hopeless({1, 0}));
  CandidateRecord helped(list_of);
  helped.take({0, 0}, result(2, 0.9));
  helped.take({0, 1}, result(1.5, 0.8));  // what else is chosen matters by a third
  EXPECT_FALSE(helped.hopeless({0, 2}));
  CandidateRecord alone(list_of);
  alone.take({0}, result(5, 5));
  alone.take({0}, result(5, 5));
  EXPECT_FALSE(alone.hopeless({0}));
}

}  // namespace taut::design::design_checks_test
