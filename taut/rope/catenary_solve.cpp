#include <algorithm>
#include <cmath>
#include <limits>

#include "taut/base/expects.hpp"
#include "taut/rope/catenary.hpp"
#include "taut/rope/exact_end.hpp"

namespace taut::rope {
namespace {

constexpr int most_catenary_iterations = 200;
constexpr int most_catenary_halvings = 60;
constexpr double short_step = 1e-6;          ///< relative; from here on the last steps, in extended precision
constexpr double settled = 1e-15;            ///< relative step that is left undone
constexpr double catenary_rounding = 1e-12;  ///< relative step that need not be halved when it gains nothing
constexpr double catenary_closes = 1e-10;    ///< of the span's size: more is refused
constexpr double least_offset = 1e-100;      ///< of the span's size: less is a vertical line

/// A rope in a vertical line: x = 0. z is piecewise linear in V.
tl::expected<CatenarySolution, NoCatenary> solve_vertical(const CatenaryRope& rope, double z) {
  const double L = rope.length;
  const double half = rope.weight * L / 2;
  const double compliance = L / rope.stiffness;
  // all of it pulled one way: z = +-L + V L/EA
  if (compliance > 0 && z - L >= half * compliance)
    return CatenarySolution{.force = {.H = 0, .V = (z - L) / compliance}, .closure = 0, .iterations = 0};
  if (rope.weight == 0) return tl::unexpected(z < L ? NoCatenary::slack : NoCatenary::too_short);
  // a loop hangs between the ends: z = V (L/EA + 2/w)
  const double V = z / (compliance + L / half);
  if (V > half) return tl::unexpected(NoCatenary::too_short);
  return CatenarySolution{.force = {.H = 0, .V = V}, .closure = 0, .iterations = 0};
}

double size_of(double x, double z) { return std::sqrt(x * x + z * z); }

/// lambda from sinh(lambda)/lambda = y > 1. Below 3 by log y = lambda^2/6 - lambda^4/180 + .., turned round: lambda^2 =
/// 6 e (1 + 0.202 e), e = log y, is good to 2e-4 there; above by Newton on the logarithm.
double sinh_ratio_root(double y) {
  const double log_y = std::log(y);
  if (y <= 3) return std::sqrt(std::max(6 * log_y * (1 + 0.20193 * log_y), 1e-16));
  double lambda = std::log(2 * y) + std::log(std::log(2 * y));
  for (int i = 0; i < 2; ++i) {
    const double g = lambda > 30 ? lambda - std::log(2 * lambda) : std::log(std::sinh(lambda) / lambda);
    lambda -= (g - log_y) / (1 / std::tanh(lambda) - 1 / lambda);
  }
  return lambda;
}

/// Starting values: Peyrot and Goulois, Computers and Structures 10 (1979), with the rope's stretch taken into account.
CatenaryForce first_guess(const CatenaryRope& rope, double x, double z) {
  const double chord = size_of(x, z);
  const double w = rope.weight;
  const bool rigid = std::isinf(rope.stiffness);
  // a steep rope is longer by what its own weight stretches it
  const double L = rope.length * (1 + w * z / (2 * rope.stiffness));
  const double sag = w * L;
  if (L <= chord) {
    // the straight spring, with the tension that its sag alone would give added in
    const double T = rigid ? sag : rope.stiffness * (chord - L) / L + std::cbrt(rope.stiffness * sag * sag / 24);
    return {.H = T * x / chord, .V = T * z / chord};
  }
  const double y = std::sqrt((L - z) * (L + z)) / x, lambda = sinh_ratio_root(y);
  const double H = w * x / (2 * lambda);
  if (!rigid) {  // a nearly straight rope is held by its stretch, not by its sag
    const double level = x / chord;
    // only the weight across the chord makes it sag: H is at most 2 (EA w^2 L^2/24)^(1/3) level^(5/3)
    const double most = rope.stiffness * sag * sag / 3 * level * level * level * level * level;
    if (H * H * H > most) {
      const double held = std::cbrt(most);
      return {.H = held, .V = w / 2 * z / std::tanh(w * x / (2 * held))};
    }
  }
  // coth(lambda), with sinh(lambda) = lambda y
  return {.H = H, .V = w / 2 * z * std::sqrt(1 + 1 / (lambda * y * lambda * y))};
}

struct Residual {
  double x, z, size;
};

Residual residual_of(double rx, double rz) { return {.x = rx, .z = rz, .size = size_of(rx, rz)}; }

Residual exact_residual(const CatenaryRope& rope, double x, double z, const CatenaryForce& f) {
  const ExactEnd at = exact_end(rope, f);
  return residual_of(static_cast<double>(x - at.x), static_cast<double>(z - at.z));
}

/// The step of H and V that closes the residual to first order.
CatenaryForce newton_step(const EndPosition& p, const Residual& r) {
  const double determinant = p.dx_dH * p.dz_dV - p.dx_dV * p.dx_dV;
  return {.H = (p.dz_dV * r.x - p.dx_dV * r.z) / determinant, .V = (p.dx_dH * r.z - p.dx_dV * r.x) / determinant};
}

/// The first of f + step, f + step/2, .. at which the residual is smaller than `now`, or the complementary energy,
/// which is convex, still falls along the step or rises less than it fell. (A residual alone stops in the narrow
/// valleys of a steep and nearly taut rope.) H stays positive. False when there is none; on success f is that force and
/// `now` its residual.
template <class ResidualAt>
bool damped_step(CatenaryForce& f, Residual& now, const CatenaryForce& step, const ResidualAt& residual_at) {
  if (!std::isfinite(step.H) || !std::isfinite(step.V)) return false;
  const bool at_rounding = size_of(step.H, step.V) <= catenary_rounding * size_of(f.H, f.V);
  const double falls = now.x * step.H + now.z * step.V;
  double part = f.H + step.H > 0 ? 1.0 : std::min(1.0, -0.9 * f.H / step.H);
  for (int k = 0; k < most_catenary_halvings; ++k, part /= 2) {
    const CatenaryForce next{.H = f.H + part * step.H, .V = f.V + part * step.V};
    const Residual then = residual_at(next);
    const bool less_energy = then.x * step.H + then.z * step.V >= -falls / 2;
    if (then.size < now.size || (less_energy && !at_rounding)) {
      f = next;
      now = then;
      return true;
    }
    if (at_rounding) return false;
  }
  return false;
}

/// Where the rope is level, or else at its lower end: the scale on which its shape changes.
double least_tension(const CatenaryRope& rope, const CatenaryForce& f) {
  const double V0 = std::abs(f.V) - rope.weight * rope.length / 2;
  return V0 > 0 ? size_of(f.H, V0) : f.H;
}

/// Damped Newton: in double while the steps are long, then with the residual in extended precision to the end.
CatenarySolution iterate(const CatenaryRope& rope, double x, double z, CatenaryForce f) {
  CatenarySolution s;
  EndPosition p = end_position(rope, f);
  EndPosition tried;
  Residual r = residual_of(x - p.x, z - p.z);
  const auto in_double = [&](const CatenaryForce& at) {
    tried = end_position(rope, at);
    return residual_of(x - tried.x, z - tried.z);
  };
  CatenaryForce step = newton_step(p, r);
  while (size_of(step.H, step.V) > short_step * size_of(f.H, f.V) && s.iterations < most_catenary_iterations) {
    if (!damped_step(f, r, step, in_double)) break;
    p = tried;
    step = newton_step(p, r);
    ++s.iterations;
  }
  const auto exactly = [&](const CatenaryForce& at) { return exact_residual(rope, x, z, at); };
  r = exactly(f);
  for (; s.iterations < most_catenary_iterations; ++s.iterations) {
    step = newton_step(p, r);
    const double length = size_of(step.H, step.V);
    if (length <= settled * least_tension(rope, f) || !damped_step(f, r, step, exactly)) break;
    if (length > short_step * least_tension(rope, f)) p = end_position(rope, f);
  }
  s.force = f;
  s.closure = r.size;
  return s;
}

/// z >= 0: the rope rises from its start to its end.
tl::expected<CatenarySolution, NoCatenary> solve_rising(const CatenaryRope& rope, double x, double z,
                                                        const std::optional<CatenaryForce>& start) {
  const double chord = size_of(x, z);
  const double scale = std::max(chord, rope.length);
  if (x <= least_offset * scale) return solve_vertical(rope, z);
  if (std::isinf(rope.stiffness) && rope.length <= chord) return tl::unexpected(NoCatenary::too_short);
  if (rope.weight == 0) {
    if (rope.length > chord) return tl::unexpected(NoCatenary::slack);
    const double T = rope.stiffness * (chord - rope.length) / rope.length;
    return CatenarySolution{.force = {.H = T * x / chord, .V = T * z / chord}, .closure = 0, .iterations = 0};
  }
  const bool usable = start && start->H > 0 && std::isfinite(start->H) && std::isfinite(start->V);
  CatenarySolution s = iterate(rope, x, z, usable ? *start : first_guess(rope, x, z));
  if (!(s.closure <= catenary_closes * scale) && usable) s = iterate(rope, x, z, first_guess(rope, x, z));
  if (!(s.closure <= catenary_closes * scale)) return tl::unexpected(NoCatenary::not_converged);
  return s;
}

}  // namespace

tl::expected<CatenarySolution, NoCatenary> solve_catenary(const CatenaryRope& rope, double x, double z,
                                                          const std::optional<CatenaryForce>& start) {
  expects(rope.length > 0 && std::isfinite(rope.length), "a rope has a length");
  expects(rope.weight >= 0 && std::isfinite(rope.weight) && rope.stiffness > 0, "a rope has weight and stiffness");
  expects(x >= 0 && std::isfinite(x) && std::isfinite(z), "a span has finite ends, the end beside or above the start");
  if (z >= 0) return solve_rising(rope, x, z, start);
  const auto mirror = [](const CatenaryForce& f) { return CatenaryForce{.H = f.H, .V = -f.V}; };
  auto s = solve_rising(rope, x, -z, start ? std::optional(mirror(*start)) : std::nullopt);
  if (s) s->force = mirror(s->force);
  return s;
}

}  // namespace taut::rope
