#include "taut/rope/span.hpp"

#include <algorithm>
#include <cmath>

#include "taut/base/expects.hpp"
#include "taut/rope/catenary_shape.hpp"

namespace taut::rope {
namespace {

double half_weight(const Span& span) { return span.rope.weight * span.rope.length / 2; }

/// (H, V) of the span's plane as a vector of space.
Vector3 in_space(const Span& span, double H, double V) { return H * span.along + V * up(); }

}  // namespace

tl::expected<Span, NoCatenary> solve_span(const CatenaryRope& rope, const Vector3& chord,
                                          const std::optional<CatenaryForce>& start) {
  Span span;
  span.rope = rope;
  span.chord = chord;
  const double x = std::hypot(chord.x(), chord.y());
  if (x > 0) span.along = Vector3(chord.x() / x, chord.y() / x, 0);
  const auto solution = solve_catenary(rope, x, chord.z(), start);
  if (solution) {
    span.force = solution->force;
    span.closure = solution->closure;
    span.iterations = solution->iterations;
    return span;
  }
  if (solution.error() != NoCatenary::slack) return tl::unexpected(solution.error());
  span.slack = true;
  return span;
}

Vector3 force_on_start(const Span& span) { return in_space(span, span.force.H, span.force.V - half_weight(span)); }

Vector3 force_on_end(const Span& span) { return -in_space(span, span.force.H, span.force.V + half_weight(span)); }

Matrix3 stiffness(const Span& span) {
  if (span.slack) return Matrix3::Zero();
  const CatenaryStiffness k = stiffness(span.rope, span.force);
  const Vector3& e = span.along;
  const Vector3 n(-e.y(), e.x(), 0);
  const Matrix3 along = e * e.transpose(), across = n * n.transpose();
  Matrix3 K = k.dH_dx * along + k.out_of_plane * across;
  K.col(2) += k.dH_dz * e;
  K.row(2) += k.dH_dz * e.transpose();
  K(2, 2) += k.dV_dz;
  return K;
}

EndForceRates length_rates(const Span& span) {
  if (span.slack) return {};
  const CatenaryStiffness k = stiffness(span.rope, span.force);
  const double w = span.rope.weight;
  return {.start = in_space(span, k.dH_dlength, k.dV_dlength - w / 2),
          .end = -in_space(span, k.dH_dlength, k.dV_dlength + w / 2)};
}

EndForceRates heat_rates(const Span& span) {
  if (span.slack) return {};
  const CatenaryStiffness k = stiffness(span.rope, span.force);
  const Vector3 rate = in_space(span, k.dH_dheat, k.dV_dheat);
  return {.start = rate, .end = -rate};
}

double tension_at_start(const Span& span) { return std::hypot(span.force.H, span.force.V - half_weight(span)); }

double tension_at_end(const Span& span) { return std::hypot(span.force.H, span.force.V + half_weight(span)); }

double largest_tension(const Span& span) { return std::max(tension_at_start(span), tension_at_end(span)); }

Vector3 point_at(const Span& span, double s) {
  expects(s >= 0 && s <= span.rope.length, "a point of a rope lies on it");
  if (span.slack) return s / span.rope.length * span.chord;
  const RopePoint p = point_at(span.rope, span.force, s);
  return in_space(span, p.x, p.z);
}

Vector3 tension_at(const Span& span, double s) {
  expects(s >= 0 && s <= span.rope.length, "a point of a rope lies on it");
  return in_space(span, span.force.H, span.force.V - half_weight(span) + span.rope.weight * s);
}

double largest_sag(const Span& span) { return span.slack ? 0 : largest_sag(span.rope, span.force).depth; }

double sag_at(const Span& span, double x) { return span.slack ? 0 : sag_at(span.rope, span.force, x); }

double stretched_length(const Span& span) { return stretched_length(span.rope, span.force); }

}  // namespace taut::rope
