#include "taut/design/design_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "taut/calc/none.hpp"
#include "taut/design/design_checks.hpp"

namespace taut::design {
namespace {

using catalogue::RopeRow;
using design::SizingCandidate;

constexpr double nearly_active = 0.9;  // utilisation of checks that are reported as active

Unit cost_unit(Seek seek) {
  switch (seek) {
    case Seek::lightest:
      return si::kg;
    case Seek::smallest:
      return si::m.in("mm");
    case Seek::least_tension:
      return si::N;
    case Seek::cheapest:
    case Seek::most_reserve:
      return si::one;
  }
  return si::one;
}

/// What the value design_cost is.
std::string cost_words(const DesignRequest& request) {
  switch (request.seek) {
    case Seek::lightest:
      return "mass: ropes by their given lengths, else straight ones, beams and masts, weights of take-ups";
    case Seek::smallest:
      return "sum of the diameters and outer heights chosen";
    case Seek::cheapest:
      return "price of what is free, ropes by their given lengths, else straight ones";
    case Seek::least_tension:
      return request.of ? fmt::format("largest tension of {}", *request.of)
                        : std::string("largest tension of all ropes");
    case Seek::most_reserve:
      return "utilisation of the check that governs";
  }
  return {};
}

/// A rope that was free, and the one chosen for it.
struct ChosenRope {
  const RopeCandidates& of;
  const RopeRow& rope;
  double modulus = 0;  ///< Pa
};

const Quantities<ChosenRope>& chosen_ropes() {
  using Row = ChosenRope;
  static const Quantities<Row> all = {
      {"rope", "", si::one, "the rope", [](const Row& r) { return r.of.name; }},
      {"designation", "", si::one, "the rope of the catalogue that is chosen, by its id",
       [](const Row& r) { return r.rope.id; }},
      {"diameter", "d", si::m.in("mm"), "its nominal diameter", [](const Row& r) { return r.rope.diameter; }},
      {"area", "A", si::m2, "its metallic cross-sectional area", [](const Row& r) { return r.rope.area; }},
      {"mass_per_metre", "m", si::kg_per_m, "its mass per metre", [](const Row& r) { return r.rope.mass_per_length; }},
      {"grade", "R_0", si::Pa, "its rope grade: nominal tensile strength of the wires",
       [](const Row& r) { return r.rope.grade.value_or(none); }},
      {"breaking_force", "F_min", si::N, "its minimum breaking force",
       [](const Row& r) { return r.rope.breaking_force; }},
      {"stiffness", "EA", si::N, "modulus on the metallic area times that area",
       [](const Row& r) { return r.modulus * r.rope.area; }},
      {"trust", "", si::one, "trust in its row of the catalogue",
       [](const Row& r) { return std::string(catalogue::to_text(r.rope.trust)); }}};
  return all;
}

Table chosen_table(const DesignSpace& space, const SizingCandidate& best) {
  std::vector<ChosenRope> rows;
  rows.reserve(space.ropes.size());
  for (std::size_t k = 0; k < space.ropes.size(); ++k) {
    const RopeCandidates& of = space.ropes[k];
    rows.push_back({.of = of, .rope = of.rows[best.choice[k]], .modulus = of.moduli[best.choice[k]]});
  }
  return make_table("design", "The ropes chosen", chosen_ropes(), rows);
}

/// A beam or mast whose section was free, and the one chosen for it.
struct ChosenSection {
  const SectionCandidates& of;
  const catalogue::SectionRow& section;
};

const Quantities<ChosenSection>& chosen_sections() {
  using Row = ChosenSection;
  static const Quantities<Row> all = {{"beam", "", si::one, "the beam or mast", [](const Row& r) { return r.of.name; }},
                                      {"section", "", si::one, "the section of the catalogue that is chosen",
                                       [](const Row& r) { return r.section.name; }},
                                      {"mass_per_metre", "m", si::kg_per_m, "its mass per metre",
                                       [](const Row& r) { return r.section.mass_per_length; }},
                                      {"trust", "", si::one, "trust in its row of the catalogue",
                                       [](const Row& r) { return std::string(catalogue::to_text(r.section.trust)); }}};
  return all;
}

Table section_table(const DesignSpace& space, const SizingCandidate& best) {
  std::vector<ChosenSection> rows;
  rows.reserve(space.sections.size());
  for (std::size_t k = 0; k < space.sections.size(); ++k) {
    rows.push_back({.of = space.sections[k], .section = space.sections[k].rows[best.choice[space.ropes.size() + k]]});
  }
  return make_table("design_sections", "The sections chosen", chosen_sections(), rows);
}

const Quantities<Check>& active_quantities() {
  static const Quantities<Check> all = {
      {"part", "", si::one, "part of the machine that the check belongs to", &Check::part},
      {"check", "", si::one, "the check", &Check::name},
      {"utilisation", "", si::one, "its utilisation: the largest of all, and those above 0.9", &Check::utilisation},
      {"rule", "", si::one, "the rule and its source", &Check::rule},
      {"trust", "", si::one, "trust in its limit", &Check::trust}};
  return all;
}

Table active_checks(const Result& r) {
  std::vector<Check> all = r.checks;
  std::stable_sort(all.begin(), all.end(),
                   [](const Check& a, const Check& b) { return a.utilisation > b.utilisation; });
  const auto idle = std::find_if(all.begin() + (all.empty() ? 0 : 1), all.end(),
                                 [](const Check& c) { return c.utilisation < nearly_active; });
  all.erase(idle, all.end());
  return make_table("design_active", "Checks near their limits: what holds the design", active_quantities(), all);
}

/// A choice near the one that is chosen.
struct RunnerUp {
  std::string choice;
  double cost = 0;
  std::string outcome;
  const SizingTrial& trial;
};

/// `cost`: the unit of what is sought.
Quantities<RunnerUp> runner_up_quantities(const Unit& cost) {
  using Row = RunnerUp;
  return {
      {"choice", "", si::one, "rope or section chosen for each that is free", &Row::choice},
      {"cost", "", cost,
       "what is sought: kg of lightest, m of smallest, N of least_tension, a price, or the utilisation", &Row::cost},
      {"outcome", "", si::one, "fails, chosen, or passes", &Row::outcome},
      {"governs", "", si::one, "the check that governs", [](const Row& r) { return r.trial.governs; }},
      {"utilisation", "", si::one, "its utilisation", [](const Row& r) { return r.trial.utilisation; }}};
}

/// Values of the unknowns, and the least choice there.
struct TradeOff {
  const DesignSpace& space;
  const DesignPoint& point;
  bool found() const { return point.answer.outcome.ok(); }
  /// Where none passes: the one that fails by least, if any was tried.
  const SizingTrial* trial() const {
    const SizingAnswer& answer = point.answer;
    if (found()) return &answer.best.trial;
    return answer.below.empty() ? nullptr : &answer.below.back().trial;
  }
  std::string choice() const {
    const SizingAnswer& answer = point.answer;
    if (!found()) return answer.outcome.message + (answer.aside.empty() ? "" : " of those tried");
    const std::string words = names_of(space, answer.best.choice);
    return words.empty() ? "passes" : words;
  }
};

/// The unknown of that index, by its name and in its unit.
Quantity<TradeOff> unknown_quantity(std::size_t index, const std::string& name, const Unit& unit) {
  return {name, "", unit, "value of that unknown, in its own unit",
          [index](const TradeOff& r) { return r.point.values[index]; }};
}

/// Behind the unknowns. `cost`: the unit of what is sought.
Quantities<TradeOff> trade_off_quantities(const Unit& cost) {
  using Row = TradeOff;
  return {{"cost", "", cost, "what is sought by the least choice that passes there; empty: none passes",
           [](const Row& r) { return r.found() ? r.point.answer.best.cost : none; }},
          {"governs", "", si::one, "the check that governs it",
           [](const Row& r) { return r.trial() != nullptr ? r.trial()->governs : std::string(); }},
          {"utilisation", "", si::one, "its utilisation",
           [](const Row& r) { return r.trial() != nullptr ? r.trial()->utilisation : none; }},
          {"choice", "", si::one, "that choice, or why there is none", &Row::choice}};
}

/// The cost over the one unknown; where it is the same everywhere, the utilisation.
Plot trade_off_plot(const DesignTask& task, const DesignFound& found) {
  const UnknownValues& unknown = task.space.unknowns.front();
  const auto passing = [](const DesignPoint& p) { return p.answer.outcome.ok(); };
  const auto first = std::find_if(found.points.begin(), found.points.end(), passing);
  const bool flat = std::all_of(first, found.points.end(), [&](const DesignPoint& p) {
    return !passing(p) || p.answer.best.cost == first->answer.best.cost;
  });
  Plot p;
  p.name = "design_trade_off";
  p.title = (flat ? "Utilisation of the check that governs over " : "The least cost over ") + unknown.name;
  p.x = {.label = unknown.name, .unit = unknown.unit};
  p.y = flat ? Axis{.label = "utilisation", .unit = si::one}
             : Axis{.label = "cost", .unit = cost_unit(task.request.seek)};
  const auto height = [&](const SizingCandidate& c) { return flat ? c.trial.utilisation : c.cost; };
  Curve least;
  least.label = "least that passes, of the grid";
  std::vector<std::pair<double, double>> places;
  for (const DesignPoint& point : found.points) {
    if (passing(point)) places.emplace_back(point.values.front(), height(point.answer.best));
  }
  std::sort(places.begin(), places.end());
  for (const auto& [x, y] : places) {
    least.x.push_back(x);
    least.y.push_back(y);
  }
  if (least.x.size() < 2) return p;
  p.curves.push_back(std::move(least));
  p.marks.push_back({found.best.values.front(), height(found.best.answer.best), "design"});
  return p;
}

}  // namespace

std::string names_of(const DesignSpace& space, const std::vector<std::size_t>& choice) {
  std::string all;
  for (std::size_t k = 0; k < choice.size(); ++k) {
    const std::size_t beam = k - space.ropes.size();
    const bool rope = k < space.ropes.size();
    all += fmt::format("{}{}: {}", k == 0 ? "" : "; ", rope ? space.ropes[k].name : space.sections[beam].name,
                       rope ? space.ropes[k].rows[choice[k]].id : space.sections[beam].rows[choice[k]].name);
  }
  return all;
}

void add_runner_ups(const DesignTask& task, const design::SizingAnswer& answer, const SizingCandidate& chosen,
                    Result& r) {
  const DesignSpace& space = task.space;
  if (space.ropes.empty() && space.sections.empty()) return;
  std::vector<RunnerUp> rows;
  const auto add = [&](const SizingCandidate& c, const char* outcome) {
    rows.push_back({.choice = names_of(space, c.choice), .cost = c.cost, .outcome = outcome, .trial = c.trial});
  };
  for (const SizingCandidate& c : answer.below) {
    if (c.choice != chosen.choice) add(c, "fails");
  }
  if (!chosen.choice.empty()) add(chosen, "chosen");
  for (const SizingCandidate& c : answer.above) {
    if (c.choice != chosen.choice) add(c, "passes");
  }
  r.tables.push_back(make_table("design_runner_ups", "The choice between its neighbours, and what governs each",
                                runner_up_quantities(cost_unit(task.request.seek)), rows));
}

void add_trade_off(const DesignTask& task, const std::vector<DesignPoint>& points, Result& r) {
  Quantities<TradeOff> columns;
  for (const UnknownValues& one : task.space.unknowns) {
    columns.push_back(unknown_quantity(columns.size(), one.name, one.unit));
  }
  columns = joined(columns, trade_off_quantities(cost_unit(task.request.seek)));
  std::vector<TradeOff> rows;
  rows.reserve(points.size());
  for (const DesignPoint& point : points) rows.push_back({.space = task.space, .point = point});
  r.tables.push_back(
      make_table("design_trade_off", "The least choice over what is free besides, and what holds it", columns, rows));
}

void add_design(const DesignTask& task, const DesignFound& found, Result& r) {
  const DesignSpace& space = task.space;
  const SizingCandidate& best = found.best.answer.best;
  const Seek seek = task.request.seek;
  std::vector<Value> values;
  values.push_back(make_value(named(value_kinds(), "design_cost"), "", "", best.cost, cost_words(task.request)));
  values.back().unit = cost_unit(seek);
  for (std::size_t k = 0; k < found.best.values.size(); ++k) {
    const UnknownValues& one = space.unknowns[k];
    values.push_back(make_value(named(value_kinds(), "design_UNKNOWN"), one.name, "", found.best.values[k],
                                fmt::format("{} chosen", one.parameter)));
    values.back().unit = one.unit;
  }
  const ValueKind& trials = named(value_kinds(), "design_trials");
  values.push_back(make_value(trials, "", "", found.trials, trials.about.words));
  r.values.insert(r.values.begin(), std::make_move_iterator(values.begin()), std::make_move_iterator(values.end()));
  Result own;
  if (!space.ropes.empty()) own.tables.push_back(chosen_table(space, best));
  if (!space.sections.empty()) own.tables.push_back(section_table(space, best));
  Result binding;
  binding.checks = r.checks;
  disregard(task.request.disregard, binding);
  own.tables.push_back(active_checks(binding));
  add_runner_ups(task, found.best.answer, best, own);
  if (found.points.size() > 1) add_trade_off(task, found.points, own);
  r.tables.insert(r.tables.begin(), std::make_move_iterator(own.tables.begin()),
                  std::make_move_iterator(own.tables.end()));
  if (space.unknowns.size() != 1) return;
  Plot plot = trade_off_plot(task, found);
  if (!plot.curves.empty()) r.figures.emplace_back(std::move(plot));
}

const std::vector<ValueKind>& value_kinds() {
  static const std::vector<ValueKind> all = kinds_of(
      {{.name = "design_cost",
        .symbol = "cost",
        .unit = si::one,
        .words = "what is sought, of the design found: mass, price, sum of sizes, tension or utilisation, by `seek`"},
       {.name = "design_UNKNOWN",
        .symbol = "UNKNOWN",
        .unit = si::one,
        .words = "an unknown of the design, as found, in its own unit"},
       {.name = "design_trials",
        .symbol = "trials",
        .unit = si::one,
        .words = "calculations that the search took",
        .detail = true}},
      "`design:`", "guide/design.md");
  return all;
}

std::vector<TableWords> table_words() {
  Quantities<TradeOff> trade_off = {unknown_quantity(0, "UNKNOWN", si::one)};
  trade_off = joined(trade_off, trade_off_quantities(si::one));
  return {{.name = "design", .rows = "every rope that was free", .columns = words_of(chosen_ropes())},
          {.name = "design_sections", .rows = "every section that was free", .columns = words_of(chosen_sections())},
          {.name = "design_active",
           .rows = "every check near its limit, the nearest first",
           .columns = words_of(active_quantities())},
          {.name = "design_runner_ups",
           .rows = "cheaper choices, which fail, the one chosen, and the next that pass",
           .columns = words_of(runner_up_quantities(si::one))},
          {.name = "design_trade_off", .rows = "every place of the grid of unknowns", .columns = words_of(trade_off)}};
}

}  // namespace taut::design
