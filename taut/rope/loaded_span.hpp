#pragma once
#include <optional>
#include <span>
#include <tl/expected.hpp>
#include <vector>

#include "taut/math/vector.hpp"
#include "taut/rope/catenary.hpp"

namespace taut::rope {

/// A force on a rope at one point of its material.
struct PointLoad {
  double s = 0;                     ///< unstretched length from the rope's start, m, 0 <= s <= length
  Vector3 force = Vector3::Zero();  ///< on the rope, N; a hanging weight P is (0, 0, -P)
};

/// A rope between two points of space with point loads, solved: a chain of catenaries. All SI, z up.
/// `force`: tension at the start as a vector along the rope, towards its end. Behind a load the tension is less by the
/// load vector, so V+ = V- + P behind a weight P; over the length s it grows by w s upwards.
struct LoadedSpan {
  CatenaryRope rope;
  Vector3 chord = Vector3::Zero();  ///< end - start, m
  std::vector<PointLoad> loads;     ///< in the order of s
  Vector3 force = Vector3::Zero();  ///< N
  double closure = 0;               ///< distance of the computed end from the given one, m
  int iterations = 0;
};

/// The span of `rope` over `chord` under `loads` (any order, any direction). The place of the end is the gradient of
/// the complementary energy, which is convex in the force at the start: damped Newton, one solution. too_short: an
/// inextensible rope not longer than the chord. slack: a weightless rope with a part that carries nothing. `start`:
/// force at the start of a nearby solution.
tl::expected<LoadedSpan, NoCatenary> solve_loaded_span(const CatenaryRope& rope, const Vector3& chord,
                                                       std::span<const PointLoad> loads,
                                                       const std::optional<Vector3>& start = std::nullopt);

/// Forces of the rope on what holds its ends, N. Their sum is the rope's weight and the loads.
Vector3 force_on_start(const LoadedSpan& span);
Vector3 force_on_end(const LoadedSpan& span);

/// d(force_on_start)/d(chord) = -d(force_on_end)/d(chord), loads constant, N/m.
Matrix3 stiffness(const LoadedSpan& span);

/// d(force_on_start)/d(unstretched length of the k-th piece), N/m. Piece k lies before load k, the last one behind all;
/// the loads stay, and with them the other pieces' lengths. force_on_end changes by the opposite and by -w upwards.
std::vector<Vector3> length_rates(const LoadedSpan& span);

/// Tension as a vector along the rope at the unstretched length s; at a load, the one just before it. N.
Vector3 tension_at(const LoadedSpan& span, double s);
/// Place of the point at the unstretched length s, seen from the start, m.
Vector3 point_at(const LoadedSpan& span, double s);
/// Largest tension in the rope, N: at an end or beside a load.
double largest_tension(const LoadedSpan& span);
/// Length under load, m.
double stretched_length(const LoadedSpan& span);

}  // namespace taut::rope
