#include "taut/chance/counter.hpp"

#include <gtest/gtest.h>

#include <set>

namespace taut::chance::counter_test {

// The known answers that the authors publish with their library (Random123, kat_vectors).
TEST(Counter, known_answers_of_philox) {
  using Block = std::array<std::uint32_t, 4>;
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), (Block{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  constexpr std::uint32_t f = 0xffffffff;
  EXPECT_EQ(philox({f, f, f, f}, {f, f}), (Block{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Block{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Counter, every_argument_counts) {
  std::set<std::uint64_t> seen;
  for (const std::uint64_t seed : {0ULL, 1ULL, 1ULL << 40}) {
    for (const Use use : {Use::points, Use::shift}) {
      for (const std::uint32_t replicate : {0U, 1U}) {
        for (const std::uint64_t index : {0ULL, 1ULL, 1ULL << 40}) {
          for (const std::uint32_t column : {0U, 1U, 2U}) {
            EXPECT_TRUE(seen.insert(random_bits(seed, use, replicate, index, column)).second);
          }
        }
      }
    }
  }
}

TEST(Counter, unit_is_open) {
  EXPECT_EQ(unit(0), 0x1p-53);
  EXPECT_EQ(unit(~std::uint64_t{0}), 1 - 0x1p-53);
}

}  // namespace taut::chance::counter_test
