#include "taut/app/design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "taut/analysis/pattern_search.hpp"
#include "taut/analysis/sizing.hpp"
#include "taut/app/design_tables.hpp"

namespace taut::app {
namespace {

using analysis::SizingAnswer;
using analysis::SizingTrial;

/// The check that decides: of those that fail the worst, else the one nearest to its limit.
SizingTrial trial_of(const Result& r) {
  if (r.status != Status::ok) return {false, std::nan(""), r.message};
  SizingTrial trial{true, 0, "no check"};
  for (const Check& c : r.checks) {
    const double u = std::isnan(c.utilisation) ? HUGE_VAL : c.utilisation;
    if (!c.passes) trial.passes = false;
    if (u < trial.utilisation) continue;
    trial.utilisation = u;
    trial.governs = c.name;
  }
  return trial;
}

/// A deck that looks at one place of each load path only, where the rope was worst before. What fails there fails in
/// the whole: every check takes the worst of all states.
MachineDeck at_places(const MachineDeck& deck, const std::map<std::size_t, double>& places) {
  MachineDeck probe = deck;
  for (const auto& [i, x] : places) {
    LoadPathRequest& one = *probe.analyses[i].load_path;
    one.from = one.to = x;
    one.steps = 1;
  }
  std::erase_if(probe.analyses, [](const AnalysisRequest& a) { return !a.load_path && !a.equilibrium; });
  return probe;
}

/// Where each load path has its largest tension by its table; empty where there is none.
std::map<std::size_t, double> worst_places(const MachineDeck& deck, const Result& r) {
  std::map<std::size_t, double> places;
  std::size_t number = 0;
  for (std::size_t i = 0; i < deck.analyses.size(); ++i) {
    if (!deck.analyses[i].load_path) continue;
    ++number;
    const auto& name = deck.analyses[i].load_path->name;
    const std::string table = "load_path" + (name          ? "_" + *name
                                             : number == 1 ? std::string{}
                                                           : fmt::format("_{}", number));
    const Table* t = r.find_table(table);
    if (t == nullptr) continue;
    double most = 0;
    for (const auto& row : t->rows) {
      for (std::size_t c = 0; c < t->columns.size(); ++c) {
        const auto* T = std::get_if<double>(&row[c]);
        if (T == nullptr || !t->columns[c].name.ends_with(".T_max") || !(*T > most)) continue;
        most = *T;
        places[i] = std::get<double>(row.front());
      }
    }
  }
  return places;
}

class Design {
 public:
  Design(const MachineDeck& deck, const DesignSpace& space, const RunDeck& run)
      : deck_(deck), space_(space), run_(run) {}

  SizingTrial try_one(const std::vector<std::size_t>& choice) {
    const MachineDeck whole = with_choice(deck_, space_, choice);
    if (!places_.empty()) {
      const Result r = run_(at_places(whole, places_), true);
      const SizingTrial probe = trial_of(r);
      if (!probe.passes) return probe;
    }
    const Result r = run_(whole, true);
    const SizingTrial trial = trial_of(r);
    if (!trial.passes) places_ = worst_places(deck_, r);
    return trial;
  }

 private:
  const MachineDeck& deck_;
  const DesignSpace& space_;
  const RunDeck& run_;
  std::map<std::size_t, double> places_;
};

/// The answer at one place of the grid of unknowns.
SizingAnswer search(const MachineDeck& deck, const DesignSpace& space, const RunDeck& run) {
  analysis::SizingOptions options;
  options.most_trials = static_cast<std::size_t>(deck.design->most_trials);
  options.neighbours = static_cast<std::size_t>(deck.design->runner_ups);
  Design design(deck, space, run);
  return analysis::cheapest(
      costs_of(space), [&](const std::vector<std::size_t>& c) { return design.try_one(c); }, options);
}

/// The next place of the grid; false behind the last one.
bool advance(const DesignSpace& space, std::vector<std::size_t>& place) {
  for (std::size_t k = place.size(); k-- > 0;) {
    if (++place[k] < space.unknowns[k].values.size()) return true;
    place[k] = 0;
  }
  return false;
}

std::vector<DesignPoint> all_points(const MachineDeck& deck, const DesignSpace& space, const RunDeck& run) {
  std::vector<DesignPoint> points;
  std::vector<std::size_t> place(space.unknowns.size(), 0);
  do {
    DesignPoint& point = points.emplace_back();
    for (std::size_t k = 0; k < place.size(); ++k) point.values.push_back(space.unknowns[k].values[place[k]]);
    point.answer = search(with_values(deck, space, point.values), space, run);
  } while (advance(space, place));
  return points;
}

/// The least cost, of equal ones that with the most reserve.
const DesignPoint& best_of(const std::vector<DesignPoint>& points) {
  return *std::min_element(points.begin(), points.end(), [](const DesignPoint& a, const DesignPoint& b) {
    if (a.answer.outcome.ok() != b.answer.outcome.ok()) return a.answer.outcome.ok();
    if (a.answer.best.cost != b.answer.best.cost) return a.answer.best.cost < b.answer.best.cost;
    return a.answer.best.trial.utilisation < b.answer.best.trial.utilisation;
  });
}

/// The choice of the best place with the most reserve: its unknowns anywhere in their ranges. What fails its checks has
/// none.
void refine(const MachineDeck& deck, const DesignSpace& space, const RunDeck& run, DesignPoint& best) {
  if (best.values.empty()) return;
  std::vector<double> low;
  std::vector<double> high;
  std::vector<double> step;
  for (const UnknownValues& one : space.unknowns) {
    const auto [least, most] = std::minmax(one.values.front(), one.values.back());
    low.push_back(least);
    high.push_back(most);
    step.push_back((most - least) / static_cast<double>(one.values.size() - 1) / 2);
  }
  const auto used = [&](const std::vector<double>& values) {
    const SizingTrial trial =
        trial_of(run(with_choice(with_values(deck, space, values), space, best.answer.best.choice), true));
    return trial.passes ? trial.utilisation : HUGE_VAL;
  };
  const analysis::PatternAnswer found = analysis::pattern_search(used, best.values, low, high, step);
  if (found.value < best.answer.best.trial.utilisation) best.values = found.x;
}

Result no_design(const MachineDeck& deck, const DesignSpace& space, const std::vector<DesignPoint>& points) {
  const SizingAnswer& answer = points.front().answer;
  Result r;
  r.method_title = "Machine";
  r.given = given_of(MachineDeck::describe(), &deck);
  r.status = answer.outcome.status;
  r.message = fmt::format("design: {}", answer.outcome.message);
  if (!answer.below.empty()) {
    const auto& last = answer.below.back();
    r.message +=
        fmt::format("; the last one tried, {}, fails by {}{}", names_of(space, last.choice), last.trial.governs,
                    std::isfinite(last.trial.utilisation) ? fmt::format(" (utilisation {:.3g})", last.trial.utilisation)
                                                          : std::string{});
  }
  add_runner_ups(deck, space, answer, r);
  if (points.size() > 1) add_trade_off(deck, space, points, r);
  return r;
}

}  // namespace

Result run_design(const MachineDeck& deck, const DesignSpace& space, const RunDeck& run) {
  const std::vector<DesignPoint> points = all_points(deck, space, run);
  DesignPoint best = best_of(points);
  if (!best.answer.outcome.ok()) return no_design(deck, space, points);
  if (deck.design->refine) refine(deck, space, run, best);
  Result r = run(with_choice(with_values(deck, space, best.values), space, best.answer.best.choice), false);
  add_design(deck, space, points, best, r);
  return r;
}

}  // namespace taut::app
