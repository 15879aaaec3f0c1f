#include "taut/chance/counter.hpp"

namespace taut::chance {

std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key) {
  constexpr std::uint64_t m0 = 0xD2511F53;
  constexpr std::uint64_t m1 = 0xCD9E8D57;
  constexpr std::uint32_t w0 = 0x9E3779B9;  // the golden ratio
  constexpr std::uint32_t w1 = 0xBB67AE85;  // sqrt(3) - 1
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t a = m0 * counter[0];
    const std::uint64_t b = m1 * counter[2];
    counter = {static_cast<std::uint32_t>(b >> 32) ^ counter[1] ^ key[0], static_cast<std::uint32_t>(b),
               static_cast<std::uint32_t>(a >> 32) ^ counter[3] ^ key[1], static_cast<std::uint32_t>(a)};
    key[0] += w0;
    key[1] += w1;
  }
  return counter;
}

std::uint64_t random_bits(std::uint64_t seed, Use use, std::uint32_t replicate, std::uint64_t index,
                          std::uint32_t column) {
  const auto low = [](std::uint64_t x) { return static_cast<std::uint32_t>(x); };
  const auto block =
      philox({low(index), low(index >> 32), column / 2, (replicate << 8) | static_cast<std::uint32_t>(use)},
             {low(seed), low(seed >> 32)});
  const std::uint32_t half = column % 2 * 2;
  return (static_cast<std::uint64_t>(block[half]) << 32) | block[half + 1];
}

double unit(std::uint64_t bits) { return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52; }

}  // namespace taut::chance
