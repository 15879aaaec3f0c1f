#include "taut/checks/rope/rope_life.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "taut/base/number.hpp"
#include "taut/base/suggest.hpp"
#include "taut/calc/verdict.hpp"
#include "taut/catalogue/construction.hpp"
#include "taut/catalogue/rule.hpp"
#include "taut/catalogue/trust.hpp"
#include "taut/checks/described.hpp"

namespace taut::checks {
namespace {

constexpr const char* count_names[] = {"mean_break", "break_10", "discard", "discard_10"};

/// "1.278; 0.029; 6.241; -1.613".
std::array<double, 4> numbers_of(const std::string& text) {
  std::array<double, 4> all{};
  std::string_view rest = text;
  for (double& x : all) {
    rest.remove_prefix(std::min(rest.find_first_not_of(" ;"), rest.size()));
    const NumberAtFront number = number_at_front(rest);
    x = number.value;
    rest.remove_prefix(number.length);
  }
  return all;
}

std::vector<rope::LifeConstants> constants_of(const LifeRequest& life) {
  std::vector<rope::LifeConstants> all;
  for (const LifeConstantsRequest& own : life.constants) {
    if (own.a.size() != 4) continue;
    all.push_back({count_names[static_cast<int>(own.count)],
                   {own.a[0], own.a[1], own.a[2], own.a[3]},
                   "constants of the deck",
                   "user"});
  }
  if (!all.empty()) return all;
  for (const catalogue::RuleRow& row : catalogue::rules_of("life.feyrer")) {
    all.push_back({row.id.substr(row.id.rfind('.') + 1), numbers_of(row.text),
                   fmt::format("{}, of {} ({})", row.item, row.group, row.source), catalogue::trust_words(row)});
  }
  return all;
}

/// f_C of core and strands; of a core without a row the least.
void set_core_factor(const std::string& core, int strands, rope::LifeRules& rules) {
  const std::string ending = fmt::format(".{}", strands);
  std::optional<catalogue::RuleRow> least;
  for (const catalogue::RuleRow& row : catalogue::rules_of("life.core")) {
    if (!row.low || !row.id.ends_with(ending)) continue;
    if (!core.empty() && row.id == fmt::format("life.core.{}{}", core, ending)) {
      rules.core_factor = *row.low;
      rules.core_words = fmt::format("f_C of {} ({})", row.group, row.source);
      return;
    }
    if (!least || *row.low < *least->low) least = row;
  }
  if (!least) return;
  rules.core_factor = *least->low;
  rules.core_words = fmt::format("f_C of {} ({}), the least: {}", least->group, least->source,
                                 core.empty() ? "the core is not known" : fmt::format("there is none of {}", core));
}

rope::LifeRules rules_of(const RopeCheckRequest& request, const rope::RopeUse& use, const rope::RopeRules& rules) {
  const LifeRequest life = request.life.value_or(LifeRequest{});
  rope::LifeRules all;
  for (const DutyRequest& one : request.duty) all.duty.push_back({one.name, one.cycles, one.load, one.over});
  all.constants = constants_of(life);
  all.bent_length = life.bent_length;
  all.dynamic_factor = rules.dynamic_factor;
  const auto construction = catalogue::parse_construction(use.rope.construction);
  if (life.core_factor) {
    all.core_factor = *life.core_factor;
    all.core_words = "f_C of the deck";
  } else if (construction) {
    set_core_factor(use.rope.core, construction->strands, all);
  }
  const auto weight = catalogue::find_rule("life.reverse_weight");
  all.reverse_weight = life.reverse_weight.value_or(weight ? *weight->low : 1);
  return all;
}

/// A bend in a duty, by one count of cycles.
struct LifeRow {
  const rope::Life& life;
  const rope::LifeLine& line;
};

const Quantities<LifeRow>& life_quantities() {
  using Row = LifeRow;
  const auto of = [](auto rope::LifeLine::*part) { return [part](const Row& r) -> Cell { return r.line.*part; }; };
  static const Quantities<Row> all = {
      {"count", "", si::one, "which number of cycles N is: mean to break or to discard, or the one that 90 % reach",
       [](const Row& r) { return r.life.constants->count; }},
      {"duty", "", si::one, "name of the duty", of(&rope::LifeLine::duty)},
      {"bent_on", "", si::one, "sheave or drum that bends the rope", of(&rope::LifeLine::bend)},
      {"D_over_d", "D/d", si::one, "pitch diameter of the sheave or drum over rope diameter",
       of(&rope::LifeLine::ratio)},
      {"pull", "S", si::N, "rope tensile force there, with the dynamic factor", of(&rope::LifeLine::pull)},
      {"n", "n", si::one, "bending cycles in the wanted life; a drum counts half", of(&rope::LifeLine::cycles)},
      {"N", "N", si::one, "bending cycles that the rope endures there (Feyrer)", of(&rope::LifeLine::endures)},
      {"damage", "n/N", si::one, "share of the life that they use (Palmgren-Miner)", of(&rope::LifeLine::damage)}};
  return all;
}

void add_table(const std::vector<rope::Life>& lives, const rope::RopeUse& use, Result& r) {
  std::vector<LifeRow> rows;
  for (const rope::Life& life : lives) {
    for (const rope::LifeLine& line : life.lines) rows.push_back({.life = life, .line = line});
  }
  r.tables.push_back(
      make_table("life_" + use.name,
                 fmt::format("Life of {}: bendings n in the wanted life, endured N (Feyrer), damage n/N", use.name),
                 life_quantities(), rows));
}

/// Of constants, the weight of reverse bending, the dynamic factor and the rope itself.
std::vector<Doubt> doubts_of_life(const RopeCheckRequest& request, const rope::Life& life, const rope::RopeUse& use,
                                  const rope::RopeRules& rules) {
  std::vector<Doubt> doubts;
  rope::add_doubt(life.constants->trust, life.constants->words, doubts);
  const bool own_weight = request.life && request.life->reverse_weight;
  if (const auto row = catalogue::find_rule("life.reverse_weight"); life.reversed && !own_weight && row)
    rope::add_doubt(catalogue::trust_words(*row), fmt::format("{} ({})", row->item, row->source), doubts);
  rope::add_doubt(rules.dynamic_trust, rules.dynamic_words, doubts);
  rope::add_doubt_of_rope(use.rope, doubts);
  return doubts;
}

void add_life_check(const rope::Life& life, const rope::LifeRules& rules, std::vector<Doubt> doubts,
                    const rope::RopeUse& use, Result& r) {
  const std::string name = use.name + ".life";
  Check c =
      make_check(name, life.damage, si::one,
                 {.sense = Sense::at_most,
                  .limit = 1,
                  .rule = fmt::format("Palmgren-Miner, sum of n/N over all duties and rounds; N by Feyrer, {}: {}; {}",
                                      life.constants->count, life.constants->words, rules.core_words),
                  .trust = rope::trust_with(life.constants->trust, doubts),
                  .doubts = std::move(doubts)});
  c.part = use.name;
  r.checks.push_back(std::move(c));
  r.values.push_back(make_value(named(value_kinds(), "ROPE.life_damage"), use.name, "", life.damage,
                                fmt::format("damage of {} in the wanted life, {}", use.name, life.constants->count)));
  r.values.push_back(make_value(named(value_kinds(), "ROPE.life_repeats"), use.name, "", 1 / life.damage,
                                fmt::format("how often the duty of {} can run, {}", use.name, life.constants->count)));
}

void leave_out(const rope::RopeUse& use, const std::string& what, Result& r) {
  r.unmade.push_back(fmt::format("{}: {}", use.name, what));
  r.warnings.push_back(r.unmade.back());
}

/// The pull with which a round bends the rope hardest: that of the states, or that of a duty above it.
struct HardestBend {
  double pull = 0;  ///< N, with the dynamic factor
  std::string words;
};

HardestBend hardest_bend(const RopeCheckRequest& request, const rope::RopeUse& use, double dynamic_factor) {
  HardestBend hardest;
  const auto take = [&](const rope::Bend& bend, double load, const std::string& duty) {
    const double pull = dynamic_factor * load * bend.tension;
    if (pull <= hardest.pull) return;
    hardest = {
        .pull = pull,
        .words = fmt::format("{:.3g} x {} at '{}'{}", dynamic_factor * load, use.display.brief(bend.tension, si::N),
                             bend.name, duty.empty() ? "" : fmt::format(" in the duty '{}'", duty))};
  };
  for (const rope::Bend& bend : use.bends) {
    if (bend.kind == rope::BendKind::saddle) continue;
    take(bend, 1, "");
    for (const DutyRequest& duty : request.duty) {
      const auto& over = duty.over;
      const bool bends = over.empty() || std::find(over.begin(), over.end(), bend.name) != over.end();
      if (bends) take(bend, duty.load, duty.name);
    }
  }
  return hardest;
}

void check_donandt(const RopeCheckRequest& request, const rope::RopeUse& use, const rope::RopeRules& rules, Result& r) {
  const HardestBend hardest = hardest_bend(request, use, rules.dynamic_factor);
  const auto not_checked = [&](const std::string& why) {
    leave_out(use, "its Donandt force is not checked: " + why, r);
  };
  if (!use.unmeasured.empty())
    not_checked(fmt::format("no diameter is known of {}", fmt::join(use.unmeasured, ", ")));
  else if (!(hardest.pull > 0))
    not_checked("no sheave or drum bends it under tension");
  if (!(hardest.pull > 0)) return;
  std::vector<Doubt> doubts;
  if (rules.dynamic_factor != 1) rope::add_doubt(rules.dynamic_trust, rules.dynamic_words, doubts);
  Check c = make_check(
      use.name + ".donandt", hardest.pull, si::N,
      {.sense = Sense::at_most,
       .limit = *request.life->donandt_force,
       .rule = fmt::format("Donandt force: above it wires yield in bending and the life falls off; {}", hardest.words),
       .trust = rope::trust_with("user", doubts),
       .doubts = std::move(doubts)});
  c.part = use.name;
  r.checks.push_back(std::move(c));
}

}  // namespace

TableWords life_words() {
  return {.name = "life_ROPE",
          .rows = "every bend of a rope in every duty, for every count of cycles",
          .columns = words_of(life_quantities())};
}

namespace {

/// The Donandt force is a check of its own: all other data are of the life.
bool asks_for_life(const RopeCheckRequest& request) {
  if (!request.life) return false;
  const LifeRequest& life = *request.life;
  return !life.donandt_force || !life.constants.empty() || life.bent_length || life.core_factor || life.reverse_weight;
}

/// "'sad' of the duty 'lifts'": where the duties name rounds of the rope that do not bend it.
std::vector<std::string> not_bent_on(const rope::LifeRules& rules, const rope::RopeUse& use) {
  std::vector<std::string> all;
  for (const rope::Duty& duty : rules.duty) {
    for (const std::string& name : duty.over) {
      const auto is_here = [&](const rope::Bend& bend) { return bend.name == name; };
      const auto bends = [&](const rope::Bend& bend) { return is_here(bend) && counts(duty, bend); };
      const auto& rounds = use.bends;
      if (std::any_of(rounds.begin(), rounds.end(), is_here) && std::none_of(rounds.begin(), rounds.end(), bends))
        all.push_back(fmt::format("'{}' of the duty '{}'", name, duty.name));
    }
  }
  return all;
}

/// The table has ropes of 6 and of 8 strands alone.
std::string why_no_core_factor(const catalogue::RopeRow& rope) {
  const char* const give = "give 'life: core_factor' of the rope's maker";
  if (!catalogue::parse_construction(rope.construction)) {
    return fmt::format("the endurance factor f_C goes by the number of strands, and {}: give 'construction', or {}",
                       rope.construction.empty() ? "the construction is not known"
                                                 : fmt::format("of '{}' that is not known", rope.construction),
                       give);
  }
  return fmt::format(
      "Feyrer's table 3.14a has an endurance factor f_C of ropes with 6 or 8 strands, and none of {}: {}",
      rope.construction, give);
}

constexpr const char* unbent = "no sheave or drum of known diameter bends it under tension";

/// Of a rope that no duty bends.
std::string why_unbent(const rope::RopeUse& use) {
  const auto bent = std::find_if(use.bends.begin(), use.bends.end(), [](const auto& bend) { return counts({}, bend); });
  if (bent == use.bends.end()) return unbent;
  return fmt::format(
      "no duty runs over '{}', which bends it: name it in 'over', or check other reevings by their names", bent->name);
}

}  // namespace

void complain_of_life(const RopeCheckRequest& request, const catalogue::RopeRow& rope,
                      const std::vector<std::string>& rounds, const std::string& path,
                      std::vector<Complaint>& complaints) {
  if (request.life) {
    for (std::size_t i = 0; i < request.life->constants.size(); ++i) {
      if (request.life->constants[i].a.size() == 4) continue;
      complaints.push_back(
          {fmt::format("{}.life.constants[{}].a", path, i), "four constants are expected: a0, a1, a2, a3"});
    }
  }
  if (request.duty.empty()) {
    if (asks_for_life(request))
      complaints.push_back({path + ".life", "a life needs a 'duty': what bends the rope how often"});
    return;
  }
  const bool chosen_later = rope.id.empty();
  if (!chosen_later && (!(rope.diameter > 1.4e-3) || !rope.grade)) {
    complaints.push_back({path + ".duty", "a life needs the rope's 'diameter' (over 1.4 mm) and 'grade'"});
  }
  for (std::size_t i = 0; i < request.duty.size(); ++i) {
    for (const std::string& name : request.duty[i].over) {
      if (std::find(rounds.begin(), rounds.end(), name) != rounds.end()) continue;
      complaints.push_back(
          {fmt::format("{}.duty[{}].over", path, i),
           fmt::format("the rope runs over no '{}' with a diameter{}", name, did_you_mean(name, rounds))});
    }
  }
}

void add_life(const RopeCheckRequest& request, const rope::RopeUse& use, const rope::RopeRules& rules, Result& r) {
  if (request.life && request.life->donandt_force) check_donandt(request, use, rules, r);
  if (request.discard) add_discard(rules.group, use, r);
  if (request.duty.empty()) return;
  const auto not_computed = [&](const std::string& why) { leave_out(use, "its life is not computed: " + why, r); };
  if (!(use.rope.diameter > 1.4e-3) || !use.rope.grade)  // of a rope that a design has chosen
    return not_computed(fmt::format("the grade or the diameter of '{}' is not known", use.rope.id));
  const rope::LifeRules life_rules = rules_of(request, use, rules);
  if (life_rules.core_words.empty()) return not_computed(why_no_core_factor(use.rope));
  for (const std::string& round : not_bent_on(life_rules, use))
    leave_out(use, fmt::format("its life leaves out {}: {} there", round, unbent), r);
  const std::vector<rope::Life> lives = rope::life_of(use, life_rules);
  const auto worst =
      std::max_element(lives.begin(), lives.end(), [](const auto& a, const auto& b) { return a.damage < b.damage; });
  if (worst == lives.end() || worst->lines.empty()) return not_computed(why_unbent(use));
  const auto endless = std::find_if_not(lives.begin(), lives.end(), rope::is_finite);
  if (endless != lives.end()) {
    return not_computed(fmt::format("the constants of '{}' give no finite number of bendings ({})",
                                    endless->constants->count, endless->constants->words));
  }
  // a duty that names its rounds names known ones
  const bool over_all =
      std::any_of(request.duty.begin(), request.duty.end(), [](const auto& d) { return d.over.empty(); });
  if (over_all && !use.unmeasured.empty()) {
    leave_out(use,
              fmt::format("its life leaves out the bends over {}, of which no diameter is known",
                          fmt::join(use.unmeasured, ", ")),
              r);
  }
  add_life_check(*worst, life_rules, doubts_of_life(request, *worst, use, rules), use, r);
  add_table(lives, use, r);
}

}  // namespace taut::checks
