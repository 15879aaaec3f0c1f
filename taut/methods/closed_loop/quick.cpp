#include "taut/methods/closed_loop/quick.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace taut::closed_loop {
namespace {

constexpr double quick_stands_still = 1e-12;
constexpr int quiet_passes = 20;
constexpr int most_quick_passes = 400;
constexpr std::string_view quick_tier = "closed-form tier, free roller";

/// What the passes share: it does not depend on m_x and rho.
struct QuickFrame {
  double left = 0;   ///< m - f/x: slope of the straight line A to carriage
  double right = 0;  ///< m + f/y
  double E = 0;
  double W_u = 0;
  double W_l = 0;
  double Q = 0;
};

QuickFrame frame_of(const Case<double>& c) {
  QuickFrame k;
  k.left = c.m - c.f / c.x;
  k.right = c.m + c.f / c.y;
  k.E = c.x * c.y / (c.f * c.l);
  k.W_u = c.w_b * c.l / 2;
  k.W_l = (c.w_T * c.x + c.w_b * c.y) / 2;
  k.Q = c.S * c.cos_g + c.W_c + k.left * c.S * c.sin_g;
  return k;
}

void forces_of(const Case<double>& c, const QuickFrame& k, Pass& p) {
  const double a_u = 1 + p.m_x * k.left;
  p.P_v = (p.rho * (k.Q + k.W_l) - k.W_u) / (a_u * (1 + p.rho));
  p.H_4 = k.E * (a_u * p.P_v + k.W_u);
  p.H_2 = k.E * (k.Q + k.W_l - a_u * p.P_v);
  p.H_3 = p.H_4 + p.P_v * p.m_x;
  p.H_1 = p.H_2 + c.S * c.sin_g - p.P_v * p.m_x;
}

bool all_taut(const Pass& p) { return p.H_1 > 0 && p.H_2 > 0 && p.H_3 > 0 && p.H_4 > 0; }

double quick_along(double slope) { return std::sqrt(1 + slope * slope); }

}  // namespace

Pass settle(const Case<double>& c) {
  const QuickFrame k = frame_of(c);
  const bool free = c.roller == Roller::free;
  Pass p;
  p.m_x = free ? c.m + c.f / 2 * (1 / c.y - 1 / c.x) : 0;
  p.rho = c.eta;
  for (p.passes = 1; p.passes <= most_quick_passes; ++p.passes) {
    forces_of(c, k, p);
    if (!all_taut(p)) return p;
    const double m_x = free ? tan_of_mean(k.left + c.w_b * c.x / (2 * p.H_3), k.right - c.w_b * c.y / (2 * p.H_4)) : 0;
    const double rho =
        c.eta * quick_along(k.right + c.w_b * c.y / (2 * p.H_2)) / quick_along(k.right + c.w_b * c.y / (2 * p.H_4));
    p.converged = std::abs(m_x - p.m_x) <= quick_stands_still && std::abs(rho - p.rho) <= quick_stands_still;
    if (p.converged) return p;
    // Deep sags swing around the solution: take half steps once it is clear that full ones are slow.
    const double step = p.passes > quiet_passes ? 0.5 : 1.0;
    p.m_x += step * (m_x - p.m_x);
    p.rho += step * (rho - p.rho);
  }
  return p;
}

namespace {

/// The last pass, written down: from the horizontal tensions of the pass before.
template <class T>
void write_forces(const Case<T>& c, const Pass& before, Sheet<T>& s, Quick<T>& q) {
  using std::sqrt;
  const T H_2 = s.named("H_2", si::N, before.H_2);
  const T H_3 = s.named("H_3", si::N, before.H_3);
  const T H_4 = s.named("H_4", si::N, before.H_4);
  const T left = s.eq("", "t_A", si::one, c.m - c.f / c.x, quick_tier);
  const T right = s.eq("", "t_B", si::one, c.m + c.f / c.y, quick_tier);
  T a_u = 1.0;
  if (c.roller == Roller::free) {
    const T u_A = s.eq("", "t_UA", si::one, left + c.w_b * c.x / (2.0 * H_3), quick_tier);
    const T u_B = s.eq("", "t_UB", si::one, right - c.w_b * c.y / (2.0 * H_4), quick_tier);
    q.m_x = s.eq("", "m_x", si::one, tan_of_mean(u_A, u_B), quick_tier);
    a_u = s.eq("", "a_u", si::one, 1.0 + q.m_x * left, quick_tier);
  }
  const T s_l = s.eq("", "s_l", si::one, right + c.w_b * c.y / (2.0 * H_2), quick_tier);
  const T s_u = s.eq("", "s_u", si::one, right + c.w_b * c.y / (2.0 * H_4), quick_tier);
  const T rho = s.eq("", "rho", si::one, c.eta * sqrt(1.0 + square(s_l)) / sqrt(1.0 + square(s_u)), quick_tier);
  const T E = s.eq("", "E", si::one, c.x * c.y / (c.f * c.l), quick_tier);
  const T W_u = s.eq("", "W_u", si::N, c.w_b * c.l / 2.0, quick_tier);
  const T W_l = s.eq("", "W_l", si::N, (c.w_T * c.x + c.w_b * c.y) / 2.0, quick_tier);
  const T pull = c.S * c.cos_g + left * c.S * c.sin_g;
  const T Q = s.eq("", "Q", si::N, c.has_weight ? pull + c.W_c : pull, quick_tier);
  q.P_v = s.eq("", "P_v", si::N, (rho * (Q + W_l) - W_u) / (a_u * (1.0 + rho)), quick_tier);
  q.H_4 = s.eq("", "H_4", si::N, E * (a_u * q.P_v + W_u), quick_tier);
  q.H_2 = s.eq("", "H_2", si::N, E * (Q + W_l - a_u * q.P_v), quick_tier);
  const bool free = c.roller == Roller::free;
  q.H_3 = free ? s.eq("", "H_3", si::N, q.H_4 + q.P_v * q.m_x, quick_tier) : q.H_4;
  q.H_1 = s.eq("", "H_1", si::N, free ? q.H_2 + c.S * c.sin_g - q.P_v * q.m_x : q.H_2 + c.S * c.sin_g, quick_tier);
  q.N = s.eq("", "N", si::N, free ? q.P_v * sqrt(1.0 + square(q.m_x)) : q.P_v, quick_tier);
  q.P_b = free ? s.eq("", "P_b_closed", si::N, q.P_v * (1.0 + c.m * q.m_x), quick_tier) : q.P_v;
}

/// H sqrt(1 + slope^2) of one rope end.
template <class T>
T end_tension(Sheet<T>& s, const char* symbol, const T& H, const T& slope) {
  using std::sqrt;
  return s.eq("", symbol, si::N, H * sqrt(1.0 + square(slope)), quick_tier);
}

template <class T>
void write_ends(const Case<T>& c, Sheet<T>& s, Quick<T>& q) {
  using std::max;
  const T left = s.named("t_A", si::one, value(c.m) - value(c.f) / value(c.x));
  const T right = s.named("t_B", si::one, value(c.m) + value(c.f) / value(c.y));
  q.T_uA = end_tension(s, "T_uA", q.H_3, left - c.w_b * c.x / (2.0 * q.H_3));
  q.T_uB = end_tension(s, "T_uB", q.H_4, right + c.w_b * c.y / (2.0 * q.H_4));
  q.T_lA = end_tension(s, "T_lA", q.H_1, left - c.w_T * c.x / (2.0 * q.H_1));
  q.T_lB = end_tension(s, "T_lB", q.H_2, right + c.w_b * c.y / (2.0 * q.H_2));
  const T U_A = end_tension(s, "T_UA", q.H_3, left + c.w_b * c.x / (2.0 * q.H_3));
  const T U_B = end_tension(s, "T_UB", q.H_4, right - c.w_b * c.y / (2.0 * q.H_4));
  q.T_U = s.eq("", "T_U", si::N, max(U_A, U_B), quick_tier);
  q.T_lLA = end_tension(s, "T_lLA", q.H_1, left + c.w_T * c.x / (2.0 * q.H_1));
  q.T_lLB = end_tension(s, "T_lLB", q.H_2, right - c.w_b * c.y / (2.0 * q.H_2));
}

Outcome lift_off(const Case<double>& c, double P_v) {
  const double gamma = std::atan2(c.sin_g, c.cos_g);
  return infeasible(fmt::format(
      "the roller lifts off the upper branch at x = {} (it would need P_v = {}): the gathering line pulls too flat "
      "(gamma = {} from the vertical); steepen it, lessen the sag of {}, or add carriage weight",
      shown(c.display, c.x, si::m), shown(c.display, P_v, si::N), shown(c.display, gamma, si::rad),
      shown(c.display, c.f, si::m)));
}

Outcome slack(const Case<double>& c, const Pass& p) {
  const char* which = p.H_2 <= 0   ? "the lower branch between the carriage and B"
                      : p.H_1 <= 0 ? "the lower branch between A and the carriage"
                                   : "the upper branch";
  return infeasible(
      fmt::format("{} goes slack at x = {}, sag {}: lessen the sag, or keep the carriage farther from the support",
                  which, shown(c.display, c.x, si::m), shown(c.display, c.f, si::m)));
}

Outcome judge(const Case<double>& c, const Pass& p) {
  if (p.P_v <= 0) return lift_off(c, p.P_v);
  if (!all_taut(p)) return slack(c, p);
  if (p.converged) return {};
  return not_converged(
      fmt::format("the closed-form tier does not settle at x = {}, sag {}: the sag is too deep for it; lessen the sag",
                  shown(c.display, c.x, si::m), shown(c.display, c.f, si::m)));
}

}  // namespace

std::optional<Quick<double>> quick(const Case<double>& c) {
  Sheet<double> s;
  Quick<double> q;
  return quick_tensions(c, c, s, q).ok() ? std::optional(q) : std::nullopt;
}

template <class T>
Outcome quick_tensions(const Case<T>& c, const Case<double>& plain, Sheet<T>& s, Quick<T>& q) {
  const Pass p = settle(plain);
  s.section("Closed-form tier: the roller presses normal to the rope");
  s.note([&] {
    return fmt::format(
        "m_x and rho depend on the tensions; repeated until they stand still ({} passes). "
        "Shown is the last pass, which starts from the H of the pass before.",
        p.passes);
  });
  write_forces(c, p, s, q);
  if (Outcome o = judge(plain, p); !o.ok()) return o;
  write_ends(c, s, q);
  return {};
}

template Outcome quick_tensions(const Case<double>&, const Case<double>&, Sheet<double>&, Quick<double>&);
template Outcome quick_tensions(const Case<Num>&, const Case<double>&, Sheet<Num>&, Quick<Num>&);

}  // namespace taut::closed_loop
