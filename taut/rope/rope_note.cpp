#include <fmt/format.h>

#include <algorithm>

#include "taut/rope/rope_check.hpp"
#include "taut/rope/strength.hpp"

namespace taut::rope {
namespace {

/// The bend that a law is written for, as its check judges it: of those that bend the rope under tension the one where
/// `share`, what it asks of the rope, is the largest.
template <class Share>
const Bend* worst_bend(const RopeUse& use, const Share& share) {
  const Bend* worst = nullptr;
  for (const Bend& bend : use.bends) {
    if (!(bend.tension > 0) || bend.wrap < least_wrap) continue;
    if (worst == nullptr || share(bend) > share(*worst)) worst = &bend;
  }
  return worst;
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

/// What a law is written with at a bend; at another one than that of `known` with names of its own.
struct AtBend {
  const Bend* bend = nullptr;
  Num D, S;
};

AtBend at_bend(Sheet<Num>& s, const Bend* bend, const AtBend& known, const char* of) {
  if (bend == known.bend) return known;
  return {.bend = bend,
          .D = s.named(fmt::format("D_{}", of), si::m.in("mm"), bend->diameter),
          .S = s.named(fmt::format("S_{}", of), si::N, bend->tension)};
}

void write_pressure(Sheet<Num>& s, const RopeUse& use, const Num& d, const AtBend& known) {
  const Bend* const bend = worst_bend(use, [](const Bend& one) { return one.tension / one.diameter; });
  const AtBend at = at_bend(s, bend, known, "p");
  s.eq("", "p", si::Pa, groove_pressure(at.S, d, at.D), fmt::format("groove pressure at '{}'", bend->name));
}

/// `F_min`: of the rope as it is. Saddles are no matter of EN 13001-3-2, and below its range there is no factor.
void write_resistance(Sheet<Num>& s, const RopeUse& use, const Num& F_min, const Num& d, const AtBend& known) {
  const auto counts = [&](const Bend& one) {
    return one.kind != BendKind::saddle && one.diameter / use.rope.diameter > least_ratio_en13001;
  };
  const Bend* const bend = worst_bend(use, [&](const Bend& one) {
    return counts(one) ? one.tension * resistance_factor(one.diameter / use.rope.diameter) : 0;
  });
  if (!counts(*bend)) return;
  const AtBend at = at_bend(s, bend, known, "rb");
  const Num gamma = s.eq("", "gamma_rb", si::one, resistance_factor(at.D / d),
                         fmt::format("EN 13001-3-2, recalled; at '{}'", bend->name));
  s.eq("", "F_Rd", si::N, F_min / gamma, "EN 13001-3-2, recalled");
}

void write_bending(Sheet<Num>& s, const RopeUse& use, const RopeRules& rules, const Num& F_min) {
  const Bend* const bend =
      worst_bend(use, [&](const Bend& one) { return one.tension / sheave_strength(one.diameter / use.rope.diameter); });
  if (bend == nullptr || !(use.rope.diameter > 0)) return;
  const Num D = s.named("D", si::m.in("mm"), bend->diameter);
  const Num d = s.named("d", si::m.in("mm"), use.rope.diameter);
  const Num S = s.named("S", si::N, bend->tension);
  const Num ratio = s.eq("", "D_d", si::one, D / d, fmt::format("at '{}'", bend->name));
  const Num left = s.eq("", "k_D", si::one, sheave_strength(ratio), "strength left over a round, recalled");
  s.eq("", "Z_D", si::one, left * F_min / S, fmt::format("at '{}'", bend->name));
  const AtBend known{.bend = bend, .D = D, .S = S};
  write_pressure(s, use, d, known);
  if (rules.wire && use.rope.area > 0) {
    const Num E_r = s.named("E_r", si::Pa.in("GPa"), rules.bending_modulus);
    const Num delta = s.named("delta", si::m.in("mm"), rules.wire->value * use.rope.diameter);
    const Num A = s.named("A", si::m2, use.rope.area);
    s.eq("", "sigma_b", si::Pa, bending_stress(E_r, delta, D), "Shigley, wire rope; an upper bound");
    s.eq("", "F_b", si::N, bending_pull(E_r, delta, A, D), "Shigley, equivalent bending load");
  }
  if (rules.resistance) write_resistance(s, use, F_min, d, known);
}

}  // namespace

void write_rope(Sheet<Num>& s, const RopeUse& use, const RopeRules& rules) {
  if (!rest_is_known(use)) {
    RopeRules own = rules;
    own.dynamic_factor = 1;
    own.dynamic_words = "T is the peak of a motion";
    return write_rope(s, at_peak(use), own);
  }
  if (!(use.rope.breaking_force > 0) || !rules.no_strength.empty() || !(use.tension > 0)) return;
  s.section(fmt::format("Rope {}: strength", use.name));
  Num F_min = s.named("F_min", si::N, use.rope.breaking_force);
  write_strength(s, use, rules, F_min);
  write_bending(s, use, rules, F_min);
}

}  // namespace taut::rope
