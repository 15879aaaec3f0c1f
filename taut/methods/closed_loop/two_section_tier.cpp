#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/methods/closed_loop/two_section.hpp"

// The closed-form tier of the single carriage, extended to two sections. Each branch is a chain of parabolas; the three
// moment equations (lower branch about A, its part from section 1 about section 1, upper branch about A) are linear in
// the forces once delta_f is known, and the sheave at B gives the equation for delta_f.

namespace taut::closed_loop {
namespace {

constexpr double tier_stands_still = 1e-12;
constexpr int most_tier_passes = 200;
constexpr std::string_view tier = "closed-form tier, free roller, two sections";

double along(double slope) { return std::sqrt(1 + slope * slope); }

struct State {
  Sections at;
  double delta_f = 0;
  Pass p;
};

/// The forces for given sections, m_x and rho; H_4 from the upper branch.
void forces_of(const Case<double>& c, State& t) {
  const Sections& k = t.at;
  Pass& p = t.p;
  const double S_y = c.S * c.cos_g;
  const double S_x = c.S * c.sin_g;
  const double fall = k.d * k.t1 - t.delta_f;  // section 2 above section 1
  p.H_2 = k.y2 / (t.delta_f * k.y1) * (k.d * S_y + fall * S_x + c.w_b * k.y1 * k.d / 2);
  const double z2 = c.m * k.x2 - k.f2;
  const double moment = k.x1 * c.W_c + k.x2 * S_y + z2 * S_x + c.w_T * k.x1 * k.x1 / 2 +
                        c.w_b * k.y1 * (c.l + k.x1) / 2 - c.w_b * k.y2 * c.l / 2 - p.H_2 * k.f2 * c.l / k.y2;
  const double a_u = 1 + p.m_x * (c.m - k.f1 / k.x1);
  p.P_v = moment / (k.x1 * a_u);
  p.H_4 = k.x1 * k.y1 / (k.f1 * c.l) * (a_u * p.P_v + c.w_b * c.l / 2);
  p.H_3 = p.H_4 + p.P_v * p.m_x;
  p.H_1 = p.H_2 + S_x - p.P_v * p.m_x;
}

std::optional<State> solve_for(const Case<double>& c, const SectionRule& rule, double m_x, double rho) {
  const auto at = [&](double d, double delta_f) {
    State t;
    t.at = place(c, rule, d, delta_f);
    t.delta_f = delta_f;
    t.p.m_x = m_x;
    t.p.rho = rho;
    forces_of(c, t);
    return t;
  };
  const auto delta_f_at = [&](double d) {
    return smallest_delta_f(c, rule, [&](double delta_f) {
      const State t = at(d, delta_f);
      return (rho * t.p.H_2 - t.p.H_4) * delta_f;
    });
  };
  double d = 0;
  const auto delta_f = fit_distance(c, rule, d, delta_f_at);
  return delta_f ? std::optional(at(d, *delta_f)) : std::nullopt;
}

/// m_x and rho that the forces of `t` ask for.
void refine(const Case<double>& c, const State& t, double& m_x, double& rho) {
  const Sections& k = t.at;
  const double upper = k.t1 + c.w_b * k.y1 / (2 * t.p.H_4);
  const double lower = c.m + k.f2 / k.y2 + c.w_b * k.y2 / (2 * t.p.H_2);
  rho = c.eta * along(lower) / along(upper);
  if (c.roller == Roller::vertical) return;
  m_x = tan_of_mean(c.m - k.f1 / k.x1 + c.w_b * k.x1 / (2 * t.p.H_3), k.t1 - c.w_b * k.y1 / (2 * t.p.H_4));
}

std::optional<State> settle_two(const Case<double>& c, const SectionRule& rule) {
  double m_x = c.roller == Roller::free ? c.m : 0;
  double rho = c.eta;
  for (int pass = 1; pass <= most_tier_passes; ++pass) {
    auto t = solve_for(c, rule, m_x, rho);
    if (!t) return std::nullopt;
    t->p.passes = pass;
    if (t->p.H_1 <= 0 || t->p.H_2 <= 0 || t->p.H_3 <= 0 || t->p.H_4 <= 0) return t;
    const double m_x_before = m_x;
    const double rho_before = rho;
    refine(c, *t, m_x, rho);
    t->p.converged = std::abs(m_x - m_x_before) <= tier_stands_still && std::abs(rho - rho_before) <= tier_stands_still;
    if (t->p.converged || pass == most_tier_passes) return t;
  }
  return std::nullopt;
}

Outcome judge(const Case<double>& c, const State& t) {
  if (t.p.P_v <= 0) {
    return infeasible(fmt::format(
        "the roller of section 1 lifts off the upper branch at x = {} (it would need P_v = {}): steepen the "
        "gathering line, lessen the sag of {}, or add carriage weight",
        shown(c.display, c.x, si::m), shown(c.display, t.p.P_v, si::N), shown(c.display, c.f, si::m)));
  }
  if (t.p.H_1 <= 0 || t.p.H_2 <= 0 || t.p.H_3 <= 0 || t.p.H_4 <= 0) {
    return infeasible(fmt::format("a rope goes slack at x = {}, sag {}: lessen the sag", shown(c.display, c.x, si::m),
                                  shown(c.display, c.f, si::m)));
  }
  if (t.p.converged) return {};
  return not_converged(
      fmt::format("the closed-form tier does not settle for the two-section carriage at x = {}: lessen the sag of {}",
                  shown(c.display, c.x, si::m), shown(c.display, c.f, si::m)));
}

template <class T>
T tension(Sheet<T>& s, const char* symbol, const T& H, const T& slope) {
  using std::sqrt;
  return s.eq("", symbol, si::N, H * sqrt(1.0 + square(slope)), tier);
}

/// The places of the sections as named quantities.
template <class T>
struct Named {
  T d, x1, x2, y1, y2, f1, f2, t1, delta_f;
  Named(const State& t, Sheet<T>& s)
      : d(s.named("d", si::m, t.at.d)),
        x1(s.named("x_1", si::m, t.at.x1)),
        x2(s.named("x_2", si::m, t.at.x2)),
        y1(s.named("y_1", si::m, t.at.y1)),
        y2(s.named("y_2", si::m, t.at.y2)),
        f1(s.named("f_1", si::m, t.at.f1)),
        f2(s.named("f_2", si::m, t.at.f2)),
        t1(s.named("tan_alpha_1", si::one, t.at.t1)),
        delta_f(s.named("delta_f", si::m, t.delta_f)) {}
};

template <class T>
void write_forces(const Case<T>& c, const State& t, const Named<T>& w, Sheet<T>& s, Quick<T>& q) {
  using std::sqrt;
  const bool free = c.roller == Roller::free;
  if (free) q.m_x = s.named("m_x", si::one, t.p.m_x);
  const T fall = w.d * w.t1 - w.delta_f;
  q.H_2 =
      s.eq("", "H_2", si::N,
           w.y2 / (w.delta_f * w.y1) * (w.d * c.S * c.cos_g + fall * c.S * c.sin_g + c.w_b * w.y1 * w.d / 2.0), tier);
  const T loads = w.x1 * c.W_c + w.x2 * c.S * c.cos_g + (c.m * w.x2 - w.f2) * c.S * c.sin_g;
  const T weights = c.w_T * w.x1 * w.x1 / 2.0 + c.w_b * w.y1 * (c.l + w.x1) / 2.0 - c.w_b * w.y2 * c.l / 2.0;
  const T M = s.eq("", "M", si::N_m, loads + weights - q.H_2 * w.f2 * c.l / w.y2, tier);
  const T left = c.m - w.f1 / w.x1;
  const T a_u = free ? s.eq("", "a_u", si::one, 1.0 + q.m_x * left, tier) : T(1.0);
  q.P_v = s.eq("", "P_v", si::N, M / (w.x1 * a_u), tier);
  q.H_4 = s.eq("", "H_4", si::N, w.x1 * w.y1 / (w.f1 * c.l) * (a_u * q.P_v + c.w_b * c.l / 2.0), tier);
  q.H_3 = free ? s.eq("", "H_3", si::N, q.H_4 + q.P_v * q.m_x, tier) : q.H_4;
  q.H_1 = s.eq("", "H_1", si::N, free ? q.H_2 + c.S * c.sin_g - q.P_v * q.m_x : q.H_2 + c.S * c.sin_g, tier);
  q.N = s.eq("", "N", si::N, free ? q.P_v * sqrt(1.0 + square(q.m_x)) : q.P_v, tier);
  q.P_b = s.eq("", "P_b_closed", si::N, free ? q.P_v * (1.0 + c.m * q.m_x) : q.P_v, tier);
}

template <class T>
void write_ends(const Case<T>& c, const Named<T>& w, Sheet<T>& s, Quick<T>& q, T& T_12) {
  using std::max;
  const T left = s.eq("", "t_A", si::one, c.m - w.f1 / w.x1, tier);
  const T right = s.eq("", "t_B", si::one, c.m + w.f2 / w.y2, tier);
  q.T_uA = tension(s, "T_uA", q.H_3, left - c.w_b * w.x1 / (2.0 * q.H_3));
  q.T_uB = tension(s, "T_uB", q.H_4, w.t1 + c.w_b * w.y1 / (2.0 * q.H_4));
  q.T_lA = tension(s, "T_lA", q.H_1, left - c.w_T * w.x1 / (2.0 * q.H_1));
  q.T_lB = tension(s, "T_lB", q.H_2, right + c.w_b * w.y2 / (2.0 * q.H_2));
  const T U_A = tension(s, "T_UA", q.H_3, left + c.w_b * w.x1 / (2.0 * q.H_3));
  const T U_B = tension(s, "T_UB", q.H_4, w.t1 - c.w_b * w.y1 / (2.0 * q.H_4));
  q.T_U = s.eq("", "T_U", si::N, max(U_A, U_B), tier);
  q.T_lLA = tension(s, "T_lLA", q.H_1, left + c.w_T * w.x1 / (2.0 * q.H_1));
  q.T_lLB = tension(s, "T_lLB", q.H_2, right - c.w_b * w.y2 / (2.0 * q.H_2));
  const T H_12 = s.eq("", "H_12", si::N, q.H_2 + c.S * c.sin_g, tier);
  T_12 = tension(s, "T_12", H_12, w.t1 - w.delta_f / w.d);
}

}  // namespace

template <class T>
Outcome two_section_tensions(const Case<T>& c, const Case<double>& plain, const SectionRule& rule, Sheet<T>& s,
                             SectionForces<T>& out) {
  const auto t = settle_two(plain, rule);
  if (!t) return no_equilibrium(plain);
  s.section("Closed-form tier: the roller presses normal to the rope");
  s.note([&] {
    return fmt::format(
        "delta_f = {}, m_x = {:.6g} and rho = {:.6g} (the ratio H_4/H_2 over the sheave) are found together ({} "
        "passes); the lines below follow from them.",
        shown(c.display, t->delta_f, si::m), t->p.m_x, t->p.rho, t->p.passes);
  });
  const Named<T> w(*t, s);
  out.at = t->at;
  out.delta_f = w.delta_f;
  write_forces(c, *t, w, s, out.q);
  if (Outcome o = judge(plain, *t); !o.ok()) return o;
  write_ends(c, w, s, out.q, out.T_12);
  return {};
}

template Outcome two_section_tensions(const Case<double>&, const Case<double>&, const SectionRule&, Sheet<double>&,
                                      SectionForces<double>&);
template Outcome two_section_tensions(const Case<Num>&, const Case<double>&, const SectionRule&, Sheet<Num>&,
                                      SectionForces<Num>&);

}  // namespace taut::closed_loop
