#include "taut/design/design_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

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
      return "mass: ropes by their straight lengths, beams and masts, weights of take-ups";
    case Seek::smallest:
      return "sum of the diameters and outer heights chosen";
    case Seek::cheapest:
      return "price of what is free, ropes by their straight lengths";
    case Seek::least_tension:
      return request.of ? fmt::format("largest tension of {}", *request.of)
                        : std::string("largest tension of all ropes");
    case Seek::most_reserve:
      return "utilisation of the check that governs";
  }
  return {};
}

Table chosen_table(const DesignSpace& space, const SizingCandidate& best) {
  Table t{.name = "design", .title = "The ropes chosen", .columns = {}, .rows = {}};
  t.columns = {{.name = "rope", .unit = si::one},
               {.name = "designation", .unit = si::one},
               {.name = "diameter", .unit = si::m.in("mm")},
               {.name = "area", .unit = si::m2},
               {.name = "mass_per_metre", .unit = si::kg_per_m},
               {.name = "grade", .unit = si::Pa},
               {.name = "breaking_force", .unit = si::N},
               {.name = "stiffness", .unit = si::N},
               {.name = "trust", .unit = si::one}};
  for (std::size_t k = 0; k < space.ropes.size(); ++k) {
    const RopeRow& row = space.ropes[k].rows[best.choice[k]];
    t.rows.push_back({space.ropes[k].name, row.id, row.diameter, row.area, row.mass_per_length,
                      row.grade.value_or(std::nan("")), row.breaking_force, space.ropes[k].modulus * row.area,
                      std::string(catalogue::to_text(row.trust))});
  }
  return t;
}

Table section_table(const DesignSpace& space, const SizingCandidate& best) {
  Table t{.name = "design_sections", .title = "The sections chosen", .columns = {}, .rows = {}};
  t.columns = {{.name = "beam", .unit = si::one},
               {.name = "section", .unit = si::one},
               {.name = "mass_per_metre", .unit = si::kg_per_m},
               {.name = "trust", .unit = si::one}};
  for (std::size_t k = 0; k < space.sections.size(); ++k) {
    const catalogue::SectionRow& row = space.sections[k].rows[best.choice[space.ropes.size() + k]];
    t.rows.push_back(
        {space.sections[k].name, row.name, row.mass_per_length, std::string(catalogue::to_text(row.trust))});
  }
  return t;
}

Table active_checks(const Result& r) {
  Table t{
      .name = "design_active", .title = "Checks near their limits: what holds the design", .columns = {}, .rows = {}};
  t.columns = {{.name = "part", .unit = si::one},
               {.name = "check", .unit = si::one},
               {.name = "utilisation", .unit = si::one},
               {.name = "rule", .unit = si::one},
               {.name = "trust", .unit = si::one}};
  std::vector<Check> all = r.checks;
  std::stable_sort(all.begin(), all.end(),
                   [](const Check& a, const Check& b) { return a.utilisation > b.utilisation; });
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i > 0 && all[i].utilisation < nearly_active) break;
    t.rows.push_back({all[i].part, all[i].name, all[i].utilisation, all[i].rule, all[i].trust});
  }
  return t;
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
  Table t{.name = "design_runner_ups",
          .title = "The choice between its neighbours, and what governs each",
          .columns = {},
          .rows = {}};
  t.columns = {{.name = "choice", .unit = si::one},
               {.name = "cost", .unit = cost_unit(task.request.seek)},
               {.name = "outcome", .unit = si::one},
               {.name = "governs", .unit = si::one},
               {.name = "utilisation", .unit = si::one}};
  const auto add = [&](const SizingCandidate& c, const char* outcome) {
    t.rows.push_back({names_of(space, c.choice), c.cost, std::string(outcome), c.trial.governs, c.trial.utilisation});
  };
  for (const SizingCandidate& c : answer.below) {
    if (c.choice != chosen.choice) add(c, "fails");
  }
  if (!chosen.choice.empty()) add(chosen, "chosen");
  for (const SizingCandidate& c : answer.above) {
    if (c.choice != chosen.choice) add(c, "passes");
  }
  r.tables.push_back(std::move(t));
}

void add_trade_off(const DesignTask& task, const std::vector<DesignPoint>& points, Result& r) {
  const DesignSpace& space = task.space;
  Table t{.name = "design_trade_off",
          .title = "The least choice over what is free besides, and what holds it",
          .columns = {},
          .rows = {}};
  for (const UnknownValues& one : space.unknowns) t.columns.push_back({one.name, one.unit});
  const std::vector<Column> rest = {{.name = "cost", .unit = cost_unit(task.request.seek)},
                                    {.name = "governs", .unit = si::one},
                                    {.name = "utilisation", .unit = si::one},
                                    {.name = "choice", .unit = si::one}};
  t.columns.insert(t.columns.end(), rest.begin(), rest.end());
  for (const DesignPoint& point : points) {
    std::vector<Cell> row(point.values.begin(), point.values.end());
    const auto& answer = point.answer;
    const bool found = answer.outcome.ok();
    const bool failed = !found && !answer.below.empty();
    const design::SizingTrial last =
        found    ? answer.best.trial
        : failed ? answer.below.back().trial
                 : design::SizingTrial{.passes = false, .utilisation = std::nan(""), .governs = {}};
    std::string words = found ? names_of(space, answer.best.choice) : answer.outcome.message;
    if (words.empty()) words = "passes";
    row.insert(row.end(), {found ? answer.best.cost : std::nan(""), last.governs, last.utilisation, std::move(words)});
    t.rows.push_back(std::move(row));
  }
  r.tables.push_back(std::move(t));
}

void add_design(const DesignTask& task, const DesignFound& found, Result& r) {
  const DesignSpace& space = task.space;
  const SizingCandidate& best = found.best.answer.best;
  const Seek seek = task.request.seek;
  std::vector<Value> values;
  values.push_back({"design_cost", best.cost, cost_unit(seek), "cost", cost_words(task.request), {}});
  for (std::size_t k = 0; k < found.best.values.size(); ++k) {
    const UnknownValues& one = space.unknowns[k];
    values.push_back(
        {"design_" + one.name, found.best.values[k], one.unit, one.name, fmt::format("{} chosen", one.parameter), {}});
  }
  values.push_back({"design_trials", found.trials, si::one, "trials", "calculations that the search took", {}});
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

}  // namespace taut::design
