#include "taut/checks/rope/rope_rules.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <optional>

#include "taut/base/expects.hpp"
#include "taut/base/number.hpp"
#include "taut/base/suggest.hpp"
#include "taut/catalogue/construction.hpp"
#include "taut/catalogue/rope_words.hpp"
#include "taut/catalogue/rule.hpp"
#include "taut/catalogue/trust.hpp"
#include "taut/rope/strength.hpp"
#include "taut/units/any_quantity.hpp"

namespace taut::checks {
namespace {

using catalogue::RuleRow;
using rope::Limit;

constexpr double same_value = 1e-9;                         // of two that are given, relative
constexpr const char* not_for_lifting = "not for lifting";  // as the table of terminations says it

/// The highest temperature for which a row holds, K.
double hottest_of(const RuleRow& row) {
  expects(row.up_to.has_value(), "a rule of temperatures without its highest one");
  return *row.up_to;
}

/// "cable logging (CH), standing skyline: MBF / largest tension (SEILAPLAN)".
std::string words_of(const RuleRow& row) {
  std::string words = row.field.empty() ? row.item : fmt::format("{}, {}", row.field, row.item);
  if (!row.group.empty()) words += fmt::format(" {}", row.group);
  if (!row.text.empty()) words += fmt::format(": {}", row.text);
  return fmt::format("{} ({})", words, row.source);
}

/// The end of a range that is safe: the high one of what must be reached, the low one of what must not be passed.
enum class SafeEnd { low, high };
Limit limit_of(const RuleRow& row, SafeEnd end) {
  Limit limit{.value = end == SafeEnd::high ? *row.high : *row.low,
              .rule = words_of(row),
              .trust = catalogue::trust_words(row)};
  if (*row.low != *row.high) {
    const bool angle = row.unit == "rad";
    const double shown = angle ? std::numbers::pi / 180 : 1;
    limit.rule +=
        fmt::format("; of {:.4g} to {:.4g}{} the safe end", *row.low / shown, *row.high / shown, angle ? " deg" : "");
  }
  return limit;
}

std::optional<RuleRow> rule_named(const std::string& id) {
  const auto row = catalogue::find_rule(id);
  if (!row) return std::nullopt;
  return *row;
}

bool begins(const std::string& id, std::initializer_list<const char*> topics) {
  return std::any_of(topics.begin(), topics.end(), [&](const char* one) { return id.starts_with(one); });
}

/// Terminations of the tables, each once.
std::vector<std::string> terminations() {
  std::vector<std::string> known;
  for (const RuleRow& row : catalogue::rules_of("termination")) {
    const std::size_t begin = std::string_view("termination.").size();
    const std::size_t end = row.id.rfind('.');
    if (end <= begin || !row.low) continue;
    const std::string name = row.id.substr(begin, end - begin);
    if (std::find(known.begin(), known.end(), name) == known.end()) known.push_back(name);
  }
  return known;
}

/// Finds what a deck names, and the limits that hold for any rope.
class RequestReader {
 public:
  RequestReader(const RopeCheckRequest& request, std::string path, std::vector<Complaint>& complaints)
      : request_(request), path_(std::move(path)), complaints_(complaints) {}

  AskedRules read() {
    find_class();
    for (std::size_t i = 0; i < request_.field.size(); ++i) field(request_.field[i], fmt::format("field[{}]", i));
    if (request_.rope) {
      const auto row = catalogue::find_rope_in_words(*request_.rope);
      if (!row) complain("rope", catalogue::to_text(row.error()));
    }
    if (request_.core && !catalogue::parse_core(*request_.core)) {
      complain("core", fmt::format("there is no core '{}': FC of fibre, IWRC or WSC of steel", *request_.core));
    }
    own_factors();
    dynamics();
    termination();
    ratios();
    rules_.bending_modulus = request_.bending_modulus;
    drums();
    return std::move(asked_);
  }

 private:
  void complain(const std::string& key, std::string message) {
    complaints_.push_back({fmt::format("{}.{}", path_, key), std::move(message)});
  }

  void no_such_field(const std::string& name, const std::string& key) {
    std::vector<std::string> known;
    for (const RuleRow& row : catalogue::rules_of("safety")) {
      if (row.id == "strength.skyline_elastic_limit") continue;
      known.push_back(row.id.substr(std::string_view("safety.").size()));
    }
    complain(key, to_text(catalogue::LookupError{
                      .message = fmt::format("there is no field of use '{}'", name),
                      .candidates = catalogue::nearest_names(name, known, catalogue::suggested)}) +
                      "; taut list rules --name safety");
  }

  /// A use of ropes for which several countries have rules of their own.
  void no_field_alone(const std::string& name, const std::vector<RuleRow>& below, const std::string& key) {
    std::vector<std::string> known;
    known.reserve(below.size());
    for (const RuleRow& row : below) known.push_back(row.id.substr(std::string_view("safety.").size()));
    complain(key, fmt::format("'{}' has rules by country: give {}", name, fmt::join(known, " or ")));
  }

  /// One mistake, told once: fields and D/d go by the class.
  void no_such_class(const std::string& words) {
    if (!std::exchange(refused_class_, true)) complain("class", words + ": M1 to M8");
  }

  static std::string without_topic(const std::string& given) {
    return given.starts_with("safety.") ? given.substr(7) : given;
  }

  /// The class of the mechanism: that of the deck, or that of a field which names its own, 'crane_running.M5'. D/d,
  /// broken wires and all fields go by it.
  void find_class() {
    std::string& group = rules_.group;
    group = request_.group.value_or("");
    std::transform(group.begin(), group.end(), group.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    std::string from = "'class'";
    for (std::size_t i = 0; i < request_.field.size(); ++i) {
      const auto row = rule_named("safety." + without_topic(request_.field[i]));
      if (!row || row->group.empty()) continue;
      if (!group.empty() && group != row->group) {
        complain(fmt::format("field[{}]", i),
                 fmt::format("'{}' is of the class {}, and {} says {}: a rope has one class", request_.field[i],
                             row->group, from, group));
        continue;
      }
      group = row->group;
      from = fmt::format("'{}'", request_.field[i]);
    }
  }

  void field(const std::string& given, const std::string& key) {
    const std::string name = without_topic(given);
    std::string id = "safety." + name;
    if (name == "skyline_elastic_limit") {
      return complain(key, "is a share of the breaking force, not a safety factor: see 'elastic_limit'");
    }
    const std::vector<RuleRow> below = catalogue::rules_of(id);
    const bool by_class =
        std::any_of(below.begin(), below.end(), [](const RuleRow& one) { return !one.group.empty(); });
    if (!below.empty() && !by_class) return no_field_alone(name, below, key);
    if (by_class) {
      if (rules_.group.empty()) return complain(key, fmt::format("'{}' needs a 'class', M1 to M8", name));
      id += "." + rules_.group;
    }
    const auto row = rule_named(id);
    if (!row && by_class)
      return no_such_class(fmt::format("'{}' has no class '{}'", name, request_.group.value_or(rules_.group)));
    if (!row) return no_such_field(name, key);
    used_group_ |= !row->group.empty();
    asked_.fields.push_back(row->id);
    const bool crane = begins(row->id, {"safety.crane_"}), covers = crane || begins(row->id, {"safety.ropeway_"});
    const bool first = asked_.fields.size() == 1;
    all_cover_bending_ = covers && (all_cover_bending_ || first);
    all_cover_ends_ = crane && (all_cover_ends_ || first);
    if (row->id == "safety.crane_running.en13001") {
      rules_.resistance = Limit{.value = 0, .rule = words_of(*row), .trust = catalogue::trust_words(*row)};
    } else if (row->low) {
      rules_.safety_factors.push_back(limit_of(*row, SafeEnd::high));
      rules_.safety_factors.back().covers_bending = covers;
      rules_.safety_factors.back().covers_ends = crane;
    }
  }

  void own_factors() {
    if (request_.safety_factor) {
      rules_.safety_factors.push_back({.value = *request_.safety_factor,
                                       .rule = "safety factor of the deck",
                                       .trust = "user",
                                       .covers_bending = all_cover_bending_,
                                       .covers_ends = all_cover_ends_});
    }
    if (request_.sheave_weakening != Choose::by_field) {
      rules_.bending_asked = request_.sheave_weakening == Choose::yes;
      for (Limit& limit : rules_.safety_factors) {
        limit.covers_bending = !rules_.bending_asked;
        limit.covers_ends &= limit.covers_bending;
      }
    }
    if (request_.en13001 && !rules_.resistance) {
      if (const auto row = rule_named("safety.crane_running.en13001")) {
        rules_.resistance = Limit{.value = 0, .rule = words_of(*row), .trust = catalogue::trust_words(*row)};
      }
    }
    if (request_.en13001) fatigue(*request_.en13001);
  }

  void fatigue(const En13001Request& given) {
    if (given.bends) {
      rules_.fatigue_history = rope::force_history(given.spectrum.value_or(1), *given.bends);
      rules_.fatigue_factor = given.factor.value_or(1);
    } else if (given.spectrum || given.factor) {
      complain("en13001", "'spectrum' and 'factor' are of the fatigue proof, which needs 'bends'");
    }
  }

  void dynamics() {
    if (request_.dynamic_factor && request_.hoist) complain("hoist", "either 'dynamic_factor' or 'hoist'");
    rules_.dynamic_words = "no dynamic factor given";
    if (request_.dynamic_factor) {
      rules_.dynamic_factor = *request_.dynamic_factor;
      rules_.dynamic_words = "dynamic factor of the deck";
    }
    if (request_.hoist) hoist(*request_.hoist);
    if (request_.dynamic_safety_factor) {
      rules_.dynamic_safety =
          Limit{.value = *request_.dynamic_safety_factor, .rule = "dynamic safety factor of the deck", .trust = "user"};
    }
    elastic_limit();
  }

  /// The share of the tables is a rule of skylines. Any other rope may fail by it too, but none passes by it: a crane's
  /// hoist rope at 0.6 F_min has far less than its factor.
  void elastic_limit() {
    if (request_.elastic_limit) {
      rules_.elastic_share =
          Limit{.value = *request_.elastic_limit, .rule = "elastic limit of the deck", .trust = "user"};
      rules_.own_elastic_share = true;
    } else if (const auto row = rule_named("strength.skyline_elastic_limit")) {
      rules_.elastic_share = limit_of(*row, SafeEnd::low);
    }
  }

  void hoist(const HoistRequest& given) {
    const int number = static_cast<int>(given.hoisting_class) + 1;
    const auto least = rule_named(fmt::format("hoist.HC{}.phi2_min", number));
    const auto slope = rule_named(fmt::format("hoist.HC{}.beta2", number));
    if (!least || !slope) return;
    rules_.dynamic_factor = *least->low + *slope->low * given.speed;
    rules_.dynamic_trust = catalogue::trust_words(*least);
    rules_.dynamic_words = fmt::format("phi2 = {} + {} v_h, HC{}, v_h = {:.4g} m/s, {}, unverified", *least->low,
                                       *slope->low, number, given.speed, least->source);
  }

  /// An efficiency of the deck takes the place of the number alone: where a termination may be used, and how hot it may
  /// be, goes by its name.
  void termination() {
    if (request_.termination) named_termination(*request_.termination);
    if (request_.termination_efficiency) {
      rules_.termination = Limit{.value = *request_.termination_efficiency,
                                 .rule = request_.termination.value_or("the termination") + ", efficiency of the deck",
                                 .trust = "user"};
    }
  }

  void named_termination(const std::string& given) {
    const std::vector<std::string> known = terminations();
    const auto begins_so = [&](const std::string& one) { return one.starts_with(given); };
    auto found = std::find(known.begin(), known.end(), given);
    // "wedge" means the one whose name begins so
    if (found == known.end() && std::count_if(known.begin(), known.end(), begins_so) == 1) {
      found = std::find_if(known.begin(), known.end(), begins_so);
    }
    const bool has_number = request_.termination_efficiency.has_value();
    if (found != known.end()) {
      asked_.termination = *found;
    } else if (has_number && nearest(given, known).empty() && std::none_of(known.begin(), known.end(), begins_so)) {
      asked_.unknown_termination = given;
    } else {
      complain("termination",
               fmt::format("there is no termination '{}' in the tables: {}{}", given, catalogue::listed(known, 12),
                           has_number ? did_you_mean(given, known) : "; or give 'termination_efficiency'"));
    }
  }

  /// A class that no field of use needs is there for D/d.
  bool runs() const {
    if (request_.running != Choose::by_field) return request_.running == Choose::yes;
    const auto& ids = asked_.fields;
    return ids.empty() || (!rules_.group.empty() && !used_group_) ||
           std::any_of(ids.begin(), ids.end(), [](const std::string& id) {
             return !begins(id, {"safety.skyline", "safety.guyline", "safety.crane_stay", "safety.ropeway_track",
                                 "safety.cableway"});
           });
  }

  void ratios() {
    const bool said_to_run = request_.running == Choose::yes;
    rules_.ratio_asked = !request_.diameter_ratio.empty() || said_to_run || (!rules_.group.empty() && runs());
    rules_.no_saddles = said_to_run;
    if (!request_.diameter_ratio.empty()) {
      if (request_.diameter_ratio.size() > 2) complain("diameter_ratio", "one number, or two: of sheaves and of drums");
      const Limit sheave{.value = request_.diameter_ratio.front(), .rule = "D/d of the deck", .trust = "user"};
      rules_.sheave_ratios = {sheave};
      rules_.compensating_ratios = {sheave};
      rules_.drum_ratios = {{.value = request_.diameter_ratio.back(), .rule = "D/d of the deck", .trust = "user"}};
      return;
    }
    rules_.runs = runs();
    if (!runs()) return;
    if (!rules_.group.empty()) {
      ladder("crane_sheave", rules_.sheave_ratios);
      ladder("crane_compensating_sheave", rules_.compensating_ratios);
      ladder("crane_drum", rules_.drum_ratios);
    }
  }

  void ladder(const char* which, std::vector<Limit>& limits) {
    const auto row = rule_named(fmt::format("ratio.{}.{}", which, rules_.group));
    if (row) {
      limits.push_back(limit_of(*row, SafeEnd::high));
    } else if (limits.empty() && std::string_view(which) == "crane_sheave") {
      no_such_class(fmt::format("there is no class '{}'", request_.group.value_or(rules_.group)));
    }
  }

  void drums() {
    rules_.rated_pull = request_.rated_pull;
    const bool grooved = request_.drum == DrumFace::grooved;
    if (request_.fleet_angle) {
      rules_.fleet_angle = Limit{.value = *request_.fleet_angle, .rule = "fleet angle of the deck", .trust = "user"};
    } else if (request_.drum != DrumFace::unsaid) {
      const auto row = rule_named(grooved ? "layout.fleet_angle_grooved" : "layout.fleet_angle_smooth");
      if (row) rules_.fleet_angle = limit_of(*row, SafeEnd::low);
    }
    if (const auto row = rule_named("groove.drum_layers"); row && grooved) {
      rules_.layers = limit_of(*row, SafeEnd::low);
    }
  }

  const RopeCheckRequest& request_;
  std::string path_;
  std::vector<Complaint>& complaints_;
  bool used_group_ = false, refused_class_ = false;
  bool all_cover_bending_ = false, all_cover_ends_ = false;  ///< of the fields; false without any
  AskedRules asked_;
  rope::RopeRules& rules_ = asked_.of_any_rope;
};

/// The limits of one rope.
class RopeLimits {
 public:
  RopeLimits(const RopeCheckRequest& request, const AskedRules& asked, const catalogue::RopeRow& rope,
             std::optional<double> around)
      : request_(request), asked_(asked), rope_(rope), around_(around), rules_(asked.of_any_rope) {}

  rope::RopeRules read() {
    termination();
    temperature();
    ratios();
    grooves_and_wires();
    return std::move(rules_);
  }

 private:
  bool fibre() const { return rope_.core == "FC"; }

  void termination() {
    const auto row = row_of_end();
    const bool in_range =
        row && (!row->up_to || (rope_.diameter > 0 && rope_.diameter <= *row->up_to * (1 + same_value)));
    if (in_range && !rules_.termination) rules_.termination = limit_of(*row, SafeEnd::low);
    const auto& ids = asked_.fields;
    const bool crane =
        std::any_of(ids.begin(), ids.end(), [](const auto& id) { return begins(id, {"safety.crane_"}); });
    rules_.no_saddles |= crane && rules_.runs;
    if (crane && row && row->text.find(not_for_lifting) != std::string::npos) {
      rules_.termination_refused = words_of(*row);
    }
    const auto& factors = rules_.safety_factors;
    const bool covered = factors.empty() ||  // EN 13001 has no factor with a number
                         std::any_of(factors.begin(), factors.end(), [](const Limit& f) { return f.covers_ends; });
    if (!rules_.termination || !covered) return;
    if (const auto least = rule_named("termination.least_crane"); least && crane) {
      rules_.least_termination = limit_of(*least, SafeEnd::high);
    }
  }

  /// Of the termination that is named, for this rope. Nothing: none is, or none of its tables is for the core.
  std::optional<RuleRow> row_of_end() const {
    std::optional<RuleRow> worst;
    if (asked_.termination.empty()) return worst;
    for (const char* core : {"IWRC", "FC"}) {
      // of a rope whose core nobody knows the weaker one
      if (!rope_.core.empty() && fibre() != (std::string_view(core) == "FC")) continue;
      const auto row = rule_named(fmt::format("termination.{}.{}", asked_.termination, core));
      if (row && row->low && (!worst || *row->low < *worst->low)) worst = row;
    }
    return worst;
  }

  void temperature() {
    rules_.temperature = request_.temperature;
    if (!rules_.temperature && around_ && weakens(*around_)) rules_.temperature = around_;
    if (!rules_.temperature) return;
    for (const RuleRow& row : catalogue::rules_of("temperature.end")) {
      if (row.group != asked_.termination) continue;
      rules_.hottest_end = Limit{.value = hottest_of(row), .rule = words_of(row), .trust = catalogue::trust_words(row)};
    }
    const char* const core = fibre() || rope_.core.empty() ? "FC" : "steel";
    for (const RuleRow& row : catalogue::rules_of(fmt::format("temperature.{}", core))) {
      const double upto = hottest_of(row);
      rules_.hottest = Limit{.value = upto, .rule = words_of(row), .trust = catalogue::trust_words(row)};
      if (rope_.core.empty()) rules_.hottest->rule += "; the core is not known, a fibre core assumed";
      if (*rules_.temperature <= upto && !rules_.heat_strength) rules_.heat_strength = limit_of(row, SafeEnd::low);
    }
    if (rules_.hottest && !rules_.heat_strength) {
      rules_.no_strength = fmt::format("no strength is known of a rope at {:.4g} degC: the tables end at {:.4g} degC",
                                       *rules_.temperature - zero_celsius, rules_.hottest->value - zero_celsius);
    }
  }

  void ratios() {
    if (!rules_.runs) return;
    for (const RuleRow& row : catalogue::rules_of("ratio.maker")) {
      if (!is_for_rope(row.group)) continue;
      rules_.sheave_ratios.push_back(limit_of(row, SafeEnd::high));
      rules_.drum_ratios.push_back(limit_of(row, SafeEnd::high));
    }
  }

  /// "6x36WS IWRC", "18x7 / 19x7": constructions that a maker's advice names.
  bool is_for_rope(const std::string& group) const {
    std::size_t at = 0;
    while (at < group.size()) {
      const std::size_t end = std::min(group.find('/', at), group.size());
      std::string one = group.substr(at, end - at);
      at = end + 1;
      one.erase(0, one.find_first_not_of(' '));
      const std::size_t space = one.find(' ');
      const std::string core = space == std::string::npos ? "" : one.substr(space + 1);
      const bool core_fits = core.empty() || rope_.core.empty() || core == rope_.core;
      const std::string asked = one.substr(0, space);
      // a name without numbers ("compacted") says too little of the strands
      if (catalogue::parse_construction(asked) && core_fits && !rope_.construction.empty() &&
          catalogue::matches_construction(asked, rope_.construction)) {
        return true;
      }
    }
    return false;
  }

  void grooves_and_wires() {
    static constexpr const char* names[] = {"", "wood", "cast_iron", "cast_steel", "chilled_iron", "manganese_steel"};
    const std::string group = catalogue::construction_class(rope_.construction);
    if (request_.groove_pressure) {
      rules_.groove_pressure =
          Limit{.value = *request_.groove_pressure, .rule = "groove pressure of the deck", .trust = "user"};
    } else if (request_.groove != Groove::none) {
      const auto row = rule_named(fmt::format("pressure.{}.{}", names[static_cast<int>(request_.groove)], group));
      if (row) rules_.groove_pressure = limit_of(*row, SafeEnd::low);
    }
    if (request_.wire_diameter && rope_.diameter > 0) {
      rules_.wire = Limit{.value = *request_.wire_diameter / rope_.diameter, .rule = "of the deck", .trust = "user"};
    } else if (const auto row = rule_named("wire." + group); row && !group.empty()) {
      rules_.wire = limit_of(*row, SafeEnd::high);
      rules_.wire->rule = fmt::format("{:.3g} d for class {}", rules_.wire->value, group);
    }
  }

  const RopeCheckRequest& request_;
  const AskedRules& asked_;
  const catalogue::RopeRow& rope_;
  std::optional<double> around_;
  rope::RopeRules rules_;
};

}  // namespace

bool weakens(double temperature) {
  static const double harmless = hottest_of(catalogue::rules_of("temperature.FC").front());
  return temperature > harmless;
}

AskedRules asked_rules(const RopeCheckRequest& request, const std::string& path, std::vector<Complaint>& complaints) {
  return RequestReader(request, path, complaints).read();
}

rope::RopeRules rope_rules(const RopeCheckRequest& request, const AskedRules& asked, const catalogue::RopeRow& rope,
                           std::optional<double> around) {
  return RopeLimits(request, asked, rope, around).read();
}

namespace {

/// Why the tables have no row for the end of a rope: "a rope of 32 mm: up to 25.4 mm", "a fibre core".
std::string rope_of_end(const std::string& termination, const catalogue::RopeRow& rope, const Display& display) {
  const auto row = rule_named(fmt::format("termination.{}.{}", termination, rope.core == "FC" ? "FC" : "IWRC"));
  if (!row) return "a fibre core";
  if (!row->up_to) return "such a rope";
  const auto diameter = [&](double d) { return display.brief(d, si::m.in("mm")); };
  const std::string up_to = "they hold up to " + diameter(*row->up_to);
  return rope.diameter > 0 ? fmt::format("a rope of {} ({})", diameter(rope.diameter), up_to)
                           : fmt::format("a rope whose diameter is not known ({})", up_to);
}

}  // namespace

std::vector<MissingLimit> missing_limits(const RopeCheckRequest& request, const AskedRules& asked,
                                         const catalogue::RopeRow& rope, const rope::RopeRules& rules,
                                         const Display& display) {
  std::vector<MissingLimit> missing;
  if (!asked.termination.empty() && !rules.termination) {
    missing.push_back({.key = "termination",
                       .words = fmt::format("the tables have no efficiency of '{}' for {}; give "
                                            "'termination_efficiency'",
                                            asked.termination, rope_of_end(asked.termination, rope, display))});
  }
  if (request.wire_diameter && !(rope.grade && rope.area > 0 && rope.diameter > 0)) {
    missing.push_back(
        {.key = "wire_diameter", .words = "the stress of the wires needs the rope's 'diameter', 'area' and 'grade'"});
  }
  if (request.groove != Groove::none && !rules.groove_pressure) {
    missing.push_back(
        {.key = "groove",
         .words = fmt::format("the tables have no groove pressure for {}; give 'groove_pressure'",
                              rope.construction.empty() ? "a rope whose 'construction' is not known"
                                                        : "the construction '" + rope.construction + "'")});
  }
  return missing;
}

void complain_of_limits(const RopeCheckRequest& request, const AskedRules& asked, const catalogue::RopeRow& rope,
                        const std::string& path, std::vector<Complaint>& complaints) {
  if (rope.id.empty() && rope.diameter == 0 && rope.breaking_force == 0) return;  // chosen later
  for (const MissingLimit& one : missing_limits(request, asked, rope, rope_rules(request, asked, rope))) {
    complaints.push_back({fmt::format("{}.{}", path, one.key), one.words});
  }
}

}  // namespace taut::checks
