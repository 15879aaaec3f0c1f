#pragma once
#include <array>
#include <cstdint>

namespace taut::chance {

/// What a random number is for. Numbers of two uses are independent of each other at the same seed.
enum class Use : std::uint32_t { points, shuffle, jitter, scramble, shift, importance, plain, screen };

/// Philox 4x32-10: a bijection of 128 bits under a key of 64, the counter-based generator of Salmon, Moraes, Dror and
/// Shaw, "Parallel random numbers: as easy as 1, 2, 3", SC11 (2011), section 3.3. Passes BigCrush.
std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key);

/// 64 random bits as a pure function of seed, use, replicate (below 2^24), index and column.
std::uint64_t random_bits(std::uint64_t seed, Use use, std::uint32_t replicate, std::uint64_t index,
                          std::uint32_t column);

/// The upper 52 of 64 bits as a number of the unit interval: (k + 1/2)/2^52, so 0 < p < 1 and 1 - p is exact.
double unit(std::uint64_t bits);

}  // namespace taut::chance
