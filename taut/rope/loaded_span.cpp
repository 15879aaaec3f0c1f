#include "taut/rope/loaded_span.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "taut/base/expects.hpp"
#include "taut/rope/catenary_shape.hpp"

namespace taut::rope {
namespace {

constexpr int most_loaded_iterations = 300;
constexpr int most_loaded_halvings = 60;
constexpr double loaded_span_closes = 1e-10;    ///< of the span's size: more is refused
constexpr double loaded_span_rounding = 1e-14;  ///< of the span's size: residuals below it are noise
constexpr double least_part =
    1e-9;  ///< of the largest tension: a straight line hanging down is treated as this far from it

/// One piece between neighbouring loads, as a rope of its own.
struct Piece {
  CatenaryRope rope;
  Vector3 along = Vector3::UnitX();  ///< horizontal direction of its tension
  CatenaryForce force;               ///< at its middle
};

/// The piece of length l whose tension at its start is T.
Piece piece_of(const CatenaryRope& rope, double l, const Vector3& T) {
  Piece p;
  p.rope = {.length = l, .weight = rope.weight, .stiffness = rope.stiffness};
  const double H = std::hypot(T.x(), T.y());
  if (H > 0) p.along = Vector3(T.x() / H, T.y() / H, 0);
  p.force = {.H = H, .V = T.z() + rope.weight * l / 2};
  return p;
}

Vector3 displacement(const Piece& p) {
  const EndPosition end = end_position(p.rope, p.force);
  return end.x * p.along + end.z * up();
}

/// d(displacement)/d(tension): the catenary's compliance in its plane, x/H across it.
Matrix3 compliance(const Piece& p) {
  // at H = 0 the compliance of a loop is infinite, as a logarithm: stay a little off
  CatenaryForce f = p.force;
  f.H = std::max(f.H, least_part * (std::abs(f.V) + p.rope.weight * p.rope.length));
  const EndPosition end = end_position(p.rope, f);
  const Vector3& e = p.along;
  const Vector3 n(-e.y(), e.x(), 0);
  const Matrix3 along = e * e.transpose(), across = n * n.transpose();
  Matrix3 C = end.dx_dH * along + (end.x / f.H) * across;
  C.col(2) += end.dx_dV * e;
  C.row(2) += end.dx_dV * e.transpose();
  C(2, 2) += end.dz_dV;
  return C;
}

/// Calls visit(piece, k, s at its start) for each piece of positive length, from the start's tension on.
template <class Visit>
void for_each_piece(const CatenaryRope& rope, const std::vector<PointLoad>& loads, Vector3 T, const Visit& visit) {
  double s = 0;
  for (std::size_t k = 0; k <= loads.size(); ++k) {
    const double end = k < loads.size() ? loads[k].s : rope.length;
    if (end > s) {
      visit(piece_of(rope, end - s, T), k, s);
      T.z() += rope.weight * (end - s);
    }
    s = end;
    if (k < loads.size()) T -= loads[k].force;
  }
}

Vector3 end_of(const LoadedSpan& span, const Vector3& force) {
  Vector3 end = Vector3::Zero();
  for_each_piece(span.rope, span.loads, force, [&](const Piece& p, std::size_t, double) { end += displacement(p); });
  return end;
}

Matrix3 compliance(const LoadedSpan& span) {
  Matrix3 C = Matrix3::Zero();
  for_each_piece(span.rope, span.loads, span.force, [&](const Piece& p, std::size_t, double) { C += compliance(p); });
  return C;
}

/// Force at the start of the rope with its loads spread evenly, with the true moment of the loads about the end.
Vector3 first_guess(const LoadedSpan& span) {
  const CatenaryRope& rope = span.rope;
  const double L = rope.length;
  Vector3 sum = Vector3::Zero(), at_start = Vector3::Zero();
  double size = 0;
  for (const PointLoad& load : span.loads) {
    sum += load.force;
    at_start += load.force * (1 - load.s / L);
    size += load.force.norm();
  }
  const double w = rope.weight + std::max(size, 1e-9) / L;
  const double x = std::hypot(span.chord.x(), span.chord.y());
  const double aside = std::max(x, 1e-3 * std::max(L, span.chord.norm()));  // off the vertical line
  const auto spread = solve_catenary({.length = L, .weight = w, .stiffness = rope.stiffness}, aside, span.chord.z());
  const Vector3 along = x > 0 ? Vector3(span.chord.x() / x, span.chord.y() / x, 0) : Vector3::UnitX();
  const CatenaryForce f = spread ? spread->force : CatenaryForce{.H = w * L, .V = 0};
  return f.H * along + (f.V - rope.weight * L / 2) * up() + at_start;
}

/// One damped step of the start's force; false when nothing is gained.
bool improve(LoadedSpan& span, Vector3& residual, double scale) {
  const Vector3 step = compliance(span).inverse() * residual;
  if (!step.allFinite()) return false;
  const double falls = residual.dot(step);
  double part = 1;
  for (int k = 0; k < most_loaded_halvings; ++k, part /= 2) {
    const Vector3 next = span.force + part * step;
    const Vector3 then = span.chord - end_of(span, next);
    if (!then.allFinite()) continue;
    const bool less_energy =
        falls > 0 && then.dot(step) >= -falls / 2 && residual.norm() > loaded_span_rounding * scale;
    if (then.norm() < residual.norm() || less_energy) {
      span.force = next;
      residual = then;
      return true;
    }
    if (residual.norm() <= loaded_span_rounding * scale) return false;
  }
  return false;
}

/// Newton from `force`; the best force met is kept.
void iterate(LoadedSpan& span, const Vector3& force, double scale) {
  span.force = force;
  Vector3 residual = span.chord - end_of(span, force);
  LoadedSpan best = span;
  best.closure = std::numeric_limits<double>::infinity();
  while (span.iterations < most_loaded_iterations) {
    if (residual.norm() < best.closure) {
      best.force = span.force;
      best.closure = residual.norm();
    }
    if (!improve(span, residual, scale)) break;
    ++span.iterations;
  }
  if (residual.norm() < best.closure) {
    best.force = span.force;
    best.closure = residual.norm();
  }
  span.force = best.force;
  span.closure = best.closure;
}

}  // namespace

tl::expected<LoadedSpan, NoCatenary> solve_loaded_span(const CatenaryRope& rope, const Vector3& chord,
                                                       std::span<const PointLoad> loads,
                                                       const std::optional<Vector3>& start) {
  expects(rope.length > 0 && std::isfinite(rope.length), "a rope has a length");
  expects(rope.weight >= 0 && std::isfinite(rope.weight) && rope.stiffness > 0, "a rope has weight and stiffness");
  expects(chord.allFinite(), "a span has finite ends");
  LoadedSpan span;
  span.rope = rope;
  span.chord = chord;
  span.loads.assign(loads.begin(), loads.end());
  std::stable_sort(span.loads.begin(), span.loads.end(), [](const auto& a, const auto& b) { return a.s < b.s; });
  for (const PointLoad& load : span.loads) {
    expects(load.s >= 0 && load.s <= rope.length && load.force.allFinite(), "a load lies on its rope");
  }
  const double scale = std::max(chord.norm(), rope.length);
  if (std::isinf(rope.stiffness) && rope.length <= chord.norm()) return tl::unexpected(NoCatenary::too_short);
  if (start && start->allFinite()) iterate(span, *start, scale);
  const bool closed = start && span.closure <= loaded_span_closes * scale;
  if (!closed) iterate(span, first_guess(span), scale);
  if (span.closure <= loaded_span_closes * scale) return span;
  return tl::unexpected(rope.weight == 0 ? NoCatenary::slack : NoCatenary::not_converged);
}

Vector3 force_on_start(const LoadedSpan& span) { return span.force; }

Vector3 force_on_end(const LoadedSpan& span) {
  Vector3 T = span.force + span.rope.weight * span.rope.length * up();
  for (const PointLoad& load : span.loads) T -= load.force;
  return -T;
}

Matrix3 stiffness(const LoadedSpan& span) {
  const Matrix3 K = compliance(span).inverse();
  return (K + K.transpose()) / 2;
}

std::vector<Vector3> length_rates(const LoadedSpan& span) {
  const std::size_t count = span.loads.size() + 1;
  std::vector<Matrix3> C(count, Matrix3::Zero());
  std::vector<Vector3> own(count, Vector3::Zero());  // of the piece's end, at a constant tension at the piece's start
  const double w = span.rope.weight;
  Vector3 T = span.force;
  double s = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double end = k < span.loads.size() ? span.loads[k].s : span.rope.length;
    const Piece p = piece_of(span.rope, end - s, T);
    if (end > s) {
      const EndRates r = end_rates(p.rope, p.force);
      C[k] = compliance(p);
      own[k] = r.dx_dlength * p.along + r.dz_dlength * up() + C[k].col(2) * (w / 2);
    } else {  // the first bit of a piece of no length
      own[k] = T / span.rope.stiffness + T.normalized();
    }
    T.z() += w * (end - s);
    s = end;
    if (k < span.loads.size()) T -= span.loads[k].force;
  }
  const Matrix3 K = stiffness(span);
  std::vector<Vector3> rates(count);
  Matrix3 behind = Matrix3::Zero();
  for (std::size_t k = count; k-- > 0;) {
    rates[k] = -K * (own[k] + behind.col(2) * w);
    behind += C[k];
  }
  return rates;
}

Vector3 tension_at(const LoadedSpan& span, double s) {
  expects(s >= 0 && s <= span.rope.length, "a point of a rope lies on it");
  Vector3 T = span.force + span.rope.weight * s * up();
  for (const PointLoad& load : span.loads) {
    if (load.s < s) T -= load.force;
  }
  return T;
}

Vector3 point_at(const LoadedSpan& span, double s) {
  expects(s >= 0 && s <= span.rope.length, "a point of a rope lies on it");
  Vector3 at = Vector3::Zero();
  for_each_piece(span.rope, span.loads, span.force, [&](const Piece& p, std::size_t, double from) {
    if (s <= from) return;
    const double part = std::min(s - from, p.rope.length);
    const RopePoint point = point_at(p.rope, p.force, part);
    at += point.x * p.along + point.z * up();
  });
  return at;
}

double largest_tension(const LoadedSpan& span) {
  double largest = std::max(span.force.norm(), force_on_end(span).norm());
  for_each_piece(span.rope, span.loads, span.force, [&](const Piece& p, std::size_t, double) {
    const double half = p.rope.weight * p.rope.length / 2;
    largest = std::max({largest, std::hypot(p.force.H, p.force.V - half), std::hypot(p.force.H, p.force.V + half)});
  });
  return largest;
}

double stretched_length(const LoadedSpan& span) {
  double length = 0;
  for_each_piece(span.rope, span.loads, span.force,
                 [&](const Piece& p, std::size_t, double) { length += stretched_length(p.rope, p.force); });
  return length;
}

}  // namespace taut::rope
