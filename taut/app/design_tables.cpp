#include "taut/app/design_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace taut::app {
namespace {

using analysis::SizingCandidate;
using catalogue::RopeRow;

constexpr double nearly_active = 0.9;  // utilisation of checks that are told as active

Unit cost_unit(Seek seek) {
  return seek == Seek::lightest ? si::kg : seek == Seek::smallest ? si::m.in("mm") : si::one;
}

Table chosen_table(const DesignSpace& space, const SizingCandidate& best) {
  Table t{"design", "The ropes chosen", {}, {}};
  t.columns = {{"rope", si::one},
               {"designation", si::one},
               {"diameter", si::m.in("mm")},
               {"area", si::m2},
               {"mass_per_metre", si::kg_per_m},
               {"grade", si::Pa},
               {"breaking_force", si::N},
               {"stiffness", si::N},
               {"trust", si::one}};
  for (std::size_t k = 0; k < space.ropes.size(); ++k) {
    const RopeRow& row = space.ropes[k].rows[best.choice[k]];
    t.rows.push_back({space.ropes[k].name, row.id, row.diameter, row.area, row.mass_per_length,
                      row.grade.value_or(std::nan("")), row.breaking_force, space.ropes[k].modulus * row.area,
                      std::string(catalogue::to_text(row.trust))});
  }
  return t;
}

Table section_table(const DesignSpace& space, const SizingCandidate& best) {
  Table t{"design_sections", "The sections chosen", {}, {}};
  t.columns = {{"beam", si::one}, {"section", si::one}, {"mass_per_metre", si::kg_per_m}, {"trust", si::one}};
  for (std::size_t k = 0; k < space.sections.size(); ++k) {
    const catalogue::SectionRow& row = space.sections[k].rows[best.choice[space.ropes.size() + k]];
    t.rows.push_back(
        {space.sections[k].name, row.name, row.mass_per_length, std::string(catalogue::to_text(row.trust))});
  }
  return t;
}

Table active_checks(const Result& r) {
  Table t{"design_active", "Checks near their limits: what holds the design", {}, {}};
  t.columns = {{"check", si::one}, {"utilisation", si::one}, {"rule", si::one}, {"trust", si::one}};
  std::vector<Check> all = r.checks;
  std::stable_sort(all.begin(), all.end(),
                   [](const Check& a, const Check& b) { return a.utilisation > b.utilisation; });
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i > 0 && all[i].utilisation < nearly_active) break;
    t.rows.push_back({all[i].name, all[i].utilisation, all[i].rule, all[i].trust});
  }
  return t;
}

Plot trade_off_plot(const UnknownValues& unknown, Seek seek, const std::vector<DesignPoint>& points) {
  Plot p;
  p.name = "design_trade_off";
  p.title = fmt::format("The least cost over {}", unknown.name);
  p.x = {unknown.name, unknown.unit};
  p.y = {"cost", cost_unit(seek)};
  Curve c;
  c.label = "least that passes";
  for (const DesignPoint& point : points) {
    if (!point.answer.outcome.ok()) continue;
    c.x.push_back(point.values.front());
    c.y.push_back(point.answer.best.cost);
  }
  if (c.x.size() > 1) p.curves.push_back(std::move(c));
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

void add_runner_ups(const MachineDeck& deck, const DesignSpace& space, const analysis::SizingAnswer& answer,
                    Result& r) {
  if (space.ropes.empty() && space.sections.empty()) return;
  Table t{"design_runner_ups", "The choice between its neighbours, and what governs each", {}, {}};
  t.columns = {{"choice", si::one},
               {"cost", cost_unit(deck.design->seek)},
               {"outcome", si::one},
               {"governs", si::one},
               {"utilisation", si::one}};
  const auto add = [&](const SizingCandidate& c, const char* outcome) {
    t.rows.push_back({names_of(space, c.choice), c.cost, std::string(outcome), c.trial.governs, c.trial.utilisation});
  };
  for (const SizingCandidate& c : answer.below) add(c, "fails");
  if (answer.outcome.ok()) add(answer.best, "chosen");
  for (const SizingCandidate& c : answer.above) add(c, "passes");
  r.tables.push_back(std::move(t));
}

void add_trade_off(const MachineDeck& deck, const DesignSpace& space, const std::vector<DesignPoint>& points,
                   Result& r) {
  Table t{"design_trade_off", "The least choice over what is free besides, and what holds it", {}, {}};
  for (const UnknownValues& one : space.unknowns) t.columns.push_back({one.name, one.unit});
  const std::vector<Column> rest = {
      {"cost", cost_unit(deck.design->seek)}, {"governs", si::one}, {"utilisation", si::one}, {"choice", si::one}};
  t.columns.insert(t.columns.end(), rest.begin(), rest.end());
  for (const DesignPoint& point : points) {
    std::vector<Cell> row(point.values.begin(), point.values.end());
    const auto& answer = point.answer;
    const bool found = answer.outcome.ok();
    const bool failed = !found && !answer.below.empty();
    const analysis::SizingTrial last = found    ? answer.best.trial
                                       : failed ? answer.below.back().trial
                                                : analysis::SizingTrial{};
    row.insert(row.end(), {found ? answer.best.cost : std::nan(""), last.governs, last.utilisation,
                           found ? names_of(space, answer.best.choice) : answer.outcome.message});
    t.rows.push_back(std::move(row));
  }
  r.tables.push_back(std::move(t));
}

void add_design(const MachineDeck& deck, const DesignSpace& space, const std::vector<DesignPoint>& points,
                const DesignPoint& best, Result& r) {
  const Seek seek = deck.design->seek;
  static constexpr const char* what[] = {"mass of the ropes (by their straight lengths) and sections chosen",
                                         "sum of the diameters and outer heights chosen",
                                         "price of the ropes chosen, by their straight lengths"};
  std::vector<Value> values;
  const bool choice = !space.ropes.empty() || !space.sections.empty();
  if (choice) {
    values.push_back({"design_cost", best.answer.best.cost, cost_unit(seek), "cost", what[static_cast<int>(seek)], {}});
  }
  for (std::size_t k = 0; k < best.values.size(); ++k) {
    const UnknownValues& one = space.unknowns[k];
    values.push_back(
        {"design_" + one.name, best.values[k], one.unit, one.name, fmt::format("{} chosen", one.parameter), {}});
  }
  double trials = 0;
  for (const DesignPoint& point : points) trials += static_cast<double>(point.answer.trials);
  values.push_back({"design_trials", trials, si::one, "trials", "choices tried up to those that pass", {}});
  r.values.insert(r.values.begin(), std::make_move_iterator(values.begin()), std::make_move_iterator(values.end()));
  Result own;
  if (!space.ropes.empty()) own.tables.push_back(chosen_table(space, best.answer.best));
  if (!space.sections.empty()) own.tables.push_back(section_table(space, best.answer.best));
  own.tables.push_back(active_checks(r));
  add_runner_ups(deck, space, best.answer, own);
  if (points.size() > 1) add_trade_off(deck, space, points, own);
  r.tables.insert(r.tables.begin(), std::make_move_iterator(own.tables.begin()),
                  std::make_move_iterator(own.tables.end()));
  if (space.unknowns.size() != 1 || !choice) return;
  Plot plot = trade_off_plot(space.unknowns.front(), seek, points);
  if (!plot.curves.empty()) r.figures.emplace_back(std::move(plot));
}

}  // namespace taut::app
