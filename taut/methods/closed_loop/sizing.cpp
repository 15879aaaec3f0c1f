#include "taut/methods/closed_loop/sizing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "taut/catalogue/construction.hpp"
#include "taut/catalogue/rope_search.hpp"
#include "taut/units/parse.hpp"

namespace taut::closed_loop {
namespace {

Outcome too_shallow(const Case<double>& c, double n) {
  return infeasible(fmt::format(
      "sag too small: with a sag of {:.3g} m at midspan no rope carries even its own weight with a safety factor of "
      "{:.3g}; deepen the sag, shorten the span, or use stronger wire",
      c.f, n));
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
  const T cos2 = c.cos_a * c.cos_a;
  const T bend = c.f * c.sin_2a;
  const T P_b = s.eq("4", "P_b0", si::N, c.eta * (p.P - 2.0 * p.K * c.f * c.cos_a / c.l) / (1.0 + c.eta));
  if (!(value(P_b) > 0)) return nothing_to_carry();
  const T at_B = c.downhill ? bend : -bend;  // B is the upper support downhill, A uphill
  const T at_A = -at_B;
  const T strength = 8.0 * sigma * c.f * cos2;
  const T own = k * c.l * n;
  const T eta = min(c.eta, T(1.0));  // out-haul: the upper branch itself is the tighter one
  const T below_8 = s.eq("8", "D_8", si::N_per_m, strength - own * (c.l + 2.0 * bend));
  const T below_10 = s.eq("10", "D_10", si::N_per_m, 2.0 * strength - own * (c.l + 3.0 * at_A));
  const T below_b = s.eq("8*", "D_8c", si::N_per_m, eta * strength - own * (c.l + 2.0 * at_B));
  if (!(value(below_8) > 0 && value(below_10) > 0 && value(below_b) > 0)) {
    return too_shallow(words_of(c), *in.safety_factor);
  }
  const T F_bp = s.eq("8", "F_return_paper", si::m2, 2.0 * P_b * n * c.cos_a * (c.l + bend) / below_8);
  const T F_b = s.eq("8*", "F_return", si::m2, 2.0 * P_b * n * c.cos_a * (c.l + at_B) / below_b);
  const T load = 4.0 * (p.P - P_b) * c.l * c.cos_a + 8.0 * p.K * c.f * cos2;
  const T F_Tp =
      s.eq("10", "F_traction_paper", si::m2, n * (c.l + at_A) * (load + k * F_bp * c.l * c.l) / (c.l * below_10));
  // alpha_s carries the sign of the roller's push along the slope.
  const T push = c.downhill ? P_b * c.sin_a : -(P_b * c.sin_a);
  const T F_T =
      s.eq("10*", "F_traction", si::m2,
           n * ((c.l + at_A) * (load + k * F_b * c.l * c.l) - 16.0 * c.l * c.f * cos2 * push) / (c.l * below_10));
  out.F_return_paper = value(F_bp);
  out.F_return = value(F_b);
  out.F_traction_paper = value(F_Tp);
  out.F_traction = value(F_T);
  s.note(
      "These areas are a first estimate: they leave out rope weight in P_b and take the end slope to first order. "
      "Verify "
      "the ropes chosen with their own weight (choose_ropes, return_rope, traction_rope).");
  return {};
}

template Outcome areas(const Input&, const Case<double>&, const Paper<double>&, Sheet<double>&, Output&);
template Outcome areas(const Input&, const Case<Num>&, const Paper<Num>&, Sheet<Num>&, Output&);

namespace {

/// "16 mm", "16mm", "1960 MPa" of a rope's words; a text without unit or of another kind is left alone.
bool read_size(const std::string& text, catalogue::RopeDescription& wanted) {
  if (const auto d = parse_quantity(text, si::m)) return wanted.diameter = *d, true;
  if (const auto grade = parse_quantity(text, si::Pa)) return wanted.grade = *grade, true;
  return false;
}

catalogue::RopeDescription read_words(const std::string& text) {
  std::istringstream words(text);
  std::vector<std::string> all;
  for (std::string word; words >> word;) all.push_back(word);
  catalogue::RopeDescription wanted;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i + 1 < all.size() && read_size(all[i] + " " + all[i + 1], wanted)) {
      ++i;
    } else if (read_size(all[i], wanted)) {
      continue;
    } else if (const auto core = catalogue::parse_core(all[i])) {
      wanted.core = *core;
    } else if (const auto construction = catalogue::parse_construction(all[i])) {
      wanted.construction = all[i];
      if (!construction->core.empty()) wanted.core = construction->core;
    } else {
      wanted.standard += (wanted.standard.empty() ? "" : " ") + all[i];
    }
  }
  return wanted;
}

}  // namespace

catalogue::Found<catalogue::RopeRow> rope_named(const std::string& text) {
  auto by_id = catalogue::find_rope(text);
  if (by_id) return by_id;
  const auto wanted = read_words(text);
  if (wanted.construction.empty() || wanted.diameter <= 0) return by_id;
  return catalogue::find_rope(wanted);
}

namespace {

const Peak& higher(const Peak& a, const Peak& b) { return b.tension > a.tension ? b : a; }

void raise(Peak& peak, double tension, double x, const char* where) {
  if (tension > peak.tension) peak = {tension, x, where};
}

}  // namespace

Peaks larger(const Peaks& a, const Peaks& b) {
  return {higher(a.return_rope, b.return_rope), higher(a.traction_rope, b.traction_rope)};
}

Peaks peaks_of(const Output& out) {
  Peaks p;
  raise(p.return_rope, out.T_uA, out.x, "upper branch at A");
  raise(p.return_rope, out.T_U, out.x, "upper branch at the carriage");
  raise(p.return_rope, out.T_uB, out.x, "upper branch at B");
  raise(p.return_rope, out.T_lB, out.x, "lower branch at B");
  raise(p.return_rope, out.T_lLB, out.x, "lower branch at the carriage");
  raise(p.traction_rope, out.T_lA, out.x, "lower branch at A");
  raise(p.traction_rope, out.T_lLA, out.x, "lower branch at the carriage");
  return p;
}

namespace {

using Candidates = std::vector<catalogue::RopeRow>;

Candidates candidates_of(const RopeFilter& filter) {
  catalogue::RopeFilter wanted;
  wanted.construction = filter.construction.value_or("");
  wanted.core = filter.core.value_or("");
  wanted.grade = filter.grade;
  return catalogue::ropes_by(catalogue::RopeOrder::diameter, wanted);
}

Ropes pair_of(const catalogue::RopeRow& b, const catalogue::RopeRow& t) {
  return {b.mass_per_length * gravity, t.mass_per_length * gravity, b, t};
}

/// One trial: which of the two ropes are strong enough.
struct Trial {
  Outcome outcome;
  bool return_passes = false;
  bool traction_passes = false;
  bool passes() const { return outcome.ok() && return_passes && traction_passes; }
};

Trial try_pair(const catalogue::RopeRow& b, const catalogue::RopeRow& t, double n,
               const std::function<Outcome(const Ropes&, Peaks&)>& verify) {
  Peaks peaks;
  Trial trial;
  trial.outcome = verify(pair_of(b, t), peaks);
  trial.return_passes = b.breaking_force >= n * peaks.return_rope.tension;
  trial.traction_passes = t.breaking_force >= n * peaks.traction_rope.tension;
  return trial;
}

Outcome none_strong_enough(const char* role, double n, const catalogue::RopeRow& last) {
  return infeasible(
      fmt::format("no rope of the catalogue that fits the filter is strong enough as the {} rope with a safety factor "
                  "of {:.3g} (the "
                  "thickest is {}); widen the filter, deepen the sag, or lessen the gathering force",
                  role, n, last.id));
}

}  // namespace

Outcome choose(const RopeFilter& filter, double n, const std::function<Outcome(const Ropes&, Peaks&)>& verify,
               Ropes& chosen) {
  const Candidates all = candidates_of(filter);
  if (all.empty()) return infeasible("no rope of the catalogue fits choose_ropes: drop construction, core or grade");
  std::size_t b = 0;
  std::size_t t = 0;
  for (;;) {
    const Trial trial = try_pair(all[b], all[t], n, verify);
    if (!trial.outcome.ok()) return trial.outcome;
    if (trial.passes()) break;
    if (!trial.return_passes && ++b == all.size()) return none_strong_enough("return", n, all.back());
    if (!trial.traction_passes && ++t == all.size()) return none_strong_enough("traction", n, all.back());
  }
  // A row further up is not always heavier (fibre core, other standard): look back for a smaller one beside the
  // partner.
  for (std::size_t i = 0; i < b; ++i) {
    if (try_pair(all[i], all[t], n, verify).passes()) b = i;
  }
  for (std::size_t i = 0; i < t; ++i) {
    if (try_pair(all[b], all[i], n, verify).passes()) t = i;
  }
  chosen = pair_of(all[b], all[t]);
  return {};
}

}  // namespace taut::closed_loop
