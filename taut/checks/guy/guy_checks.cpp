#include "taut/checks/guy/guy_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/base/suggest.hpp"
#include "taut/catalogue/rule.hpp"
#include "taut/catalogue/trust.hpp"
#include "taut/checks/rope/rope_rules.hpp"
#include "taut/checks/rope/rope_strength.hpp"
#include "taut/math/index.hpp"
#include "taut/rope/rope_check.hpp"

namespace taut::checks {
namespace {

constexpr const char* by_recalled_gamma = "UNVERIFIED: gamma_Mg = 2.0 of EN 1993-3-1 as recalled";
constexpr double least_tension = 1;  // N, of a rope without weight
constexpr const char* by_recalled_window = "UNVERIFIED: 8 to 15 % as recalled";

/// The machine's guys that a name means: one, or all of a rope.
std::vector<std::string> guys_named(const std::string& name, const CheckedDeck& deck) {
  std::vector<std::string> own, of_rope;
  for (const auto& guy : deck.machine.guys) {
    if (guy.name == name) own.push_back(guy.name);
    if (guy.rope == name) of_rope.push_back(guy.name);
  }
  return own.empty() ? of_rope : own;
}

const machine::Reeving* reeving_named(const machine::Model& model, const std::string& name) {
  const auto found =
      std::find_if(model.reevings.begin(), model.reevings.end(), [&](const auto& one) { return one.name == name; });
  return found == model.reevings.end() ? nullptr : &*found;
}

/// The tension of a rope that is just as long as its chord, by the parabola: (EA (w c cos theta)^2/24)^(1/3), N. Below
/// it the rope only carries itself. Infinite for an inextensible one with weight: no tension makes it so short.
double slack_tension(const machine::Reeving& rope, const CheckBranch& branch) {
  const Vector3 chord = branch.end - branch.start;
  const double across = rope.weight * std::hypot(chord.x(), chord.y());
  if (across == 0) return least_tension;
  return std::max(std::cbrt(rope.stiffness * across * across / 24), least_tension);
}

void take_least(double T, double T_slack, const std::string& words, GuyStates& guy) {
  if (T / T_slack >= guy.reserve) return;
  guy.reserve = T / T_slack;
  guy.T_least = T;
  guy.T_slack = T_slack;
  guy.where_least = words;
}

/// A guy's breaking force, and what is left of it in use.
struct GuyStrength {
  double cold = 0;  ///< N
  std::vector<Doubt> doubts_of_cold;
  StrengthInUse in_use;
};

void check_safety(const GuyStates& guy, const std::string& name, const GuyStrength& strength, Result& r) {
  const GuyCheckRequest& request = *guy.request;
  if (!strength.in_use.unknown.empty()) {
    leave_unmade(r, fmt::format("{}: its safety is not checked: {}", name, strength.in_use.unknown),
                 {.part = {.kind = PartKind::rope, .name = name}});
    return;
  }
  RuleLimit limit{.value = 2, .words = "partial factor of guys, EN 1993-3-1", .trust = by_recalled_gamma};
  if (request.rule) limit = rule_limit(*request.rule, true);
  if (request.safety_factor) limit = {.value = *request.safety_factor, .words = "the deck's own", .trust = "user"};
  add_strength_check(name, "guy_safety", strength.in_use.share * strength.cold / guy.T_max, si::one,
                     with_doubts({.sense = Sense::at_least,
                                  .limit = limit.value,
                                  .rule = fmt::format("breaking force {}{} over the largest tension {} ({}); {}",
                                                      guy.display.brief(strength.cold, si::N), strength.in_use.words,
                                                      guy.display.brief(guy.T_max, si::N), guy.where_max, limit.words),
                                  .trust = limit.trust},
                                 limit.words, strength.in_use.doubts),
                     r);
}

/// `tensions`: as put up and as pulled, each with its state. They are shares of the cold strength, which is the one
/// that the rope is named by.
void check_pretension(const GuyStates& guy, const std::string& name,
                      const std::vector<std::pair<double, std::string>>& tensions, const GuyStrength& strength,
                      Result& r) {
  const GuyCheckRequest& request = *guy.request;
  const bool own = request.pretension.size() == 2;
  const double low = own ? request.pretension[0] : 0.08, high = own ? request.pretension[1] : 0.15;
  const auto words = [&](const std::pair<double, std::string>& state) {
    return fmt::format("tension {}, {}, over the breaking force: {:.3g} to {:.3g}{}", state.second,
                       guy.display.brief(state.first, si::N), low, high, own ? "" : ", EN 1993-3-1 practice");
  };
  const std::string trust = own ? "user" : by_recalled_window;
  const auto [least, most] = std::minmax_element(tensions.begin(), tensions.end(),
                                                 [](const auto& a, const auto& b) { return a.first < b.first; });
  const auto bound = [&](Sense sense, double limit, const std::string& rule) {
    return with_doubts({.sense = sense, .limit = limit, .rule = rule, .trust = trust}, rule, strength.doubts_of_cold);
  };
  add_part_check(name, "pretension_min", least->first / strength.cold, si::one,
                 bound(Sense::at_least, low, words(*least)), r);
  add_part_check(name, "pretension_max", most->first / strength.cold, si::one,
                 bound(Sense::at_most, high, words(*most)), r);
}

/// Why a rule of the catalogue gives no safety factor; empty when it does.
std::string wrong_safety_rule(const std::string& id) {
  const auto row = catalogue::find_rule(id);
  if (!row) return catalogue::to_text(row.error());
  if (row->low && row->id.starts_with("safety.")) return {};
  return fmt::format("'{}' is no safety factor with a number", row->id);
}

}  // namespace

RuleLimit rule_limit(const std::string& id, bool high_end) {
  const auto row = catalogue::find_rule(id);
  if (!row || !row->low || !row->high)
    return {.value = std::nan(""), .words = "there is no such rule", .trust = "UNVERIFIED: no such rule"};
  RuleLimit limit{.value = high_end ? *row->high : *row->low,
                  .words = fmt::format("{}: {} ({})", row->item, row->text.empty() ? row->id : row->text, row->source),
                  .trust = catalogue::trust_words(*row)};
  if (*row->low != *row->high) limit.words += fmt::format("; of {:.4g} to {:.4g} the safe end", *row->low, *row->high);
  return limit;
}

Bound with_doubts(Bound bound, const std::string& source, const std::vector<Doubt>& others) {
  rope::add_doubt(bound.trust, source, bound.doubts);
  bound.doubts.insert(bound.doubts.end(), others.begin(), others.end());
  bound.trust = rope::trust_with(bound.trust, bound.doubts);
  return bound;
}

std::string with_factor(const std::string& words, double factor) {
  return factor == 1 ? words : fmt::format("{}, times {:.4g}", words, factor);
}

void add_part_check(const std::string& part, const std::string& name, double value, const Unit& unit, Bound bound,
                    Result& r) {
  Check c = make_check(fmt::format("{}.{}", part, name), value, unit, std::move(bound));
  c.part = part;
  r.checks.push_back(std::move(c));
}

void add_strength_check(const std::string& part, const std::string& name, double value, const Unit& unit, Bound bound,
                        Result& r) {
  add_part_check(part, name, value, unit, std::move(bound), r);
  r.checks.back().covers = {part};
}

namespace {

void complain_of_guy(const GuyCheckRequest& one, const std::vector<std::string>& names, const std::string& path,
                     const machine::Model& model, std::vector<Complaint>& complaints) {
  if (one.safety_factor && one.rule) complaints.push_back({path + ".rule", "either 'safety_factor' or 'rule'"});
  if (one.rule) {
    const std::string wrong = wrong_safety_rule(*one.rule);
    if (!wrong.empty()) complaints.push_back({path + ".rule", wrong});
  }
  if (!one.pretension.empty() && (one.pretension.size() != 2 || one.pretension[0] >= one.pretension[1])) {
    complaints.push_back({path + ".pretension", "is the least and the largest share, in this order: [0.08, 0.15]"});
  }
  for (const std::string& name : names) {
    const machine::Reeving* rope = reeving_named(model, name);
    if (rope != nullptr)
      complain_of_second(one.breaking_force, rope->breaking_force, path + ".breaking_force", complaints);
    if (one.breaking_force || (rope != nullptr && rope->breaking_force > 0)) continue;
    complaints.push_back({path, fmt::format("the breaking force of '{}' is not known: give 'breaking_force'", name)});
  }
}

}  // namespace

void complain_of_guys(const std::vector<GuyCheckRequest>& guys, const CheckedDeck& deck, const machine::Model& model,
                      std::vector<Complaint>& complaints) {
  for (const GuyCheckRequest& one : guys) {
    const std::string path = fmt::format("checks.guys.{}", one.name);
    const std::vector<std::string> names = guys_named(one.name, deck);
    if (names.empty()) {
      std::vector<std::string> known;
      known.reserve(deck.machine.guys.size());
      for (const auto& guy : deck.machine.guys) known.push_back(guy.name);
      complaints.push_back({path, fmt::format("there is no guy, and no guy of a rope, '{}'{}", one.name,
                                              did_you_mean(one.name, known))});
      continue;
    }
    complain_of_guy(one, names, path, model, complaints);
  }
}

std::vector<GuyStates> guy_states(const std::vector<GuyCheckRequest>& guys, const CheckedDeck& deck,
                                  const machine::Model& model) {
  std::vector<GuyStates> all;
  for (const GuyCheckRequest& one : guys) {
    for (const std::string& name : guys_named(one.name, deck)) {
      GuyStates& guy = all.emplace_back();
      guy.request = &one;
      guy.reeving = static_cast<int>(reeving_named(model, name) - model.reevings.data());
    }
  }
  return all;
}

void take(const CheckState& state, GuyStates& guy) {
  const double factor = guy.request->dynamic_factor;
  for (const CheckBranch& b : state.branches) {
    if (b.reeving != guy.reeving) continue;
    if (b.T * factor > guy.T_max) {
      guy.T_max = b.T * factor;
      guy.where_max = with_factor(state.words, factor);
    }
    take_least(b.mean, slack_tension(state.model->reevings[guy.reeving], b), state.words, guy);
  }
}

void take_put_up(const CheckState& state, const std::string& name, GuyStates& guy) {
  const double factor = guy.request->dynamic_factor;
  for (const CheckBranch& b : state.branches) {
    if (state.model->reevings[b.reeving].name != name || b.T * factor <= guy.T_max) continue;
    guy.T_max = b.T * factor;
    guy.where_max = with_factor(state.words, factor);
  }
}

void take_motion(const CheckState& begins, const solve::TransientResult& motion, const std::string& words, bool slowly,
                 GuyStates& guy) {
  const solve::RopeExtreme& rope = motion.ropes[guy.reeving];
  const solve::Extreme& T = rope.T;
  const auto raise = [&](double tension, double factor, const std::string& where) {
    if (!(tension * factor > guy.T_max)) return;  // nor one that is not known
    guy.T_max = tension * factor;
    guy.where_max = with_factor(where, factor);
  };
  const double of_rest = guy.request->dynamic_factor;
  if (!slowly) raise(rope.T_static, of_rest, words + ", before it begins");
  raise(T.max, slowly ? of_rest : 1, fmt::format("{}, t = {:.4g} s", words, T.t_max));
  for (const CheckBranch& b : begins.branches) {
    if (b.reeving != guy.reeving) continue;
    take_least(rope.T_loosest, slack_tension(begins.model->reevings[guy.reeving], b),
               fmt::format("{}, t = {:.4g} s", words, rope.t_loosest), guy);
  }
}

void add_guy_checks(const std::vector<GuyStates>& guys, const CheckedDeck& deck, const machine::Model& model,
                    Result& r) {
  for (const GuyStates& one : guys) {
    const machine::Reeving& rope = model.reevings[one.reeving];
    GuyStrength strength{
        .cold = rope.breaking_force > 0 ? rope.breaking_force : one.request->breaking_force.value_or(0),
        .doubts_of_cold = {},
        .in_use = strength_in_use(deck, as_size(one.reeving))};
    add_doubt_of_rope(deck, as_size(one.reeving), strength.doubts_of_cold);
    const Part part = {.kind = PartKind::rope, .name = rope.name};
    const AboutPart about(r, part);
    if (one.T_max > 0) {
      r.loaded.insert("guy " + rope.name);
      check_safety(one, rope.name, strength, r);
    } else {
      leave_unmade(r, fmt::format("{}: its safety is not checked: no load case gives it a tension", rope.name),
                   {.part = part, .no_load = "guy " + rope.name});
    }
    if (!one.request->may_go_slack && std::isinf(one.T_slack)) {
      r.unmade.push_back(fmt::format(
          "{}: whether it hangs slack is not checked: an inextensible rope with weight is longer than its chord under "
          "any tension; give its 'stiffness', or 'may_go_slack'",
          rope.name));
      r.warnings.push_back(r.unmade.back());
    } else if (!one.request->may_go_slack && std::isfinite(one.reserve)) {
      add_part_check(
          rope.name, "slackness", one.T_least, si::N,
          {.sense = Sense::at_least,
           .limit = one.T_slack,
           .rule = fmt::format("least tension against that of a guy just as long as its chord, below which it hangs "
                               "slack and holds nothing ({})",
                               one.where_least),
           .trust = "derived"},
          r);
    }
    const auto guy = std::find_if(deck.machine.guys.begin(), deck.machine.guys.end(),
                                  [&](const auto& g) { return g.name == rope.name; });
    if (!one.request->check_pretension) continue;
    auto tensions = one.pulled;
    if (guy->install) tensions.insert(tensions.begin(), {guy->install->tension, "as put up"});
    if (!tensions.empty()) {
      check_pretension(one, rope.name, tensions, strength, r);
    } else if (!one.request->pretension.empty()) {
      r.unmade.push_back(fmt::format(
          "{}: its pretension is not checked: it has a length; give 'install' with the tension", rope.name));
      r.warnings.push_back(r.unmade.back());
    }
  }
}

}  // namespace taut::checks
