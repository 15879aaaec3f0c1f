#include "taut/app/explain/terms.hpp"

#include <gtest/gtest.h>

#include <map>

namespace taut::app::terms_test {

TEST(Terms, EachHasAPathWordsAndAPlace) {
  std::map<Term::Kind, int> count;
  for (const Term& t : terms()) {
    ++count[t.kind];
    EXPECT_FALSE(t.path.empty());
    EXPECT_FALSE(t.place.empty()) << t.path;
    EXPECT_EQ(t.kind == Term::Kind::key, t.field != nullptr) << t.path;
    EXPECT_EQ(t.kind == Term::Kind::rule, t.rule != nullptr) << t.path;
  }
  EXPECT_EQ(count.size(), 5U);
  EXPECT_GT(count[Term::Kind::key], 500);
  EXPECT_GT(count[Term::Kind::rule], 200);
}

TEST(Terms, FitTheNamesThatPeopleWrite) {
  const char* const length = "machine.reevings[].length";
  EXPECT_EQ(fit_of("machine.reevings.length", length), Fit::whole);
  EXPECT_EQ(fit_of("machine.reevings[0].length", length), Fit::whole);
  EXPECT_EQ(fit_of("reevings.length", length), Fit::tail);
  EXPECT_EQ(fit_of("Length", length), Fit::tail);
  EXPECT_EQ(fit_of("reevings.skyline.length", length), Fit::by_name);
  EXPECT_EQ(fit_of("reevings", length), Fit::below);
  EXPECT_EQ(fit_of("sheaves.length", length), Fit::by_name) << "a name may be any word";
  EXPECT_EQ(fit_of("drums.core.length", length), Fit::none);
  EXPECT_EQ(fit_of("skyline.T_max", "ROPE.T_max"), Fit::by_name);
  EXPECT_EQ(fit_of("friction", "machine.contacts[].static_friction"), Fit::part);
  EXPECT_EQ(fit_of("fric", "machine.contacts[].static_friction"), Fit::none);
  EXPECT_EQ(fit_of("safety.skyline", "safety.skyline.ch"), Fit::below);
  EXPECT_EQ(fit_of("safety.skyline.ch", "safety.skyline.ch"), Fit::whole);
  EXPECT_EQ(fit_of("", length), Fit::none);
  EXPECT_EQ(fit_of("..", length), Fit::none);
}

}  // namespace taut::app::terms_test
