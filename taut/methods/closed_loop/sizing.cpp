#include "taut/methods/closed_loop/sizing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "taut/catalogue/rope_search.hpp"
#include "taut/units/display.hpp"

namespace taut::closed_loop {
namespace {

/// N m2: the bracket of (10) times a length.
constexpr Unit moment_by_length{.dimension = dimension(1, 3, -2),
                                .symbol = "N m^2",
                                .shown = "kN m^2",
                                .is_angle = false,
                                .kind = "moment by length"};

Outcome too_shallow(const Case<double>& c, double n) {
  return infeasible(fmt::format(
      "sag too small: with a sag of {} at midspan no rope carries even its own weight with a safety factor of "
      "{:.3g}; deepen the sag, shorten the span, or use stronger wire",
      shown(c.display, c.f, si::m), n));
}

Outcome nothing_to_carry() {
  return infeasible(
      "the ropes can't be sized: with the load at midspan the upper branch would carry none of it (P_b <= 0 by (4)); "
      "steepen the gathering line or lessen the sag");
}

/// Only the numbers that a message needs.
template <class T>
Case<double> words_of(const Case<T>& c) {
  Case<double> d;
  d.f = value(c.f);
  d.display = c.display;
  return d;
}

}  // namespace

template <class T>
Outcome areas(const Input& in, const Case<T>& c, const Paper<T>& p, Sheet<T>& s, Output& out) {
  using std::min;
  s.section("Metallic areas, load at midspan");
  const T n = s.given(*in.safety_factor);
  const T sigma = s.given(*in.wire_strength);
  const T k = s.given(in.weight_per_area);
  const T cos2 = square(c.cos_a);
  const T bend = c.f * c.sin_2a;
  const T P_b = s.eq("4", "P_b0", si::N, c.eta * (p.P - 2.0 * p.K * c.f * c.cos_a / c.l) / (1.0 + c.eta));
  if (!(value(P_b) > 0)) return nothing_to_carry();
  // B is the upper support downhill, A uphill
  const auto toward_A = [&](double times) { return c.downhill ? c.l - times * bend : c.l + times * bend; };
  const auto toward_B = [&](double times) { return c.downhill ? c.l + times * bend : c.l - times * bend; };
  const T strength = 8.0 * sigma * c.f * cos2;
  const T own = k * c.l * n;
  const T eta = min(c.eta, T(1.0));  // out-haul: the upper branch itself is the tighter one
  const T below_8 = s.eq("8", "D_8", si::N_per_m, strength - own * (c.l + 2.0 * bend));
  const T below_10 = s.eq("10", "D_10", si::N_per_m, 2.0 * strength - own * toward_A(3));
  const T below_b = s.eq("8*", "D_8c", si::N_per_m, eta * strength - own * toward_B(2));
  const bool all_positive = value(below_8) > 0 && value(below_10) > 0 && value(below_b) > 0;
  if (!all_positive) {
    return too_shallow(words_of(c), *in.safety_factor);
  }
  const T F_bp = s.eq("8", "F_return_paper", si::m2, 2.0 * P_b * n * c.cos_a * (c.l + bend) / below_8);
  const T F_b = s.eq("8*", "F_return", si::m2, 2.0 * P_b * n * c.cos_a * toward_B(1) / below_b);
  const T load = s.eq("10", "B_10", si::N_m, 4.0 * (p.P - P_b) * c.l * c.cos_a + 8.0 * p.K * c.f * cos2);
  const T l_A = s.eq("10", "l_A", si::m, toward_A(1));
  const T F_Tp = s.eq("10", "F_traction_paper", si::m2, n * l_A * (load + k * F_bp * square(c.l)) / (c.l * below_10));
  // alpha_s carries the sign of the roller's push along the slope.
  const T push =
      s.eq("10*", "R_10", si::N, c.downhill ? P_b * c.sin_a : -(P_b * c.sin_a), "roller's push along the slope");
  const T above =
      s.eq("10*", "A_10", moment_by_length, l_A * (load + k * F_b * square(c.l)) - 16.0 * c.l * c.f * cos2 * push);
  const T F_T = s.eq("10*", "F_traction", si::m2, n * above / (c.l * below_10));
  out.F_return_paper = value(F_bp);
  out.F_return = value(F_b);
  out.F_traction_paper = value(F_Tp);
  out.F_traction = value(F_T);
  s.note(
      "These areas are a first estimate: they leave out rope weight in P_b and take the end slope to first order. "
      "Verify the ropes chosen with their own weight (choose_ropes, return_rope, traction_rope).");
  return {};
}

template Outcome areas(const Input&, const Case<double>&, const Paper<double>&, Sheet<double>&, Output&);
template Outcome areas(const Input&, const Case<Num>&, const Paper<Num>&, Sheet<Num>&, Output&);

namespace {

const Peak& higher(const Peak& a, const Peak& b) { return b.tension > a.tension ? b : a; }

void raise(Peak& peak, double tension, double x, const char* where) {
  if (tension > peak.tension) peak = {.tension = tension, .x = x, .where = where};
}

}  // namespace

std::string place_of(const Peak& peak, const Display& display) {
  return fmt::format("{}, carriage at {}", peak.where, display.brief(peak.x, si::m));
}

Peaks larger(const Peaks& a, const Peaks& b) {
  constexpr double alike = 1e-9;  // a sag that is given is that of both hauls
  return {.return_rope = higher(a.return_rope, b.return_rope),
          .traction_rope = higher(a.traction_rope, b.traction_rope),
          .deepest = b.deepest.sag > a.deepest.sag * (1 + alike) ? b.deepest : a.deepest,
          .other = {}};
}

namespace {

/// The tensions of one rope by their place in it; raise() passes over those that do not exist.
struct Place {
  const char* where;
  double Output::*closed_form;
  double Output::*exact;
};

constexpr std::array on_return = {
    Place{.where = "upper branch at A", .closed_form = &Output::T_uA, .exact = &Output::T_uA_exact},
    Place{.where = "upper branch at the carriage", .closed_form = &Output::T_U, .exact = &Output::T_U_exact},
    Place{.where = "upper branch at B", .closed_form = &Output::T_uB, .exact = &Output::T_uB_exact},
    Place{.where = "lower branch at B", .closed_form = &Output::T_lB, .exact = &Output::T_lB_exact},
    Place{.where = "lower branch at the carriage", .closed_form = &Output::T_lLB, .exact = &Output::T_lLB_exact},
    Place{.where = "between the sections of the carriage", .closed_form = &Output::T_12, .exact = &Output::T_12_exact},
};
constexpr std::array on_traction = {
    Place{.where = "lower branch at A", .closed_form = &Output::T_lA, .exact = &Output::T_lA_exact},
    Place{.where = "lower branch at the carriage", .closed_form = &Output::T_lLA, .exact = &Output::T_lLA_exact},
    Place{.where = "at the winch, behind the sheaves at A",
          .closed_form = &Output::T_winch,
          .exact = &Output::T_winch_exact},
};

Peaks peaks_by(double Output::*Place::*tier, const Output& out) {
  Peaks p;
  for (const Place& at : on_return) raise(p.return_rope, out.*(at.*tier), out.x, at.where);
  for (const Place& at : on_traction) raise(p.traction_rope, out.*(at.*tier), out.x, at.where);
  for (const double sag : {out.f, out.f_1, out.f_2}) {
    if (sag > p.deepest.sag) p.deepest = {.sag = sag, .x = out.x, .where = {}};
  }
  return p;
}

}  // namespace

Peaks peaks_of(const Output& out) {
  return std::isfinite(out.T_lA_exact) ? peaks_by(&Place::exact, out) : closed_form_peaks_of(out);
}

Peaks closed_form_peaks_of(const Output& out) { return peaks_by(&Place::closed_form, out); }

namespace {

using Candidates = std::vector<catalogue::RopeRow>;
using Verify = std::function<Outcome(Solved&)>;

Candidates candidates_of(const RopeFilter& filter) {
  catalogue::RopeFilter wanted;
  wanted.construction = filter.construction.value_or("");
  wanted.core = filter.core.value_or("");
  wanted.grade = filter.grade;
  return catalogue::ropes_by(catalogue::RopeOrder::diameter, wanted);
}

/// The rows that withstand `force`, in the order of `all`.
Candidates stronger_than(double force, const Candidates& all) {
  Candidates some;
  std::copy_if(all.begin(), all.end(), std::back_inserter(some),
               [&](const catalogue::RopeRow& row) { return row.breaking_force >= force; });
  return some;
}

Ropes pair_of(const catalogue::RopeRow& b, const catalogue::RopeRow& t) {
  return {.q_b = b.mass_per_length * standard_gravity,
          .q_T = t.mass_per_length * standard_gravity,
          .return_rope = b,
          .traction_rope = t};
}

/// One trial: which of the two ropes are strong enough.
struct Trial {
  Solved solved;
  Outcome outcome;
  bool return_passes = false;
  bool traction_passes = false;
  bool passes() const { return outcome.ok() && return_passes && traction_passes; }
};

Trial try_pair(const catalogue::RopeRow& b, const catalogue::RopeRow& t, double n, const Verify& verify) {
  Trial trial;
  trial.solved.ropes = pair_of(b, t);
  trial.outcome = verify(trial.solved);
  const Peaks peaks = trial.solved.peaks.value_or(Peaks{});
  trial.return_passes = b.breaking_force >= n * peaks.return_rope.tension;
  trial.traction_passes = t.breaking_force >= n * peaks.traction_rope.tension;
  return trial;
}

Outcome none_strong_enough(const char* role, double n, const Candidates& all, const Display* display) {
  const auto strongest = std::max_element(
      all.begin(), all.end(), [](const auto& a, const auto& b) { return a.breaking_force < b.breaking_force; });
  return infeasible(
      fmt::format("no rope of the catalogue that fits the filter is strong enough as the {} rope with a safety factor "
                  "of {:.3g} (the strongest, {}, breaks at {}); widen the filter, deepen the sag, or lessen the "
                  "gathering force",
                  role, n, strongest->id, shown(display, strongest->breaking_force, si::N)));
}

/// Peaks with both ropes as light as the lightest candidate: no pair has smaller ones.
Outcome least_peaks(const Candidates& all, const Verify& verify, Peaks& least) {
  const auto lightest = std::min_element(
      all.begin(), all.end(), [](const auto& a, const auto& b) { return a.mass_per_length < b.mass_per_length; });
  Solved solved{.ropes = pair_of(*lightest, *lightest), .rows = {}, .peaks = {}};
  Outcome o = verify(solved);
  least = solved.peaks.value_or(Peaks{});
  return o;
}

}  // namespace

Outcome choose(const RopeFilter& filter, double n, const Verify& verify, Solved& chosen, const Display* display) {
  const Candidates all = candidates_of(filter);
  if (all.empty()) return infeasible("no rope of the catalogue fits choose_ropes: drop construction, core or grade");
  Peaks least;
  if (Outcome o = least_peaks(all, verify, least); !o.ok()) return o;
  const Candidates returns = stronger_than(n * least.return_rope.tension, all);
  const Candidates tractions = stronger_than(n * least.traction_rope.tension, all);
  if (returns.empty()) return none_strong_enough("return", n, all, display);
  if (tractions.empty()) return none_strong_enough("traction", n, all, display);
  std::size_t b = 0;
  std::size_t t = 0;
  for (;;) {
    Trial trial = try_pair(returns[b], tractions[t], n, verify);
    if (!trial.outcome.ok()) return trial.outcome;
    if (trial.passes()) {
      chosen = std::move(trial.solved);
      break;
    }
    if (!trial.return_passes && ++b == returns.size()) return none_strong_enough("return", n, all, display);
    if (!trial.traction_passes && ++t == tractions.size()) return none_strong_enough("traction", n, all, display);
  }
  // A row further up is not always heavier (fibre core, other standard): look back for a smaller one beside the
  // partner.
  const auto passes = [&](std::size_t of_return, std::size_t of_traction) {
    Trial trial = try_pair(returns[of_return], tractions[of_traction], n, verify);
    if (trial.passes()) chosen = std::move(trial.solved);
    return trial.passes();
  };
  for (std::size_t i = 0; i < b; ++i) {
    if (passes(i, t)) b = i;
  }
  for (std::size_t i = 0; i < t; ++i) {
    if (passes(b, i)) t = i;
  }
  return {};
}

}  // namespace taut::closed_loop
