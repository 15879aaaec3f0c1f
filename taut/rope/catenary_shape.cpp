#include "taut/rope/catenary_shape.hpp"

#include <algorithm>
#include <cmath>

#include "taut/base/expects.hpp"

namespace taut::rope {
namespace {

constexpr double upright = 1e-3;  ///< x/z of a chord below which a distance under it says nothing

double start_V(const CatenaryRope& rope, const CatenaryForce& f) { return f.V - rope.weight * rope.length / 2; }

/// Unstretched length from the start to where the vertical tension is V, within the rope.
double length_to_V(const CatenaryRope& rope, const CatenaryForce& f, double V) {
  const double rise = V - start_V(rope, f);
  if (rise <= 0) return 0;
  return rise >= rope.weight * rope.length ? rope.length : std::min(rope.length, rise / rope.weight);
}

}  // namespace

double RopePoint::tension() const { return std::hypot(H, V); }

RopePoint point_at(const CatenaryRope& rope, const CatenaryForce& f, double s) {
  expects(s >= 0 && s <= rope.length, "a point of a rope lies on it");
  const double V = start_V(rope, f) + rope.weight * s;
  if (s == 0) return {.x = 0, .z = 0, .H = f.H, .V = V};
  // the piece up to s is a rope of its own
  const EndPosition p = end_position({.length = s, .weight = rope.weight, .stiffness = rope.stiffness},
                                     {.H = f.H, .V = V - rope.weight * s / 2});
  return {.x = p.x, .z = p.z, .H = f.H, .V = V};
}

double length_to(const CatenaryRope& rope, const CatenaryForce& f, double x) {
  expects(f.H > 0, "a rope in a vertical line passes over no x");
  const double end = end_position(rope, f).x;
  expects(x >= 0 && x <= end * (1 + 1e-12), "x lies within the span");
  // x(s) rises; Newton, kept within the bracket
  double low = 0, high = rope.length;
  double s = rope.length * std::min(1.0, x / end);
  for (int i = 0; i < 200; ++i) {
    const RopePoint p = point_at(rope, f, s);
    const double error = x - p.x;
    (error > 0 ? low : high) = s;
    const double step = error / (f.H / rope.stiffness + f.H / p.tension());
    double next = s + step;
    if (next < low || next > high) next = (low + high) / 2;
    if (std::abs(next - s) <= 1e-15 * rope.length) return next;
    s = next;
  }
  return s;
}

double sag_at(const CatenaryRope& rope, const CatenaryForce& f, double x) {
  const EndPosition end = end_position(rope, f);
  return x * (end.z / end.x) - point_at(rope, f, length_to(rope, f, x)).z;
}

Sag largest_sag(const CatenaryRope& rope, const CatenaryForce& f) {
  const EndPosition end = end_position(rope, f);
  if (!(end.x > upright * std::abs(end.z))) {
    const double s = lowest_point(rope, f);
    return {.depth = std::min(0.0, end.z) - point_at(rope, f, s).z, .x = 0, .s = s};
  }
  const double s = length_to_V(rope, f, f.H * (end.z / end.x));
  const RopePoint p = point_at(rope, f, s);
  return {.depth = p.x * (end.z / end.x) - p.z, .x = p.x, .s = s};
}

double lowest_point(const CatenaryRope& rope, const CatenaryForce& f) { return length_to_V(rope, f, 0); }

double stretched_length(const CatenaryRope& rope, const CatenaryForce& f) {
  if (std::isinf(rope.stiffness)) return rope.length;
  const double half = rope.weight * rope.length / 2;
  const double sum = std::hypot(f.H, f.V - half) + std::hypot(f.H, f.V + half);
  if (sum == 0) return rope.length;
  // (V1 T1 - V0 T0)/w, without a difference; and H^2 I
  const double vertical = rope.length * (sum / 2 + 2 * f.V * (f.V / sum));
  const double x = f.H == 0 ? 0 : end_position(rope, f).x;
  const double horizontal = f.H * (x - f.H * rope.length / rope.stiffness);
  return rope.length + (vertical + horizontal) / (2 * rope.stiffness);
}

double elastic_energy(const CatenaryRope& rope, const CatenaryForce& f) {
  const double wL = rope.weight * rope.length;
  return rope.length * (f.H * f.H + f.V * f.V + wL * wL / 12) / (2 * rope.stiffness);
}

}  // namespace taut::rope
