#include <fmt/format.h>

#include <algorithm>

#include "taut/rope/rope_check.hpp"
#include "taut/rope/strength.hpp"

namespace taut::rope {
namespace {

/// The bend that a law is written for: the one with the least D/d of those that bend the rope under tension.
const Bend* sharpest(const RopeUse& use) {
  const Bend* least = nullptr;
  for (const Bend& bend : use.bends) {
    if (!(bend.tension > 0) || bend.wrap < least_wrap) continue;
    if (least == nullptr || bend.diameter < least->diameter) least = &bend;
  }
  return least;
}

void write_strength(Sheet<Num>& s, const RopeUse& use, const RopeRules& rules, Num& F_min) {
  if (rules.heat_strength && rules.heat_strength->value < 1) {
    const Num k_t = s.named("k_t", si::one, rules.heat_strength->value);
    F_min = s.eq("", "F_t", si::N, k_t * F_min, rules.heat_strength->rule);
  }
  if (use.tension > 0) {
    const Num T = s.named("T", si::N, use.tension);
    s.eq("", "Z", si::one, F_min / T, fmt::format("static, {}", use.where));
    const Num phi = s.named("phi", si::one, rules.dynamic_factor);
    const Num T_d = s.eq("", "T_d", si::N, phi * T, rules.dynamic_words);
    s.eq("", "Z_d", si::one, F_min / T_d, "with the dynamic factor");
  }
  if (!rules.termination || use.ends.empty()) return;
  const auto end = std::max_element(use.ends.begin(), use.ends.end(),
                                    [](const RopeEnd& a, const RopeEnd& b) { return a.tension < b.tension; });
  if (!(end->tension > 0)) return;
  const Num eta = s.named("eta_T", si::one, rules.termination->value);
  const Num T_e = s.named("T_e", si::N, end->tension);
  s.eq("", "Z_T", si::one, eta * F_min / T_e, fmt::format("at '{}', {}", end->name, rules.termination->rule));
}

void write_bending(Sheet<Num>& s, const RopeUse& use, const RopeRules& rules, const Num& F_min) {
  const Bend* const bend = sharpest(use);
  if (bend == nullptr || !(use.rope.diameter > 0)) return;
  const Num D = s.named("D", si::m.in("mm"), bend->diameter);
  const Num d = s.named("d", si::m.in("mm"), use.rope.diameter);
  const Num S = s.named("S", si::N, bend->tension);
  const Num ratio = s.eq("", "D_d", si::one, D / d, fmt::format("at '{}'", bend->name));
  const Num left = s.eq("", "k_D", si::one, sheave_strength(ratio), "strength left over a round, recalled");
  s.eq("", "Z_D", si::one, left * F_min / S, fmt::format("at '{}'", bend->name));
  s.eq("", "p", si::Pa, groove_pressure(S, d, D), "groove pressure");
  if (rules.wire && use.rope.area > 0) {
    const Num E_r = s.named("E_r", si::Pa.in("GPa"), rules.bending_modulus);
    const Num delta = s.named("delta", si::m.in("mm"), rules.wire->value * use.rope.diameter);
    const Num A = s.named("A", si::m2, use.rope.area);
    s.eq("", "sigma_b", si::Pa, bending_stress(E_r, delta, D), "Shigley, wire rope; an upper bound");
    s.eq("", "F_b", si::N, bending_pull(E_r, delta, A, D), "Shigley, equivalent bending load");
  }
  if (rules.resistance && bend->diameter / use.rope.diameter > least_ratio_en13001) {
    const Num gamma = s.eq("", "gamma_rb", si::one, resistance_factor(ratio), "EN 13001-3-2, recalled");
    s.eq("", "F_Rd", si::N, F_min / gamma, "EN 13001-3-2, recalled");
  }
}

}  // namespace

void write_rope(Sheet<Num>& s, const RopeUse& use, const RopeRules& rules) {
  if (!rest_is_known(use)) {
    RopeRules own = rules;
    own.dynamic_factor = 1;
    own.dynamic_words = "T is the peak of a motion";
    return write_rope(s, at_peak(use), own);
  }
  if (!(use.rope.breaking_force > 0) || !(use.tension > 0)) return;
  s.section(fmt::format("Rope {}: strength", use.name));
  Num F_min = s.named("F_min", si::N, use.rope.breaking_force);
  write_strength(s, use, rules, F_min);
  write_bending(s, use, rules, F_min);
}

}  // namespace taut::rope
