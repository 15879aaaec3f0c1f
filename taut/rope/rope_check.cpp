#include "taut/rope/rope_check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

#include "taut/calc/none.hpp"
#include "taut/calc/verdict.hpp"
#include "taut/rope/strength.hpp"

namespace taut::rope {
namespace {

std::string force(const RopeUse& use, double x) { return use.display.brief(x, si::N); }
std::string millimetres(const RopeUse& use, double x) { return use.display.brief(x, si::m.in("mm")); }

double ratio_of(const Bend& bend, const RopeUse& use) { return bend.diameter / use.rope.diameter; }

/// Whether a check is a limit of the rope's strength: what keeps it may pass. The others (D/d, grooves, drums, the
/// elastic limit of the tables, which leaves no factor for wear and doubt) can only fail.
bool limits_strength(std::string_view key, const RopeRules& rules) {
  if (key == "elastic_limit") return rules.own_elastic_share;
  constexpr std::array<std::string_view, 4> all = {"safety_factor", "on_sheave", "resistance", "dynamic_safety_factor"};
  return std::any_of(all.begin(), all.end(), [&](std::string_view one) { return key.starts_with(one); });
}

/// What one rope's checks are made of.
class RopeChecker {
 public:
  RopeChecker(const RopeUse& use, const RopeRules& rules) : use_(use), rules_(rules) {}

  RopeChecks all() {
    if (!rest_is_known(use_)) {
      statics_at_peak();
    } else if (use_.tension > 0) {
      statics();
    } else {
      leave_out("its strength", "no load case gives it a tension", itself());
    }
    if (std::max(use_.tension, use_.peak) > 0) out_.loaded.insert(itself());
    dynamics();
    heat();
    ratios();
    for (const DrumEnd& drum : use_.drums) on_drum(drum);
    drums_left_out();
    return std::move(out_);
  }

 private:
  double strength() const { return use_.rope.breaking_force * heat_share(rules_); }
  bool has_strength() const { return use_.rope.breaking_force > 0 && rules_.no_strength.empty(); }
  std::string why_no_strength() const {
    return use_.rope.breaking_force > 0 ? rules_.no_strength : "the breaking force is not known";
  }
  bool has_diameter() const { return use_.rope.diameter > 0; }

  std::string itself() const { return "rope " + use_.name; }

  void leave_out(const std::string& what, const std::string& why, const std::string& no_load = {}) {
    out_.left_out.push_back(fmt::format("{}: {} is not checked: {}", use_.name, what, why));
    if (!no_load.empty()) out_.no_load.emplace(out_.left_out.back(), no_load);
  }

  void add(const std::string& key, double value, const Unit& unit, Bound bound) {
    Check c = make_check(fmt::format("{}.{}", use_.name, key), value, unit, std::move(bound));
    c.part = use_.name;
    c.limits = limits_strength(key, rules_);
    if (c.limits) c.covers = {use_.name};
    out_.checks.push_back(std::move(c));
  }
  /// The same, of which only the worst place stays.
  void keep_worst(const std::string& key, double value, const Unit& unit, Bound bound) {
    add(key, value, unit, std::move(bound));
    auto& all = out_.checks;
    const auto before =
        std::find_if(all.begin(), all.end() - 1, [&](const Check& c) { return c.name == all.back().name; });
    if (before == all.end() - 1) return;
    if (worse_state(all.back(), *before)) *before = std::move(all.back());
    all.pop_back();
  }

  /// What is doubted in a check in which the rope's breaking force has a part, after the doubts of the limit.
  std::vector<Doubt> doubts_with(std::vector<Doubt> doubts) const {
    if (heat_share(rules_) < 1) add_doubt(rules_.heat_strength->trust, rules_.heat_strength->rule, doubts);
    add_doubt_of_rope(use_.rope, doubts);
    return doubts;
  }
  /// The dynamic factor has a part in a peak that no motion gives.
  void doubt_dynamics(bool of_motion, std::vector<Doubt>& doubts) const {
    if (!of_motion && rules_.dynamic_factor != 1) add_doubt(rules_.dynamic_trust, rules_.dynamic_words, doubts);
  }
  static std::vector<Doubt> doubts_of(const Limit& limit) {
    std::vector<Doubt> doubts;
    add_doubt(limit.trust, limit.rule, doubts);
    return doubts;
  }
  static Bound bound(Sense sense, const Limit& limit, std::string rule, std::vector<Doubt> doubts) {
    return {.sense = sense,
            .limit = limit.value,
            .rule = std::move(rule),
            .trust = trust_with(limit.trust, doubts),
            .doubts = std::move(doubts)};
  }
  std::string strength_words() const {
    const std::string cold = fmt::format("breaking force {}", force(use_, use_.rope.breaking_force));
    const double share = heat_share(rules_);
    return share < 1 ? fmt::format("{} x {:.3g} ({})", cold, share, rules_.heat_strength->rule) : cold;
  }

  void statics() {
    strength_static();
    strength_at_ends();
    strength_on_sheaves();
    resistance();
    fatigue();
    groove();
    wires();
    last_layer();
  }

  /// What passes at the peak would at rest. What fails there may pass at rest: then it is not known.
  void statics_at_peak() {
    RopeRules rules = rules_;
    rules.dynamic_factor = 1;
    const RopeUse peak = at_peak(use_);
    RopeChecker at_peak(peak, rules), at_rest(use_, rules_);
    at_peak.statics();
    if (use_.tension > 0) at_rest.statics();
    for (Check& check : at_peak.out_.checks) {
      const auto& known = at_rest.out_.checks;
      const auto same = std::find_if(known.begin(), known.end(), [&](const Check& c) { return c.name == check.name; });
      const bool fails = same != known.end() && !same->passes;
      const bool is_efficiency = check.name.ends_with(".termination") && check.value == rules_.termination->value;
      if (fails) {
        out_.checks.push_back(*same);
      } else if (check.passes || is_efficiency) {
        out_.checks.push_back(std::move(check));
      } else {
        out_.left_out.push_back(
            fmt::format("{} is not checked: {}; {}", check.name, why_rest_is_unknown(use_), how_to_know_rest(use_)));
      }
    }
    std::move(at_peak.out_.left_out.begin(), at_peak.out_.left_out.end(), std::back_inserter(out_.left_out));
    out_.no_load.merge(at_peak.out_.no_load);
  }

  void strength_static() {
    if (!has_strength()) {
      if (!rules_.safety_factors.empty()) leave_out("its strength", why_no_strength());
      return;
    }
    for (std::size_t i = 0; i < rules_.safety_factors.size(); ++i) {
      const Limit& limit = rules_.safety_factors[i];
      add(i == 0 ? "safety_factor" : fmt::format("safety_factor_{}", i + 1), strength() / use_.tension, si::one,
          bound(Sense::at_least, limit,
                fmt::format("{} over the largest tension {} ({}): {}", strength_words(), force(use_, use_.tension),
                            use_.where, limit.rule),
                doubts_with(doubts_of(limit))));
    }
  }

  void strength_at_ends() {
    if (!rules_.termination) return;
    if (!rules_.termination_refused.empty()) leave_out("its termination", rules_.termination_refused);
    const Limit& efficiency = *rules_.termination;
    if (rules_.least_termination) {
      const Limit& least = *rules_.least_termination;
      add("termination", efficiency.value, si::one,
          bound(Sense::at_least, least, fmt::format("efficiency of {}: {}", efficiency.rule, least.rule),
                doubts_of(least)));
    }
    if (!has_strength()) return;
    if (use_.ends.empty()) leave_out("its termination", "no end of it is fixed: both lie on drums, or it is endless");
    if (rules_.safety_factors.empty() && !rules_.least_termination)
      leave_out("its termination", "no rule gives a safety factor");
    for (const RopeEnd& end : use_.ends) {
      for (const Limit& limit : rules_.safety_factors) {
        if (limit.covers_ends || !(end.tension > 0)) continue;
        std::vector<Doubt> doubts = doubts_of(efficiency);
        add_doubt(limit.trust, limit.rule, doubts);
        keep_worst("termination", efficiency.value * strength() / end.tension, si::one,
                   bound(Sense::at_least, limit,
                         fmt::format("{} x {:.3g} of {} over the tension {} at '{}': {}", strength_words(),
                                     efficiency.value, efficiency.rule, force(use_, end.tension), end.name, limit.rule),
                         doubts_with(std::move(doubts))));
      }
    }
  }

  void strength_on_sheaves() {
    const auto covered = [](const Limit& limit) { return limit.covers_bending; };
    if (rules_.bending_asked && rules_.safety_factors.empty())
      return leave_out("the weakening on sheaves", "no rule gives a safety factor at rest");
    if (!has_strength() || std::all_of(rules_.safety_factors.begin(), rules_.safety_factors.end(), covered)) return;
    if (rules_.bending_asked || (use_.chosen && use_.measurable)) {
      unmeasured("the weakening on sheaves");
    } else if (!use_.unmeasured.empty()) {
      out_.remarks.push_back(fmt::format("{}: the weakening on sheaves is not checked: no diameter is known of {}",
                                         use_.name, use_.unmeasured.front()));
    }
    if (rules_.bending_asked && !has_diameter()) leave_out("the weakening on sheaves", "the diameter is not known");
    if (!has_diameter()) return;
    for (const Bend& bend : use_.bends) {
      if (!(bend.tension > 0) || bend.wrap < least_wrap) continue;
      const double left = sheave_strength(ratio_of(bend, use_));
      for (const Limit& limit : rules_.safety_factors) {
        if (limit.covers_bending) continue;
        std::vector<Doubt> doubts;
        add_doubt("UNVERIFIED: weakening on a sheave, recalled", "weakening on a sheave, 1 - 0.5/sqrt(D/d)", doubts);
        add_doubt(limit.trust, limit.rule, doubts);
        keep_worst(
            "on_sheave", left * strength() / bend.tension, si::one,
            bound(Sense::at_least, limit,
                  fmt::format(
                      "{} x {:.3g} (1 - 0.5/sqrt(D/d), D/d = {:.3g}, unverified) over the tension {} at '{}': {}",
                      strength_words(), left, ratio_of(bend, use_), force(use_, bend.tension), bend.name, limit.rule),
                  doubts_with(std::move(doubts))));
      }
    }
  }

  void resistance() {
    if (!rules_.resistance) return;
    if (!has_strength()) return leave_out("EN 13001-3-2", why_no_strength());
    if (!has_diameter()) return leave_out("EN 13001-3-2", "the diameter is not known");
    unmeasured("EN 13001-3-2");
    const auto counts = [](const Bend& bend) { return bend.kind != BendKind::saddle && bend.tension > 0; };
    if (use_.unmeasured.empty() && std::none_of(use_.bends.begin(), use_.bends.end(), counts))
      leave_out("EN 13001-3-2", "no sheave or drum bends it under tension");
    for (const Bend& bend : use_.bends) {
      if (!counts(bend)) continue;
      const double ratio = ratio_of(bend, use_);
      // out of the formula's range no factor is enough
      const double gamma = ratio > least_ratio_en13001 ? resistance_factor(ratio) : HUGE_VAL;
      const double by_factor = rules_.dynamic_factor * bend.tension, pull = std::max(by_factor, use_.peak);
      const std::string words = use_.peak > by_factor ? fmt::format("F_Sd = {}, the peak of the rope ({}), at '{}'",
                                                                    force(use_, pull), use_.peak_where, bend.name)
                                                      : fmt::format("F_Sd = {:.3g} x {} at '{}'", rules_.dynamic_factor,
                                                                    force(use_, bend.tension), bend.name);
      std::vector<Doubt> doubts = doubts_of(*rules_.resistance);
      doubt_dynamics(use_.peak > by_factor, doubts);
      Limit limit = *rules_.resistance;
      limit.value = strength() / gamma;
      keep_worst("resistance", pull, si::N,
                 bound(Sense::at_most, limit,
                       fmt::format("{} at most F_u/gamma_rb, gamma_rb = {:.4g} (D/d = {:.3g}): {}", words, gamma, ratio,
                                   limit.rule),
                       doubts_with(std::move(doubts))));
    }
  }

  void fatigue() {
    if (!rules_.fatigue_history || !rules_.resistance || !has_strength()) return;
    const double by_factor = rules_.dynamic_factor * use_.tension, pull = std::max(by_factor, use_.peak);
    const std::string words = use_.peak > by_factor
                                  ? fmt::format("{}, the peak of the rope ({})", force(use_, pull), use_.peak_where)
                                  : fmt::format("{:.3g} x {}", rules_.dynamic_factor, force(use_, use_.tension));
    std::vector<Doubt> doubts = doubts_of(*rules_.resistance);
    doubt_dynamics(use_.peak > by_factor, doubts);
    Limit limit = *rules_.resistance;
    limit.value = fatigue_pull(strength(), rules_.fatigue_factor, *rules_.fatigue_history);
    add("fatigue", pull, si::N,
        bound(Sense::at_most, limit,
              fmt::format("F_Sd = {} at most F_u f_f/(7 s_r^(1/3)), f_f = {:.3g}, s_r = {:.4g}: EN 13001-3-2", words,
                          rules_.fatigue_factor, *rules_.fatigue_history),
              doubts_with(std::move(doubts))));
  }

  void dynamics() {
    if (!has_strength() && (rules_.dynamic_safety || rules_.elastic_share))
      leave_out("its dynamic strength", why_no_strength());
    const double peak = peak_tension(use_, rules_);
    if (!(peak > 0) || !has_strength()) return;
    const bool of_motion = use_.peak > 0 && use_.peak >= rules_.dynamic_factor * use_.tension;
    const std::string words = of_motion ? fmt::format("peak {} ({})", force(use_, peak), use_.peak_where)
                                        : fmt::format("{} = {:.3g} x {} ({})", force(use_, peak), rules_.dynamic_factor,
                                                      force(use_, use_.tension), rules_.dynamic_words);
    const auto doubts = [&](const Limit& limit) {
      std::vector<Doubt> all = doubts_of(limit);
      doubt_dynamics(of_motion, all);
      return doubts_with(std::move(all));
    };
    if (rules_.dynamic_safety) {
      add("dynamic_safety_factor", strength() / peak, si::one,
          bound(Sense::at_least, *rules_.dynamic_safety,
                fmt::format("{} over {}: {}", strength_words(), words, rules_.dynamic_safety->rule),
                doubts(*rules_.dynamic_safety)));
    }
    if (rules_.elastic_share) {
      Limit limit = *rules_.elastic_share;
      limit.value *= strength();
      add("elastic_limit", peak, si::N,
          bound(Sense::at_most, limit,
                fmt::format("{} at most {:.3g} x {}: {}", words, rules_.elastic_share->value, strength_words(),
                            limit.rule),
                doubts(limit)));
    }
  }

  void heat() {
    if (rules_.temperature && rules_.hottest_end) {
      add("end_temperature", *rules_.temperature, si::K.in("degC"),
          {.sense = Sense::at_most,
           .limit = rules_.hottest_end->value,
           .rule = rules_.hottest_end->rule,
           .trust = rules_.hottest_end->trust});
    }
    if (!rules_.temperature || !rules_.hottest) return;
    add("temperature", *rules_.temperature, si::K.in("degC"),
        {.sense = Sense::at_most,
         .limit = rules_.hottest->value,
         .rule = rules_.hottest->rule,
         .trust = rules_.hottest->trust});
  }

  /// Where it runs over sheaves that the deck gives no diameter of.
  void unmeasured(const char* what) {
    if (use_.unmeasured.empty()) return;
    leave_out(what, "no diameter is known of " + use_.unmeasured.front());
  }

  void ratios_left_out() {
    const bool bent = std::any_of(use_.bends.begin(), use_.bends.end(),
                                  [](const Bend& bend) { return bend.kind != BendKind::saddle; });
    const auto low = std::find_if(use_.bends.begin(), use_.bends.end(),
                                  [](const Bend& bend) { return bend.kind == BendKind::compensating_sheave; });
    // a candidate must not win because no rule knows its construction
    auto& told = rules_.ratio_asked || use_.chosen ? out_.left_out : out_.remarks;
    const bool no_rule = rules_.sheave_ratios.empty() && rules_.drum_ratios.empty();
    if (rules_.runs && !no_rule && low != use_.bends.end() && rules_.compensating_ratios.empty()) {
      told.push_back(
          fmt::format("{}: D/d of '{}' is not checked: no rule is for a compensating sheave: give 'class' or "
                      "'diameter_ratio'",
                      use_.name, low->name));
    }
    if (rules_.runs && bent && no_rule) {
      told.push_back(
          fmt::format("{}: D/d is not checked: no rule is for its construction{}: give 'construction', "
                      "'class' or 'diameter_ratio', or 'running: stands' of a rope that does not run",
                      use_.name, use_.rope.construction.empty() ? "" : " " + use_.rope.construction));
    }
    const auto slides = std::find_if(use_.bends.begin(), use_.bends.end(), [](const Bend& bend) {
      return bend.kind == BendKind::saddle && bend.tension > 0 && bend.wrap >= least_wrap;
    });
    if ((rules_.no_saddles || (rules_.ratio_asked && !bent)) && slides != use_.bends.end()) {
      leave_out("D/d", fmt::format("{} slides over the saddle '{}', for which there is no rule: use a sheave there",
                                   rules_.no_saddles ? "a running rope" : "the rope", slides->name));
    }
  }

  void ratios() {
    if (rules_.ratio_asked || (use_.chosen && use_.measurable && rules_.runs)) unmeasured("D/d");
    const auto check = [&](BendKind kind, const std::vector<Limit>& limits, const char* key) {
      if (limits.empty()) return;
      for (const Bend& bend : use_.bends) {
        if (bend.kind != kind) continue;
        if (!has_diameter()) return leave_out("D/d", "the diameter is not known");
        for (const Limit& limit : limits) {
          keep_worst(key, ratio_of(bend, use_), si::one,
                     {.sense = Sense::at_least,
                      .limit = limit.value,
                      .rule = fmt::format("D/d of '{}', {} over {}: {}", bend.name, millimetres(use_, bend.diameter),
                                          millimetres(use_, use_.rope.diameter), limit.rule),
                      .trust = limit.trust});
        }
      }
    };
    ratios_left_out();
    check(BendKind::sheave, rules_.sheave_ratios, "sheave_ratio");
    check(BendKind::compensating_sheave, rules_.compensating_ratios, "compensating_ratio");
    check(BendKind::drum, rules_.drum_ratios, "drum_ratio");
  }

  void groove() {
    if (!rules_.groove_pressure) return;
    if (!has_diameter()) return leave_out("groove pressure", "the diameter is not known");
    unmeasured("groove pressure");
    for (const Bend& bend : use_.bends) {
      if (!(bend.tension > 0)) continue;
      keep_worst("groove_pressure", groove_pressure(bend.tension, use_.rope.diameter, bend.diameter), si::Pa,
                 {.sense = Sense::at_most,
                  .limit = rules_.groove_pressure->value,
                  .rule = fmt::format("p = 2 F/(d D) at '{}', F = {}: {}", bend.name, force(use_, bend.tension),
                                      rules_.groove_pressure->rule),
                  .trust = rules_.groove_pressure->trust});
    }
  }

  /// Tension and bending together in the outer wires, against the strength of the wire.
  void wires() {
    if (!rules_.wire || !use_.rope.grade || !(use_.rope.area > 0) || !has_diameter()) return;
    const double wire = rules_.wire->value * use_.rope.diameter;
    for (const Bend& bend : use_.bends) {
      if (!(bend.tension > 0) || bend.wrap < least_wrap) continue;
      const double bent = bending_stress(rules_.bending_modulus, wire, bend.diameter);
      const bool doubt = is_unverified(rules_.wire->trust);
      keep_worst("wire_stress", bend.tension / use_.rope.area + bent, si::Pa,
                 {.sense = Sense::at_most,
                  .limit = *use_.rope.grade,
                  .rule = fmt::format("T/A {} + E_r delta/D {} at '{}' (delta = {}, {}; an upper bound, "
                                      "Shigley), the bending alone as much as a pull of {}: grade of the wires",
                                      use_.display.brief(bend.tension / use_.rope.area, si::Pa),
                                      use_.display.brief(bent, si::Pa), bend.name, millimetres(use_, wire),
                                      rules_.wire->rule, force(use_, bent * use_.rope.area)),
                  .trust = doubt ? rules_.wire->trust : "derived"});
    }
  }

  void on_drum(const DrumEnd& drum) {
    if (rules_.fleet_angle && drum.fleet_angle) {
      keep_worst("fleet_angle", *drum.fleet_angle, si::rad,
                 {.sense = Sense::at_most,
                  .limit = rules_.fleet_angle->value,
                  .rule = fmt::format("at a flange of '{}': {}", drum.name, rules_.fleet_angle->rule),
                  .trust = rules_.fleet_angle->trust});
    }
    if (rules_.layers && drum.layers) {
      keep_worst("drum_layers", *drum.layers, si::one,
                 {.sense = Sense::at_most,
                  .limit = rules_.layers->value,
                  .rule = fmt::format("layers on '{}': {}", drum.name, rules_.layers->rule),
                  .trust = rules_.layers->trust});
    }
  }

  void last_layer() {
    for (const DrumEnd& drum : use_.drums) {
      if (!rules_.rated_pull || !drum.first_radius || !drum.last_radius || !(drum.tension > 0)) continue;
      const double own = use_.copies * drum.tension;
      constexpr double rounding = 1e-9;
      const bool others = drum.haul > (1 + rounding) * own;
      keep_worst("last_layer_pull", std::max(own, drum.haul), si::N,
                 {.sense = Sense::at_most,
                  .limit = *rules_.rated_pull * *drum.first_radius / *drum.last_radius,
                  .rule = fmt::format("pull of '{}' in its last layer{}: {} in the first one x {}/{}", drum.name,
                                      others            ? ", with its other ropes"
                                      : use_.copies > 1 ? fmt::format(", {} ropes", use_.copies)
                                                        : "",
                                      force(use_, *rules_.rated_pull), use_.display.brief(*drum.first_radius, si::m),
                                      use_.display.brief(*drum.last_radius, si::m)),
                  .trust = "user"});
    }
  }

  /// What the deck asks of drums that have not the data for it.
  void drums_left_out() {
    const auto tell = [&](bool asked, const char* what, const auto& needs, const auto& known) {
      if (!asked) return;
      if (use_.drums.empty()) return leave_out(what, "it ends on no drum");
      for (const DrumEnd& drum : use_.drums) {
        const std::string pulls = fmt::format("{} at drum {}", itself(), drum.name);
        if (drum.tension > 0) out_.loaded.insert(pulls);
        if (known(drum)) continue;
        if (drum.tension > 0) {
          leave_out(what, fmt::format("the drum '{}' needs {}", drum.name, needs(drum)));
        } else {
          leave_out(what, fmt::format("in no state the rope pulls at the drum '{}'", drum.name), pulls);
        }
      }
    };
    tell(
        rules_.fleet_angle.has_value(), "its fleet angle", [](const DrumEnd&) { return "'face_width'"; },
        [](const DrumEnd& d) { return d.fleet_angle.has_value(); });
    const auto layered = [](const DrumEnd& d) { return d.layers.has_value(); };
    const auto of_layers = [](const DrumEnd& d) {
      return d.lacks.empty() ? "'face_width' and 'length_on_drum'" : fmt::format("{}", fmt::join(d.lacks, " and "));
    };
    tell(rules_.layers.has_value(), "the number of its layers", of_layers, layered);
    tell(rules_.rated_pull.has_value(), "the pull in the last layer", of_layers, layered);
  }

  const RopeUse& use_;
  const RopeRules& rules_;
  RopeChecks out_;
};

}  // namespace

RopeChecks check_rope(const RopeUse& use, const RopeRules& rules) { return RopeChecker(use, rules).all(); }

double heat_share(const RopeRules& rules) {
  if (!rules.no_strength.empty()) return none;
  return rules.heat_strength ? rules.heat_strength->value : 1.0;
}

void add_doubt(const std::string& trust, const std::string& source, std::vector<Doubt>& doubts) {
  if (is_unverified(trust)) doubts.push_back({.trust = trust, .source = source});
}

void add_doubt_of_rope(const catalogue::RopeRow& rope, std::vector<Doubt>& doubts) {
  if (rope.trust != catalogue::Trust::unverified) return;
  const std::string words = fmt::format("breaking force of the rope{}", rope.id.empty() ? "" : " " + rope.id);
  add_doubt("UNVERIFIED: " + words, words, doubts);
}

std::string trust_with(const std::string& limit, const std::vector<Doubt>& doubts) {
  return doubts.empty() ? limit : doubts.front().trust;
}

namespace {

constexpr double sudden_load = 2;     ///< what a load does that is put on an elastic rope at once
constexpr double still_moves = 0.05;  ///< by which a motion may end above the tension at rest: friction, small swings

}  // namespace

bool rest_is_known(const RopeUse& use) {
  const double goes_on = std::max(use.last, use.mean);
  return use.peak <= sudden_load * use.tension && !goes_beyond_rest(goes_on, use.tension);
}

bool goes_beyond_rest(double tension, double at_rest) { return tension > (1 + still_moves) * at_rest; }

namespace {

/// "tension at rest, 15 kN (load path, in, x = 40 m)". Where no state at rest has as much, what lasts in a motion
/// stands for it.
std::string lasting_words(const RopeUse& use) {
  return fmt::format("tension {}, {}{}", use.lasts ? "that lasts" : "at rest", force(use, use.tension),
                     use.where.empty() ? std::string() : fmt::format(" ({})", use.where));
}

}  // namespace

std::string why_rest_is_unknown(const RopeUse& use) {
  if (use.peak > sudden_load * use.tension)
    return fmt::format("the motion reaches {}, more than twice the {}", force(use, use.peak), lasting_words(use));
  if (goes_beyond_rest(use.mean, use.tension)) {
    return fmt::format(
        "the motion has {} on average ({}), more than the largest {}: a load that comes and goes, or a "
        "slow swing",
        force(use, use.mean), use.mean_where, lasting_words(use));
  }
  return fmt::format(
      "the motion ends with {} on average, more than the largest {}, and not for long enough to tell "
      "whether it stays",
      force(use, use.last), lasting_words(use));
}

std::string how_to_know_rest(const RopeUse& use) {
  if (!use.analysed || !(use.peak > sudden_load * use.tension)) return "add an analysis at rest with the full load";
  return "where that is the full load, the factor has to hold at the peak too: take a stronger rope, or let the load "
         "come on with less slack or more slowly, so that the peak stays below twice that; 'dynamic_safety_factor' in "
         "place of 'safety_factor' asks a factor of the peak alone";
}

RopeUse at_peak(RopeUse use) {
  use.tension = use.peak;
  use.where = use.peak_where;
  for (Bend& bend : use.bends) bend.tension = use.peak;
  for (RopeEnd& end : use.ends) end.tension = use.peak;
  for (DrumEnd& drum : use.drums) {
    drum.tension = use.peak;
    drum.haul = std::max(drum.haul, drum.haul_peak);
  }
  return use;
}

double peak_tension(const RopeUse& use, const RopeRules& rules) {
  return std::max(use.peak, rules.dynamic_factor * use.tension);
}

}  // namespace taut::rope
