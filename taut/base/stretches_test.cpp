#include "taut/base/stretches.hpp"

#include <gtest/gtest.h>

namespace taut::stretches_test {

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

/// Of five stretches and more the first and the last are named.
TEST(Stretches, OfManyTheFirstAndTheLast) {
  Stretches s;
  for (int i = 0; i < 4; ++i) {
    s.take("it slips", "x = " + std::to_string(i) + " m", "");
    s.take("", "", "");
  }
  EXPECT_EQ(s.few_places(), "x = 0 m; x = 1 m; x = 2 m; x = 3 m");
  s.take("it slips", "x = 4 m", "");
  s.take("it slips", "x = 5 m", "");
  EXPECT_EQ(s.few_places(), "x = 0 m; and on 4 more stretches, the last x = 4 m to x = 5 m (2 states)");
  EXPECT_EQ(s.places(), "x = 0 m; x = 1 m; x = 2 m; x = 3 m; x = 4 m to x = 5 m (2 states)");
}

}  // namespace taut::stretches_test
