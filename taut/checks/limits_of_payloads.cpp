#include "taut/checks/limits_of_payloads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "taut/calc/shown.hpp"
#include "taut/catalogue/rule.hpp"
#include "taut/catalogue/trust.hpp"
#include "taut/checks/guy/guy_checks.hpp"
#include "taut/math/index.hpp"

namespace taut::checks {
namespace {

constexpr double rounding = 1e-6;  ///< relative: a state on a limit keeps it

/// Of a value and a limit of that kind.
const Unit& unit_of(study::LimitKind kind) {
  using Kind = study::LimitKind;
  if (kind == Kind::pull) return si::N;
  return kind == Kind::clearance || kind == Kind::rope_clearance ? si::m : si::rad;
}

/// A tension has its own check, and so has what a carriage is rated for.
bool has_check(study::LimitKind kind) {
  return kind == study::LimitKind::tension || kind == study::LimitKind::rated_payload;
}

/// Whether the carriage stands where the payload asks what it carries.
bool on_way(const study::Way& way, const Vector3& place) {
  const auto [low, high] = std::minmax(way.from, way.to);
  const double x = place.dot(way.along), near = rounding * std::max(1.0, std::abs(x));
  return x >= low - near && x <= high + near;
}

}  // namespace

void LimitsOfPayloads::add(const study::PayloadRun& run, const CheckedDeck& deck, const machine::Model& model) {
  Payload& one = payloads_.emplace_back();
  one.ending = run.ending;
  one.carriage = run.way.carriage;
  one.way = run.way;
  one.limits = run.limits;
  for (std::size_t i = 0; i < model.reevings.size(); ++i) {
    RopeSeen& rope = one.ropes.emplace_back();
    rope.name = model.reevings[i].name;
    rope.limit = run.limits.tension[i];
    rope.strength = model.reevings[i].breaking_force;
    rope.tension = run.tensions[i];
    rope.in_use = strength_in_use(deck, i);
    for (const study::PayloadFactor& one_of : run.factors) {
      if (as_size(one_of.reeving) == i) rope.factors.push_back(one_of);
    }
  }
}

bool LimitsOfPayloads::limits_itself(const std::string& rope) const {
  return std::any_of(payloads_.begin(), payloads_.end(), [&](const Payload& one) {
    return runs(one) && std::any_of(one.ropes.begin(), one.ropes.end(), [&](const RopeSeen& seen) {
             return seen.name == rope && std::isfinite(seen.limit);
           });
  });
}

void LimitsOfPayloads::take_tension(const std::string& rope, double T, const std::string& words) {
  const bool itself = limits_itself(rope);
  for (Payload& one : payloads_) {
    for (RopeSeen& seen : one.ropes) {
      if (seen.name != rope) continue;
      if (runs(one)) {
        seen.seen = true;
        seen.own = std::max(seen.own, T);
      } else if (!itself && T > seen.elsewhere.T) {
        seen.elsewhere = {.T = T, .where = words};
      }
    }
  }
}

void LimitsOfPayloads::take_strength(const machine::Reeving& rope, const std::string& words) {
  for (Payload& one : payloads_) {
    for (RopeSeen& seen : one.ropes) {
      const bool weaker = seen.name == rope.name && rope.breaking_force < seen.strength * (1 - rounding);
      if (!weaker || !seen.weaker.empty()) continue;
      const auto [force, strength] = brief_apart(rope.breaking_force, seen.strength, si::N, display_);
      seen.weaker = fmt::format("its breaking force is {} in '{}', and the payload's limit is that of {}", force, words,
                                strength);
    }
  }
}

void LimitsOfPayloads::take_others(const machine::Model& m, const solve::EquilibriumResult& e, const std::string& words,
                                   Payload& one) const {
  const int body = m.carriages[one.carriage].body;
  for (const study::LimitState& state : study::limits_at(m, body, one.limits, e)) {
    if (state.margin >= -rounding || has_check(state.kind)) continue;
    if (state.kind == study::LimitKind::clearance && !on_way(one.way, e.state.bodies[body].position)) continue;
    const std::string limit = study::limit_words(m, body, state);
    Exceeded& worst = one.exceeded[limit];
    if (state.margin >= worst.margin) continue;
    worst.margin = state.margin;
    const auto [has, most] = brief_apart(state.value, state.limit, unit_of(state.kind), display_);
    worst.words = fmt::format(
        "the payload limits the {} to {}, and '{}' has {}: a payload keeps its limits in its own states; "
        "give this one under 'checks' too, or give that analysis 'judge: false'",
        limit, most, words, has);
    if (state.kind == study::LimitKind::lift_off) {
      worst.words = fmt::format(
          "the payload allows no {}, which '{}' has: a payload keeps its limits in its own "
          "states; change the line, or give that analysis 'judge: false'",
          limit, words);
    }
  }
}

void LimitsOfPayloads::take(const machine::Model& m, const solve::EquilibriumResult& e, const std::string& words) {
  take_ropes(m, e, words);
  if (running_ != nullptr) return;
  for (Payload& one : payloads_) {
    if (m.reevings.size() == one.ropes.size()) take_others(m, e, words, one);
  }
}

void LimitsOfPayloads::take_ropes(const machine::Model& m, const solve::EquilibriumResult& e,
                                  const std::string& words) {
  for (std::size_t i = 0; i < m.reevings.size(); ++i) {
    take_tension(m.reevings[i].name, e.ropes[i].T_max, words);
    take_strength(m.reevings[i], words);
  }
}

void LimitsOfPayloads::take(const machine::Model& m, const solve::TransientResult& motion, const std::string& words,
                            bool slowly) {
  for (std::size_t i = 0; i < motion.ropes.size(); ++i) {
    const solve::RopeExtreme& rope = motion.ropes[i];
    const std::string& name = m.reevings[i].name;
    const std::string peak = fmt::format("{}, t = {:.4g} s", words, rope.T.t_max);
    take_tension(name, rope.T_static, words + ", before it begins");
    if (slowly) take_tension(name, rope.T.max, peak);
    for (Payload& one : payloads_) {
      RopeSeen& seen = one.ropes[i];
      if (!slowly && rope.T.max > seen.moving.T) seen.moving = {.T = rope.T.max, .where = peak};
    }
  }
}

void LimitsOfPayloads::tell_of_weaker(const RopeSeen& rope, Result& r) {
  if (rope.weaker.empty()) return;
  r.unmade.push_back(
      fmt::format("{0}: {1}: judge the rope by 'checks: {{ropes: {{{0}: ...}}}}'", rope.name, rope.weaker));
  r.warnings.push_back(r.unmade.back());
}

namespace {

/// A limit of a rope's tension in its heat, which the payload was not searched with.
struct TensionLimit {
  double most = std::numeric_limits<double>::infinity();  ///< N
  std::string rule;
  std::string trust = "user";
  std::string source = {};  ///< of its number, where that is not the deck
  std::vector<Doubt> doubts = {};
};

/// By a rule of the catalogue.
TensionLimit limit_of_rule(const study::PayloadFactor& by, double strength, const StrengthInUse& in_use) {
  const catalogue::RuleRow& row = *by.row;
  TensionLimit limit;
  limit.most = in_use.share * strength / by.factor;
  limit.source =
      fmt::format("{}: {}, {}; safety factor {:.4g} on the breaking force", row.id, row.field, row.item, by.factor);
  limit.rule = fmt::format("{}{}; {}", limit.source, in_use.words, row.source);
  limit.source += "; " + row.source;
  limit.trust = catalogue::trust_words(row);
  limit.doubts = in_use.doubts;
  return limit;
}

}  // namespace

void LimitsOfPayloads::add_checks_of(const RopeSeen& rope, const std::string& ending, Result& r) const {
  const double T = std::max(rope.own, rope.elsewhere.T);
  const auto add = [&](const TensionLimit& limit) {
    Check c =
        make_check(fmt::format("{}.payload_T_max{}", rope.name, ending), T, si::N,
                   with_doubts({.sense = Sense::at_most, .limit = limit.most, .rule = limit.rule, .trust = limit.trust},
                               limit.source, limit.doubts));
    c.part = rope.name;
    c.covers = {rope.name};
    if (rope.elsewhere.T > rope.own * (1 + rounding)) c.where = rope.elsewhere.where;
    c.limits = rope.moving.T <= limit.most * (1 + rounding);
    if (!c.limits) {
      const auto [most, has] = brief_apart(limit.most, rope.moving.T, si::N, display_);
      r.warnings.push_back(
          fmt::format("{}: the payload's limit, {}, is one of a rope at rest, and '{}' has {}: "
                      "judge the rope by 'checks: {{ropes: {{{}: ...}}}}'",
                      rope.name, most, rope.moving.where, has, rope.name));
    }
    r.checks.push_back(std::move(c));
  };
  const bool unknown = !rope.factors.empty() && !rope.in_use.unknown.empty();
  if (unknown) {
    leave_unmade(
        r,
        fmt::format("{}: the payload's limit by its breaking force is not checked: {}", rope.name, rope.in_use.unknown),
        {.part = {.kind = PartKind::rope, .name = rope.name}});
  }
  TensionLimit own{.most = rope.tension, .rule = "limit of the payload: the load is the largest one within it"};
  bool ruled = false;
  for (const study::PayloadFactor& one : rope.factors) {
    if (unknown) break;
    if (one.row != nullptr) {
      ruled = true;
      add(limit_of_rule(one, rope.strength, rope.in_use));
      continue;
    }
    own.most = std::min(own.most, rope.in_use.share * rope.strength / one.factor);
    if (!rope.in_use.words.empty()) own.rule += fmt::format(" with the cold rope; breaking force{}", rope.in_use.words);
    own.doubts = rope.in_use.doubts;
  }
  // the payload keeps within its own limit, so that its rule says more; another analysis need not
  if (std::isfinite(own.most) && (!ruled || T > own.most * (1 + rounding))) add(own);
}

void LimitsOfPayloads::add_checks(Result& r) const {
  for (const Payload& one : payloads_) {
    for (const RopeSeen& rope : one.ropes) {
      if (!rope.seen || !std::isfinite(rope.limit)) continue;
      const AboutPart about(r, {.kind = PartKind::rope, .name = rope.name});
      tell_of_weaker(rope, r);
      add_checks_of(rope, one.ending, r);
    }
    for (const auto& [limit, exceeded] : one.exceeded) {
      r.unmade.push_back(exceeded.words);
      r.warnings.push_back(exceeded.words);
    }
  }
}

}  // namespace taut::checks
