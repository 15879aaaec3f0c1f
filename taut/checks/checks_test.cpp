#include "taut/checks/checks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "taut/calc/verdict.hpp"
#include "test/support/guyed_decks.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::checks::checks_test {

using taut_test::check_of;
using taut_test::guyed;
using taut_test::run_text;

Result two_checks() {
  Result r;
  r.checks.push_back(
      make_check("a.safety_factor", 5, si::one,
                 {.sense = Sense::at_least, .limit = 4, .rule = "by practice", .trust = "UNVERIFIED: recalled"}));
  r.checks.push_back(make_check("a.termination", 5, si::one,
                                {.sense = Sense::at_least, .limit = 4, .rule = "WAC", .trust = "verified"}));
  return r;
}

TEST(Checks, what_is_unverified_can_be_refused) {
  ChecksRequest request;
  request.refuse_unverified = true;
  Result r = two_checks();
  finish_checks(request, r);
  EXPECT_FALSE(check_of(r, "a.safety_factor").passes);
  EXPECT_TRUE(std::isnan(check_of(r, "a.safety_factor").limit));
  EXPECT_NE(check_of(r, "a.safety_factor").rule.find("(4 1)"), std::string::npos);  // the number that was not accepted
  EXPECT_TRUE(check_of(r, "a.termination").passes);
  EXPECT_TRUE(check_of(r, "a.safety_factor").refused);
  EXPECT_EQ(verdict_of(r)->verdict_class, "unverified");
}

/// A refused limit has no utilisation; it must not give way to one that passes.
TEST(Checks, of_one_name_the_one_that_fails_stays) {
  for (const bool refused_first : {true, false}) {
    Result r = two_checks();
    r.checks[1].name = r.checks[0].name;
    if (!refused_first) std::swap(r.checks[0], r.checks[1]);
    r.checks.push_back(make_check("a.safety_factor", 4.1, si::one,
                                  {.sense = Sense::at_least, .limit = 4, .rule = "own", .trust = "user"}));
    ChecksRequest request;
    request.refuse_unverified = true;
    finish_checks(request, r);
    ASSERT_EQ(r.checks.size(), 1U);
    EXPECT_TRUE(r.checks[0].refused);
    EXPECT_FALSE(r.checks[0].passes);
  }
  Result r = two_checks();
  r.checks[1].name = r.checks[0].name;
  r.checks[1].utilisation = 0.99;
  finish_checks({}, r);
  ASSERT_EQ(r.checks.size(), 1U);
  EXPECT_EQ(r.checks[0].utilisation, 0.99);
}

TEST(Checks, what_the_user_has_confirmed_rests_on_his_word) {
  ChecksRequest request;
  request.refuse_unverified = true;
  request.confirmed = {"practice", "EN 1234"};
  Result r = two_checks();
  finish_checks(request, r);
  EXPECT_TRUE(check_of(r, "a.safety_factor").passes);
  EXPECT_EQ(check_of(r, "a.safety_factor").trust, "user: confirmed in the deck ('practice')");
  EXPECT_EQ(check_of(r, "a.termination").trust, "verified");
  EXPECT_TRUE(r.message.empty());
  ASSERT_EQ(r.warnings.size(), 1U);
  EXPECT_NE(r.warnings[0].find("EN 1234"), std::string::npos);
}

// From a deck: a mast by EN 1993-1-1, of which class limits and curves are as recalled.
TEST(Checks, refused_and_confirmed_in_a_deck) {
  const std::string masts = "  refuse_unverified: true\n  masts: {mast: {load_factor: 1.35}}\n";
  const Result refused = run_text(guyed(masts));
  EXPECT_EQ(exit_code(refused), 4);
  EXPECT_FALSE(check_of(refused, "mast.buckling").passes);
  EXPECT_EQ(verdict_of(refused)->verdict_class, "unverified");
  EXPECT_NE(verdict_of(refused)->reason.find("'confirmed'"), std::string::npos);
  const Result confirmed = run_text(guyed("  confirmed: [EN 1993-1-1]\n" + masts));
  EXPECT_EQ(exit_code(confirmed), 0) << confirmed.message;
  EXPECT_TRUE(check_of(confirmed, "mast.buckling").passes);
}

// The empty text is in every rule, "EN" in most of them.
TEST(Checks, what_is_exempt_is_a_part_of_the_machine) {
  const Result r = run_text(guyed("  exempt: [gui]\n"));
  EXPECT_NE(to_text(r.errors).find("checks.exempt[0]: the machine has no part 'gui'"), std::string::npos)
      << to_text(r.errors);
}

TEST(Checks, what_confirms_names_a_source) {
  for (const char* text : {"''", "' '", "EN"}) {
    const Result r = run_text(guyed("  confirmed: [" + std::string(text) + "]\n"));
    ASSERT_EQ(r.status, Status::bad_deck) << text;
    EXPECT_NE(to_text(r.errors).find("names no source"), std::string::npos) << to_text(r.errors);
  }
}

// A check may rest on several unverified numbers: each is confirmed by its own source.
TEST(Checks, a_source_confirms_its_own_numbers_alone) {
  const std::vector<Doubt> doubts = {{.trust = "UNVERIFIED: recalled", .source = "D/d (ISO 4308-1)"},
                                     {.trust = "UNVERIFIED: breaking force", .source = "breaking force, GOST 2688-80"}};
  const auto trust = [&](const std::vector<std::string>& confirmed) {
    Result r;
    r.checks.push_back(make_check("hoist.safety_factor", 5, si::one,
                                  {.sense = Sense::at_least,
                                   .limit = 4,
                                   .rule = "breaking force 160 kN over 40 kN: ISO 4308-1",
                                   .trust = doubts[0].trust,
                                   .doubts = doubts}));
    ChecksRequest request;
    request.confirmed = confirmed;
    finish_checks(request, r);
    EXPECT_TRUE(r.warnings.empty());
    return r.checks[0].trust;
  };
  EXPECT_EQ(trust({"ISO 4308"}), "UNVERIFIED: breaking force");
  EXPECT_EQ(trust({"GOST 2688"}), "UNVERIFIED: recalled");
  EXPECT_EQ(trust({"ISO 4308", "GOST 2688"}), "user: confirmed in the deck ('GOST 2688')");
  EXPECT_EQ(trust({"hoist.safety_factor"}), "user: confirmed in the deck ('hoist.safety_factor')");
}

}  // namespace taut::checks::checks_test
