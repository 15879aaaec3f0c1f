#include "taut/study/deck/missing.hpp"

#include <gtest/gtest.h>

namespace taut::study::missing_test {

TEST(Stretches, NeighbouringStatesAreOne) {
  Stretches s;
  EXPECT_FALSE(s.any());
  const auto take = [&](const std::string& why, const std::string& words, const std::string& analysis) {
    s.take(why, words, analysis);
  };
  take("", "load path, in, x = 10 m", "load_path");
  EXPECT_FALSE(s.any());
  take("it slips", "load path, in, x = 12 m", "load_path");
  EXPECT_EQ(s.words(), "load path, in, x = 12 m: it slips");
  take("it falls", "load path, in, x = 14 m", "load_path");
  take("it falls", "load path, in, x = 16 m", "load_path");
  EXPECT_EQ(s.words(), "load path, in, x = 12 m to x = 16 m (3 states): it slips");
  EXPECT_EQ(s.words_of_first(), s.words());
  take("", "load path, in, x = 18 m", "load_path");
  take("it slips", "load path, in, x = 20 m", "load_path");
  take("it slips", "payload, x = 20 m", "payload");  // another analysis, another stretch
  EXPECT_EQ(s.words(), "load path, in, x = 12 m to x = 16 m (3 states); x = 20 m; payload, x = 20 m: it slips");
  EXPECT_EQ(s.words_of_first(), "load path, in, x = 12 m to x = 16 m (3 states) and on 2 more stretches: it slips");
}

TEST(Stretches, OneStateAndOneMore) {
  Stretches s;
  s.take("it slips", "equilibrium, at rest", "equilibrium");
  s.take("", "sweep, m = 1 t", "sweep");
  s.take("it slips", "sweep, m = 2 t", "sweep");
  EXPECT_EQ(s.words_of_first(), "equilibrium, at rest and on 1 more stretch: it slips");
}

// Every place that is missing is named, those beside each other as one range.
TEST(Missing, AllPlacesAreNamed) {
  Missing missing;
  const Outcome no = infeasible("the rope does not reach");
  for (const double x : {10.0, 12.0, 14.0, 16.0, 18.0}) missing.take(x == 12 || x == 14 || x == 18 ? no : Outcome{}, x);
  Result r;
  missing.note(r, "payload, in", true);
  ASSERT_EQ(r.warnings.size(), 1U);
  EXPECT_EQ(r.warnings[0],
            "payload, in: no equilibrium at 3 of 5 places, x = 12 m to x = 14 m (2 states); x = 18 m; the first: the "
            "rope does not reach");
  ASSERT_EQ(r.missing.size(), 1U);
  EXPECT_EQ(r.missing[0].first, "x = 12 m");
}

TEST(Missing, OnePlaceHasItsOwnReason) {
  Missing missing;
  missing.take(infeasible("no room"), 10);
  missing.take(Outcome{}, 12);
  Result r;
  missing.note(r, "envelope", false);
  EXPECT_EQ(r.warnings[0], "envelope: no equilibrium at 1 of 2 places, x = 10 m: no room");
  EXPECT_TRUE(r.missing.empty());
}

}  // namespace taut::study::missing_test
