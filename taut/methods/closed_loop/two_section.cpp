#include "taut/methods/closed_loop/two_section.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>

namespace taut::closed_loop {
namespace {

constexpr double stands_still = 1e-12;
constexpr int most_passes = 200;
/// The search for delta_f runs over these shares of the sag, in steps that multiply.
constexpr double smallest_share = 1e-7;
constexpr double largest_share = 50;
constexpr double step_factor = 1.15;

double cos_of(double slope) { return 1 / std::sqrt(1 + slope * slope); }

}  // namespace

std::optional<double> smallest_delta_f(const Case<double>& c, const SectionRule& rule,
                                       const std::function<double(double)>& g) {
  const double sag = c.f;
  const double limit = rule.sag_of == Section::second ? c.f * (1 - 1e-9) : largest_share * c.f;
  double low = smallest_share * sag;
  double g_low = g(low);
  while (low < limit) {
    const double high = std::min(low * step_factor, limit);
    const double g_high = g(high);
    if (std::isfinite(g_low) && std::isfinite(g_high) && (g_low < 0) != (g_high < 0)) return find_root(g, low, high);
    if (high >= limit) break;
    low = high;
    g_low = g_high;
  }
  return std::nullopt;
}

std::optional<double> fit_distance(const Case<double>& c, const SectionRule& rule, double& d,
                                   const std::function<std::optional<double>(double)>& delta_f_at) {
  d = rule.distance;
  std::optional<double> delta_f = delta_f_at(d);
  if (rule.kind == DistanceKind::horizontal) return delta_f;
  for (int pass = 0; pass < most_passes && delta_f; ++pass) {
    const Sections k = place(c, rule, d, *delta_f);
    const double fitted = rule.distance * cos_of(k.t1 - *delta_f / d);
    const bool settled = std::abs(fitted - d) <= stands_still * rule.distance;
    d = fitted;
    delta_f = delta_f_at(d);
    if (settled) return delta_f;
  }
  return std::nullopt;
}

namespace {

/// (11) = eta (12) solved for P_b; both are linear in it.
TwoSection balance(const Case<double>& c, const SectionRule& rule, double d, double delta_f, double P, double K) {
  TwoSection t;
  t.delta_f = delta_f;
  t.at = place(c, rule, d, delta_f);
  const Sections& k = t.at;
  const double upper = k.x1 * k.y1 / (2 * k.f1 * c.cos_a);
  const double lower = k.x2 * k.y2 / (2 * k.f2 * c.cos_a);
  const double T_B1_0 = upper * c.q_b / c.cos_a;
  const double share = 1 - k.d / k.x2;
  const double load = P - c.W_c * k.d / k.x2 - K * k.f2 * c.cos_a / k.x2;
  const double weight = (c.q_b * c.l + (c.q_T - c.q_b) * k.x1 * k.x1 / k.x2) / (c.l * c.cos_a);
  const double T_B2_0 = lower * (2 * load / c.l + weight);
  t.P_b = (c.eta * T_B2_0 - T_B1_0) / (2 * upper / c.l + c.eta * 2 * lower * share / c.l);
  t.T_B1 = T_B1_0 + 2 * upper * t.P_b / c.l;
  t.T_B2 = T_B2_0 - 2 * lower * share * t.P_b / c.l;
  return t;
}

/// delta_f times the excess of (12) over (13) in horizontal force.
double excess(const Case<double>& c, const TwoSection& t) {
  const Sections& k = t.at;
  const double cos_1 = cos_of(k.t1);
  const double P1 = c.S * (c.cos_g + c.sin_g * k.t1);
  const double K1 = c.S * c.sin_g / cos_1;
  const double own = k.d * k.y2 / 2 * (2 * (P1 - K1 * t.delta_f * cos_1 / k.d) / k.y1 + c.q_b / cos_1);
  return t.T_B2 * c.cos_a * t.delta_f - own;
}

}  // namespace

Outcome no_equilibrium(const Case<double>& c) {
  return infeasible(fmt::format(
      "the two-section carriage has no equilibrium with section 2 hanging below the line from section 1 to B "
      "(delta_f > 0) at x = {}, sag {}: steepen the gathering line, or shorten the section distance",
      shown(c.display, c.x, si::m), shown(c.display, c.f, si::m)));
}

namespace {

Outcome no_load(const Case<double>& c, double P_b) {
  return infeasible(fmt::format(
      "the upper branch would have to push (P_b = {}) at x = {}, sag {}: lessen the sag, steepen the gathering "
      "line, or add carriage weight",
      shown(c.display, P_b, si::N), shown(c.display, c.x, si::m), shown(c.display, c.f, si::m)));
}

/// The places of the sections as quantities of the note.
template <class T>
struct Places {
  T d, x1, x2, y1, y2, f1, f2, t1;
};

template <class T>
Places<T> write_places(const Case<T>& c, const Sections& k, const SectionRule& rule, Sheet<T>& s, const T& delta_f) {
  Places<T> w;
  w.d = s.named("d", si::m, k.d);
  const bool first = rule.position_of == Section::first;
  w.x1 = first ? c.x : s.eq("", "x_1", si::m, c.x - w.d);
  w.x2 = first ? s.eq("", "x_2", si::m, c.x + w.d) : c.x;
  w.y1 = s.eq("", "y_1", si::m, c.l - w.x1);
  w.y2 = s.eq("", "y_2", si::m, c.l - w.x2);
  if (rule.sag_of == Section::first) {
    w.f1 = c.f;
    w.f2 = s.eq("15*", "f_2", si::m, w.f1 * w.y2 / w.y1 + delta_f);
  } else {
    w.f2 = c.f;
    w.f1 = s.eq("15*", "f_1", si::m, (w.f2 - delta_f) * w.y1 / w.y2);
  }
  w.t1 = s.eq("16*", "tan_alpha_1", si::one, c.m + w.f1 / w.y1);
  return w;
}

}  // namespace

Sections place(const Case<double>& c, const SectionRule& rule, double d, double delta_f) {
  Sections k;
  k.d = d;
  k.x1 = rule.position_of == Section::first ? c.x : c.x - d;
  k.x2 = k.x1 + d;
  k.y1 = c.l - k.x1;
  k.y2 = c.l - k.x2;
  k.f1 = rule.sag_of == Section::first ? c.f : (c.f - delta_f) * k.y1 / k.y2;
  k.f2 = rule.sag_of == Section::first ? c.f * k.y2 / k.y1 + delta_f : c.f;
  k.t1 = c.m + k.f1 / k.y1;
  return k;
}

std::optional<TwoSection> solve_as_printed(const Case<double>& c, const SectionRule& rule, double P, double K) {
  const double d = rule.distance;
  const double x = rule.position_of == Section::first ? c.x : c.x - d;
  const auto at = [&](double delta_f) {
    TwoSection t;
    t.delta_f = delta_f;
    t.at = place(c, rule, d, delta_f);
    const double f1 = rule.sag_of == Section::first ? c.f : c.f - delta_f;
    const double f2 = f1 + delta_f;
    const double upper = x * (c.l - x) / (2 * f1 * c.cos_a);
    const double lower = x * (c.l - x) / (2 * f2 * c.cos_a);
    const double T_B1_0 = upper * c.q_b / c.cos_a;
    const double weight = (c.q_b * c.l + x * (c.q_T - c.q_b)) / (c.l * c.cos_a);
    const double T_B2_0 = lower * (2 * (P - K * f2 * c.cos_a / x) / c.l + weight);
    const double share = 1 - d / x;
    t.P_b = (c.eta * T_B2_0 - T_B1_0) / (2 * upper / c.l + c.eta * 2 * lower * share / c.l);
    t.T_B1 = T_B1_0 + 2 * upper * t.P_b / c.l;
    t.T_B2 = T_B2_0 - 2 * lower * share * t.P_b / c.l;
    t.at.f1 = f1;
    t.at.f2 = f2;
    return t;
  };
  const auto gap = [&](double delta_f) {
    const TwoSection t = at(delta_f);
    const double cos_1 = cos_of(c.m + t.at.f1 / (c.l - x));
    const double own =
        d * (c.l - x - d) / (2 * cos_1) * (2 * (P - K * delta_f * cos_1 / d) / (c.l - x) + c.q_b / cos_1);
    return t.T_B2 * delta_f - own;
  };
  const auto delta_f = smallest_delta_f(c, rule, gap);
  return delta_f ? std::optional(at(*delta_f)) : std::nullopt;
}

namespace {

/// The corrected system in plain numbers.
std::optional<TwoSection> solve_corrected(const Case<double>& c, const SectionRule& rule, double P, double K) {
  double d = 0;
  const auto at = [&](double distance) {
    const auto gap = [&](double delta_f) { return excess(c, balance(c, rule, distance, delta_f, P, K)); };
    return smallest_delta_f(c, rule, gap);
  };
  const auto delta_f = fit_distance(c, rule, d, at);
  return delta_f ? std::optional(balance(c, rule, d, *delta_f, P, K)) : std::nullopt;
}

template <class T>
void write_ends(const Case<T>& c, const Places<T>& w, Sheet<T>& s, Paper<T>& p) {
  p.T_n = s.eq("14*", "T_n", si::N, p.T_b / c.eta + p.K);
  const T V_u = s.eq("7*", "V_u", si::N, p.P_b * (c.downhill ? w.x1 : w.y1) / c.l + c.w_b * c.l / 2.0);
  p.T_up = s.eq("7*", "T_up", si::N, p.T_b + c.sin_a * V_u);
  const T V_lA = s.eq("9*", "V_lA", si::N, p.T_n * c.cos_a * w.f1 / w.x1 + c.w_T * w.x1 / 2.0);
  p.T_lA = s.eq("9*", "T_lA_paper", si::N, c.downhill ? p.T_n - c.sin_a * V_lA : p.T_n + c.sin_a * V_lA);
}

}  // namespace

template <class T>
Outcome corrected_system(const Case<T>& c, const Case<double>& plain, const SectionRule& rule, Sheet<T>& s, Paper<T>& p,
                         T& delta_f) {
  using std::sqrt;
  const auto found = solve_corrected(plain, rule, value(p.P), value(p.K));
  if (!found) return no_equilibrium(plain);
  s.section("Two-section carriage, corrected system (11)-(16)");
  s.note([&] {
    return fmt::format("delta_f = {} solves the lines below together; (12*) and (13*) then give the same force.",
                       shown(c.display, found->delta_f, si::m));
  });
  delta_f = s.named("delta_f", si::m, found->delta_f);
  const Places<T> w = write_places(c, found->at, rule, s, delta_f);
  const T upper = s.eq("11*", "c_1", si::one, w.x1 * w.y1 / (2.0 * w.f1 * c.cos_a * c.l));
  const T lower = s.eq("12*", "c_2", si::one, w.x2 * w.y2 / (2.0 * w.f2 * c.cos_a * c.l));
  T load = p.P - p.K * w.f2 * c.cos_a / w.x2;
  if (c.has_weight) load = load - c.W_c * w.d / w.x2;
  const T weight = (c.q_b * c.l + (c.q_T - c.q_b) * w.x1 * w.x1 / w.x2) / c.cos_a;
  const T T_20 = s.eq("12*", "T_20", si::N, lower * (2.0 * load + weight));
  const T share = s.eq("12*", "k", si::one, 1.0 - w.d / w.x2);
  p.P_b = s.eq("14*", "P_b", si::N, (c.eta * T_20 - upper * c.w_b * c.l) / (2.0 * upper + 2.0 * c.eta * lower * share));
  p.T_b = s.eq("11*", "T_B1", si::N, upper * (2.0 * p.P_b + c.w_b * c.l));
  const T T_B2 = s.eq("12*", "T_B2", si::N, T_20 - 2.0 * lower * share * p.P_b);
  const T cos_1 = s.eq("16*", "cos_alpha_1", si::one, 1.0 / sqrt(1.0 + square(w.t1)));
  const T P1 = s.eq("3*", "P_1", si::N, c.S * (c.cos_g + c.sin_g * w.t1));
  const T K1 = s.eq("2*", "K_1", si::N, c.S * c.sin_g / cos_1);
  s.eq("12*", "H_2", si::N, T_B2 * c.cos_a);
  s.eq("13*", "H_2", si::N,
       w.d * w.y2 / (2.0 * delta_f) * (2.0 * (P1 - K1 * delta_f * cos_1 / w.d) / w.y1 + c.q_b / cos_1));
  write_ends(c, w, s, p);
  return value(p.P_b) > 0 ? Outcome{} : no_load(plain, value(p.P_b));
}

template Outcome corrected_system(const Case<double>&, const Case<double>&, const SectionRule&, Sheet<double>&,
                                  Paper<double>&, double&);
template Outcome corrected_system(const Case<Num>&, const Case<double>&, const SectionRule&, Sheet<Num>&, Paper<Num>&,
                                  Num&);

}  // namespace taut::closed_loop
