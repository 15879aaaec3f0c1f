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

}  // namespace taut::study::missing_test
