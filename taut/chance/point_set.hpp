#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "taut/chance/point.hpp"

namespace taut::chance {

/// Replicates of Latin hypercubes and scrambles of Sobol points: confidence comes from the scatter between them.
inline constexpr std::size_t least_replicates = 16;

enum class PointKind { random, latin, sobol };

/// Points of the unit cube; point `index` is a pure function of (kind, inputs, samples, seed, index), so shards and
/// threads may take them in any order. A set is immutable; all replicates are independent of each other.
///
/// random: independent numbers of a counter-based generator (see counter.hpp). One replicate.
///
/// latin: within a replicate of n points each of n equal intervals of every input has one point, at a random place of
/// it (McKay, Beckman & Conover 1979); the order of the intervals is a keyed permutation (Feistel network with cycle
/// walking), so any point is found without the others. 16 replicates of n = samples/16, rounded up.
///
/// sobol: base-2 digital net with the direction numbers of Joe & Kuo (2008), scrambled by a random lower triangular
/// matrix and a digital shift (Matousek 1998) of 52 bits, another one for each replicate and input. A replicate has
/// n = 2^k points, the largest power of two with 16 n <= samples; 16 to 32 replicates.
class PointSet {
 public:
  /// `samples` >= 1 is rounded up to whole replicates: see size(). inputs: 1 to 3666 (the table of directions).
  PointSet(PointKind kind, std::size_t inputs, std::uint64_t samples, std::uint64_t seed);

  PointKind kind() const { return kind_; }
  std::size_t inputs() const { return inputs_; }
  std::uint64_t size() const { return replicates_ * per_replicate_; }
  /// Replicate r holds the points r per_replicate() to (r + 1) per_replicate() - 1.
  std::size_t replicates() const { return replicates_; }
  std::uint64_t per_replicate() const { return per_replicate_; }

  /// index < size(); one number for each input, 0 < p < 1.
  Point at(std::uint64_t index) const;

 private:
  double latin(std::size_t replicate, std::uint64_t index, std::uint32_t input) const;

  PointKind kind_;
  std::size_t inputs_;
  std::uint64_t seed_;
  std::size_t replicates_ = 1;
  std::uint64_t per_replicate_ = 0;
  std::size_t digits_ = 0;                 // of the index of a Sobol point
  std::vector<std::uint64_t> directions_;  // scrambled: shift, then `digits_`, by replicate and input
};

/// The cases of a full grid: `sizes` places of each input (>= 1), the last input runs first. Number of cases: the
/// product, 0 where it exceeds 2^63.
std::uint64_t grid_size(const std::vector<std::uint64_t>& sizes);
/// The place of each input in case `index` < grid_size.
std::vector<std::uint64_t> grid_places(const std::vector<std::uint64_t>& sizes, std::uint64_t index);

/// i -> a permutation of 0 .. n-1, i < n, chosen by the key; without a table.
std::uint64_t shuffled(std::uint64_t i, std::uint64_t n, std::uint64_t key);

}  // namespace taut::chance
