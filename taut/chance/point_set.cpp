#include "taut/chance/point_set.hpp"

#include <algorithm>
#include <bit>
#include <boost/random/sobol.hpp>
#include <limits>

#include "taut/base/expects.hpp"
#include "taut/chance/counter.hpp"

namespace taut::chance {
namespace {

constexpr std::size_t bits = 52;  // of a coordinate

/// The finaliser of SplitMix64 (Steele, Lea & Flood 2014).
std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EB;
  return x ^ (x >> 31);
}

std::uint64_t ones(std::size_t count) { return count == 0 ? 0 : ~std::uint64_t{0} >> (64 - count); }

/// The first `digits` direction numbers of an input as numbers of 52 bits (Joe & Kuo 2008, equations 2 and 3).
std::vector<std::uint64_t> sobol_directions(std::size_t input, std::size_t digits) {
  using Table = boost::random::default_sobol_table;
  std::vector<std::uint64_t> m(digits, 1);
  if (input > 0) {
    const std::uint64_t polynomial = Table::polynomial(input - 1);
    const auto degree = static_cast<std::size_t>(std::bit_width(polynomial)) - 1;
    for (std::size_t j = 0; j < std::min(degree, digits); ++j) m[j] = Table::minit(input - 1, j);
    for (std::size_t j = degree; j < digits; ++j) {
      m[j] = m[j - degree];
      for (std::size_t k = 1; k <= degree; ++k) {
        if ((polynomial >> (degree - k)) & 1) m[j] ^= m[j - k] << k;
      }
    }
  }
  for (std::size_t j = 0; j < digits; ++j) m[j] <<= bits - 1 - j;
  return m;
}

}  // namespace

std::uint64_t shuffled(std::uint64_t i, std::uint64_t n, std::uint64_t key) {
  const auto width = static_cast<std::size_t>(std::bit_width(n - 1));
  const std::size_t right = (width + 1) / 2;
  const std::size_t left = width - right;
  do {
    std::uint64_t a = i >> right;
    std::uint64_t b = i & ones(right);
    for (std::uint64_t round = 1; round <= 6; ++round) {
      a ^= mixed(b ^ mixed(key + 2 * round)) & ones(left);
      b ^= mixed(a ^ mixed(key + 2 * round + 1)) & ones(right);
    }
    i = (a << right) | b;
  } while (i >= n);
  return i;
}

PointSet::PointSet(PointKind kind, std::size_t inputs, std::uint64_t samples, std::uint64_t seed)
    : kind_(kind), inputs_(inputs), seed_(seed) {
  expects(inputs >= 1 && samples >= 1 && samples < (std::uint64_t{1} << 48), "points of at least one input");
  if (kind == PointKind::random) {
    per_replicate_ = samples;
    return;
  }
  const std::uint64_t wanted = std::max<std::uint64_t>(samples, least_replicates);
  if (kind == PointKind::latin) {
    replicates_ = least_replicates;
    per_replicate_ = (wanted + replicates_ - 1) / replicates_;
    return;
  }
  expects(inputs < boost::random::default_sobol_table::max_dimension, "no direction numbers for so many inputs");
  per_replicate_ = std::bit_floor(wanted / least_replicates);
  replicates_ = static_cast<std::size_t>((wanted + per_replicate_ - 1) / per_replicate_);
  digits_ = static_cast<std::size_t>(std::bit_width(per_replicate_)) - 1;
  directions_.reserve(replicates_ * inputs * (digits_ + 1));
  std::vector<std::vector<std::uint64_t>> plain(inputs);
  for (std::size_t i = 0; i < inputs; ++i) plain[i] = sobol_directions(i, digits_);
  for (std::uint32_t r = 0; r < replicates_; ++r) {
    for (std::uint32_t i = 0; i < inputs; ++i) {
      directions_.push_back(random_bits(seed, Use::shift, r, 0, i) >> 12);
      // row k of the triangular matrix: 1 on the diagonal, random to the left of it
      std::vector<std::uint64_t> rows(bits);
      for (std::size_t k = 0; k < bits; ++k) {
        const std::uint64_t diagonal = std::uint64_t{1} << (bits - 1 - k);
        const std::uint64_t before = ones(bits) & ~(diagonal | (diagonal - 1));
        rows[k] = diagonal | (random_bits(seed, Use::scramble, r, k, i) & before);
      }
      for (std::size_t j = 0; j < digits_; ++j) {
        std::uint64_t scrambled = 0;
        for (std::size_t k = 0; k < bits; ++k) {
          scrambled = (scrambled << 1) | (static_cast<std::uint64_t>(std::popcount(rows[k] & plain[i][j])) & 1);
        }
        directions_.push_back(scrambled);
      }
    }
  }
}

double PointSet::latin(std::size_t replicate, std::uint64_t index, std::uint32_t input) const {
  const auto r = static_cast<std::uint32_t>(replicate);
  const std::uint64_t place = shuffled(index, per_replicate_, random_bits(seed_, Use::shuffle, r, 0, input));
  const double within = unit(random_bits(seed_, Use::jitter, r, index, input));
  const double p = (static_cast<double>(place) + within) / static_cast<double>(per_replicate_);
  return std::min(p, 1 - 0x1p-53);
}

Point PointSet::at(std::uint64_t index) const {
  expects(index < size(), "an index of the set");
  Point point(inputs_);
  const auto replicate = static_cast<std::size_t>(index / per_replicate_);
  const std::uint64_t within = index % per_replicate_;
  for (std::uint32_t i = 0; i < inputs_; ++i) {
    if (kind_ == PointKind::random) {
      point[i] = unit(random_bits(seed_, Use::points, 0, index, i));
    } else if (kind_ == PointKind::latin) {
      point[i] = latin(replicate, within, i);
    } else {
      const std::uint64_t* direction = &directions_[(replicate * inputs_ + i) * (digits_ + 1)];
      std::uint64_t x = *direction++;
      for (std::uint64_t rest = within; rest != 0; rest >>= 1, ++direction) {
        if (rest & 1) x ^= *direction;
      }
      point[i] = unit(x << 12);
    }
  }
  return point;
}

std::uint64_t grid_size(const std::vector<std::uint64_t>& sizes) {
  std::uint64_t all = 1;
  for (const std::uint64_t n : sizes) {
    expects(n >= 1, "a grid has at least one place of each input");
    if (all > std::uint64_t(std::numeric_limits<std::int64_t>::max()) / n) return 0;
    all *= n;
  }
  return all;
}

std::vector<std::uint64_t> grid_places(const std::vector<std::uint64_t>& sizes, std::uint64_t index) {
  expects(index < grid_size(sizes), "an index of the grid");
  std::vector<std::uint64_t> places(sizes.size());
  for (std::size_t i = sizes.size(); i-- > 0; index /= sizes[i]) places[i] = index % sizes[i];
  return places;
}

}  // namespace taut::chance
