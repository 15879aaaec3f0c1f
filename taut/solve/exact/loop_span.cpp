#include "taut/solve/exact/loop_span.hpp"

#include <algorithm>
#include <cmath>

namespace taut::solve {
namespace {

constexpr int most_span_iterations = 40;
constexpr double span_settled = 1e-14;  // relative step
constexpr double span_closes = 1e-9;    // of the chord
constexpr double slackest = 300;        // w x/(2 H): beyond it the tensions at the ends overflow

/// sinh(k)/k.
double sinh_ratio(double k) { return k < 1e-4 ? 1 + k * k / 6 : std::sinh(k) / k; }

struct SpanUnknown {
  double L = 0;
  double V = 0;
};

/// Length and mean vertical force of the rope that does not stretch.
SpanUnknown inextensible(double weight, double H, double x, double z) {
  const double k = weight * x / (2 * H);
  const double mean = std::asinh(z / (x * sinh_ratio(k)));  // of the two end angles' asinh slopes
  return {.L = x * sinh_ratio(k) * std::cosh(mean), .V = H * std::sinh(mean) * std::cosh(k)};
}

/// The change of (L, V) that moves the end by (x, z) at constant H.
SpanUnknown change(const rope::EndPosition& p, const rope::EndRates& r, double x, double z) {
  const double determinant = r.dx_dlength * p.dz_dV - p.dx_dV * r.dz_dlength;
  return {.L = (x * p.dz_dV - p.dx_dV * z) / determinant, .V = (r.dx_dlength * z - r.dz_dlength * x) / determinant};
}

/// Newton on (L, V); the length never loses more than half in one step. False when it does not settle.
bool stretch(rope::CatenaryRope& rope, rope::CatenaryForce& force, double x, double z) {
  for (int i = 0; i < most_span_iterations; ++i) {
    const rope::EndPosition p = end_position(rope, force);
    const SpanUnknown step = change(p, end_rates(rope, force), x - p.x, z - p.z);
    if (!std::isfinite(step.L) || !std::isfinite(step.V)) return false;
    const double part = step.L < -rope.length / 2 ? -rope.length / 2 / step.L : 1;
    rope.length += part * step.L;
    force.V += part * step.V;
    const double size = std::hypot(force.H, force.V);
    if (std::abs(step.L) <= span_settled * rope.length && std::abs(step.V) <= 10 * span_settled * size) return true;
  }
  return true;  // the closure decides
}

}  // namespace

std::optional<LoopSpan> span_at_tension(double weight, double stiffness, double H, double x, double z) {
  if (!(H > 0 && x > 0 && std::isfinite(H) && std::isfinite(z))) return std::nullopt;
  if (!(weight * x / (2 * H) < slackest)) return std::nullopt;
  const SpanUnknown rigid = inextensible(weight, H, x, z);
  LoopSpan s;
  s.rope = {.length = rigid.L, .weight = weight, .stiffness = stiffness};
  s.force = {.H = H, .V = rigid.V};
  if (std::isfinite(stiffness) && !stretch(s.rope, s.force, x, z)) return std::nullopt;
  const rope::EndPosition p = end_position(s.rope, s.force);
  s.closure = std::hypot(p.x - x, p.z - z);
  if (!(s.closure <= span_closes * std::max(std::hypot(x, z), s.rope.length))) return std::nullopt;
  const double half = weight * s.rope.length / 2;
  s.V_start = s.force.V - half;
  s.V_end = s.force.V + half;
  s.T_start = std::hypot(H, s.V_start);
  s.T_end = std::hypot(H, s.V_end);
  return s;
}

LoopSpanRates rates_of(const LoopSpan& s) {
  const rope::EndPosition p = end_position(s.rope, s.force);
  const rope::EndRates r = end_rates(s.rope, s.force);
  const SpanUnknown with_H = change(p, r, -p.dx_dH, -p.dx_dV);
  const SpanUnknown with_x = change(p, r, 1, 0);
  const SpanUnknown with_z = change(p, r, 0, 1);
  const double half = s.rope.weight / 2;
  return {.V_start_H = with_H.V - half * with_H.L,
          .V_start_x = with_x.V - half * with_x.L,
          .V_start_z = with_z.V - half * with_z.L,
          .V_end_H = with_H.V + half * with_H.L,
          .V_end_x = with_x.V + half * with_x.L,
          .V_end_z = with_z.V + half * with_z.L,
          .L_H = with_H.L,
          .L_x = with_x.L,
          .L_z = with_z.L};
}

}  // namespace taut::solve
