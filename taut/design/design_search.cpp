#include "taut/design/design_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "taut/design/constrained.hpp"
#include "taut/design/design_checks.hpp"

namespace taut::design {
namespace {

using design::SizingAnswer;
using design::SizingCandidate;
using design::SizingTrial;

constexpr std::size_t starts = 3;            // places of the grid from which the best choice is moved on
constexpr std::size_t most_near_misses = 8;  // cheaper choices that are moved on to see whether they pass
constexpr double near_enough = 3;            // utilisation up to which a choice that fails is a near miss
constexpr int trials_of_near_miss = 60;
constexpr double coarse = 1e-3;  // as finest_share, but where a choice is only moved to see whether it passes
constexpr int most_rounds = 3;
constexpr double trials_between = 600;   // about, between the places of the grid
constexpr double least_for_aside = 400;  // trials of what was set aside; as many as the search has needed where more

std::vector<std::vector<double>> costs_of(const DesignTask& task, const DesignLengths& lengths) {
  std::vector<std::vector<double>> costs;
  const auto add = [&](const auto& lists, const std::vector<double>& by) {
    for (std::size_t k = 0; k < lists.size(); ++k) {
      std::vector<double>& own = costs.emplace_back(lists[k].costs);
      for (double& one : own) one *= by[k];
    }
  };
  add(task.space.ropes, lengths.ropes);
  add(task.space.sections, lengths.sections);
  return costs;
}

/// Whether `a` is the better of two answers: it passes, it costs less, it has more reserve.
bool better(const SizingCandidate& a, const SizingCandidate& b) {
  if (a.trial.passes != b.trial.passes) return a.trial.passes;
  if (a.trial.passes && a.cost != b.cost) return a.cost < b.cost;
  const auto use = [](const SizingTrial& t) { return std::isnan(t.utilisation) ? HUGE_VAL : t.utilisation; };
  return use(a.trial) < use(b.trial);
}

class Searching {
 public:
  explicit Searching(const DesignTask& task)
      : task_(task),
        measured_(is_measured(task.request.seek)),
        ask_([this](const Progress&) { return go_on(); }),
        record_(task.list_of) {}

  DesignFound search() {
    over_the_grid();
    try_what_was_set_aside();
    find_best();
    if (task_.request.refine && !task_.space.unknowns.empty() && !found_.ended) move_on();
    find_unanswered();
    if (!found_.feasible && found_.unanswered.empty() && task_.space.cases.size() > 1) look_at_nearest();
    return std::move(found_);
  }

 private:
  /// What is sought of a place whose cost is known before. The lengths are those of the values before, mostly.
  double cost_of(const DesignPlace& place) {
    const auto [known, is_new] = lengths_.try_emplace(place.values);
    if (is_new) known->second = task_.lengths(place.values);
    double cost = known->second.rest;
    const std::size_t ropes = task_.space.ropes.size();
    for (std::size_t k = 0; k < place.choice.size(); ++k) {
      const bool rope = k < ropes;
      const double length = rope ? known->second.ropes[k] : known->second.sections[k - ropes];
      cost += length * (rope ? task_.space.ropes[k].costs : task_.space.sections[k - ropes].costs)[place.choice[k]];
    }
    return cost;
  }

  /// Called before each calculation, and from inside long ones.
  bool go_on() {
    if (found_.ended || !task_.progress) return !found_.ended;
    const double here = static_cast<double>(tried_here_) / most_here_;
    found_.ended = !task_.progress({.what = "design",
                                    .done = std::min(part_ + share_ * std::min(here, 1.0), 1.0),
                                    .words = fmt::format("{}, {} choices tried", words_, tried_here_)});
    return !found_.ended;
  }

  DesignRun run(const DesignPlace& place, Depth depth) {
    DesignRun one = task_.run(place, depth, ask_);
    found_.trials += 1;
    ++tried_here_;
    if (one.result.interrupted) found_.ended = true;
    note_cases(place, one.cases);
    return one;
  }

  void note_cases(const DesignPlace& place, const AnswersOfCases& cases) {
    answered_.insert(cases.with.begin(), cases.with.end());
    for (const auto& [name, why] : cases.without) without_.try_emplace(name, why);
    if (cases.without.empty() || !cases.others_pass) return;
    std::set<std::string> names;
    for (const auto& [name, why] : cases.without) names.insert(name);
    all_but_.try_emplace(std::move(names), place);
  }

  /// A case that one choice has an answer in is no mistake of the case.
  void find_unanswered() {
    for (const auto& [name, why] : without_) {
      if (answered_.find(name) == answered_.end()) found_.unanswered.emplace(name, why);
    }
    for (const auto& [names, place] : all_but_) {
      const bool never = std::all_of(names.begin(), names.end(), [&](const std::string& name) {
        return found_.unanswered.find(name) != found_.unanswered.end();
      });
      if (never && !found_.all_but_unanswered) found_.all_but_unanswered = place;
    }
  }

  double measure(const DesignRun& one, const SizingTrial& trial) const {
    return task_.request.seek == Seek::least_tension ? one.tension : trial.utilisation;
  }

  SizingTrial try_one(const DesignPlace& place) {
    if (const auto known = record_.hopeless(place.choice); known && !sets_nothing_aside_) {
      // it may be near to passing between the places of the grid
      if (!place.values.empty() && known->utilisation < near_enough)
        remember({.choice = place.choice, .cost = 0, .trial = *known}, place.values);
      return *known;
    }
    SizingTrial trial;
    trial.ended = !go_on();
    if (trial.ended) return trial;
    const DesignRun one = run(place, Depth::quick);
    trial = trial_of(one.result, task_.list_of);
    trial.measured = measure(one, trial);
    trial.ended = found_.ended;
    record_.take(place.choice, one.result);
    if (!trial.ended) remember({.choice = place.choice, .cost = 0, .trial = trial}, place.values);
    return trial;
  }

  /// Of each choice the place where it came nearest to passing.
  void remember(SizingCandidate one, const std::vector<double>& values) {
    if (!measured_) one.cost = cost_of({.choice = one.choice, .values = values});
    const auto [known, is_new] = tried_.try_emplace(one.choice, one, values);
    if (!is_new && better(one, known->second.first)) known->second = {std::move(one), values};
  }

  design::SizingOptions sizing_options() const {
    design::SizingOptions options;
    options.most_trials = static_cast<std::size_t>(task_.request.most_trials);
    options.neighbours = static_cast<std::size_t>(task_.request.runner_ups);
    return options;
  }

  SizingAnswer least_at(const std::vector<double>& values) {
    const design::SizingOptions options = sizing_options();
    record_ = CandidateRecord(task_.list_of);
    tried_here_ = 0;
    most_here_ = 1;
    for (const auto& one : task_.space.ropes) most_here_ *= static_cast<double>(one.rows.size());
    for (const auto& one : task_.space.sections) most_here_ *= static_cast<double>(one.rows.size());
    most_here_ = std::min(most_here_, static_cast<double>(task_.request.most_trials));
    const auto one = [&](const std::vector<std::size_t>& choice) {
      return try_one({.choice = choice, .values = values});
    };
    const DesignLengths lengths = task_.lengths(values);
    const auto costs = costs_of(task_, lengths);
    if (!measured_) {
      SizingAnswer answer = design::cheapest(costs, one, options);
      // to the last bit what is compared with it later
      const auto weigh = [&](SizingCandidate& c) { c.cost = cost_of({.choice = c.choice, .values = values}); };
      std::for_each(answer.aside.begin(), answer.aside.end(), weigh);
      if (answer.outcome.ok()) weigh(answer.best);
      std::for_each(answer.below.begin(), answer.below.end(), weigh);
      std::for_each(answer.above.begin(), answer.above.end(), weigh);
      return answer;
    }
    std::vector<std::size_t> counts;
    counts.reserve(costs.size());
    for (const auto& list : costs) counts.push_back(list.size());
    return design::least_measured(counts, one, options);
  }

  /// Tries what was set aside at a place, as long as there are trials left for it.
  void try_aside(DesignPoint& point) {
    if (found_.ended || point.answer.aside.empty()) return;
    const double most = std::max(least_for_aside, found_.trials - spent_on_aside_) - spent_on_aside_;
    const double before = found_.trials;
    sets_nothing_aside_ = true;
    design::try_aside(
        point.answer,
        [&](const std::vector<std::size_t>& choice) { return try_one({.choice = choice, .values = point.values}); },
        static_cast<std::size_t>(std::max(most, 0.0)), sizing_options());
    sets_nothing_aside_ = false;
    spent_on_aside_ += found_.trials - before;
    if (point.answer.best.trial.passes && !measured_)
      point.answer.best.cost = cost_of({.choice = point.answer.best.choice, .values = point.values});
  }

  /// Where a place of the grid has an answer, at the best of them; else "none passes" is said of all.
  void try_what_was_set_aside() {
    DesignPoint* best = nullptr;
    for (DesignPoint& point : found_.points) {
      if (!point.answer.outcome.ok()) continue;
      if (best == nullptr || better(point.answer.best, best->answer.best)) best = &point;
    }
    if (best != nullptr) return try_aside(*best);
    for (DesignPoint& point : found_.points) {
      if (point.answer.outcome.status == Status::infeasible) try_aside(point);
    }
  }

  void over_the_grid() {
    const auto& unknowns = task_.space.unknowns;
    std::size_t places = 1;
    for (const UnknownValues& one : unknowns) places *= one.values.size();
    for (std::size_t i = 0; i < places && !found_.ended; ++i) {
      std::vector<double> values(unknowns.size());
      std::size_t rest = i;
      for (std::size_t k = unknowns.size(); k-- > 0;) {
        values[k] = unknowns[k].values[rest % unknowns[k].values.size()];
        rest /= unknowns[k].values.size();
      }
      share_ = 1 / static_cast<double>(places + (unknowns.empty() ? 0 : 1));
      part_ = static_cast<double>(i) * share_;
      words_ = places > 1 ? fmt::format("place {} of {}", i + 1, places) : std::string("by their cost");
      DesignPoint point{.values = values, .answer = least_at(values)};
      if (found_.ended && point.answer.trials == 0) break;
      found_.points.push_back(std::move(point));
    }
  }

  void find_best() {
    for (const DesignPoint& point : found_.points) {
      if (!point.answer.outcome.ok() || !point.answer.best.trial.passes) continue;
      if (found_.feasible && !better(point.answer.best, found_.best.answer.best)) continue;
      found_.best = point;
      found_.feasible = true;
    }
    const std::pair<SizingCandidate, std::vector<double>>* nearest = nullptr;
    for (const auto& [choice, one] : tried_) {
      if (nearest == nullptr || better(one.first, nearest->first)) nearest = &one;
    }
    if (nearest == nullptr) return;
    found_.nearest = nearest->first;
    found_.nearest_values = nearest->second;
  }

  /// A quick look ends at a load case that fails, so that a choice may fail by more than was seen. The nearest is the
  /// one that fails by least in all cases.
  void look_at_nearest() {
    std::vector<const std::pair<SizingCandidate, std::vector<double>>*> seen;
    seen.reserve(tried_.size());
    for (const auto& [choice, one] : tried_) seen.push_back(&one);
    std::stable_sort(seen.begin(), seen.end(), [](auto* a, auto* b) { return better(a->first, b->first); });
    std::optional<SizingCandidate> nearest;
    std::vector<double> values;
    for (const auto* one : seen) {
      if ((nearest && !better(one->first, *nearest)) || !go_on()) break;
      SizingCandidate whole = one->first;
      whole.trial = trial_of(run({.choice = whole.choice, .values = one->second}, Depth::checks).result, task_.list_of);
      // find_unanswered tells of a choice that has no answer in some case
      if (found_.ended || std::isnan(whole.trial.utilisation)) continue;
      if (nearest && !better(whole, *nearest)) continue;
      nearest = std::move(whole);
      values = one->second;
    }
    if (!nearest) return;
    found_.nearest = *std::move(nearest);
    found_.nearest_values = std::move(values);
  }

  /// Which unknowns change what is sought of a choice.
  std::vector<bool> that_cost(const DesignPlace& place) {
    if (measured_) return std::vector<bool>(place.values.size(), task_.request.seek == Seek::least_tension);
    std::vector<bool> cost(place.values.size());
    const double here = cost_of(place);
    for (std::size_t k = 0; k < place.values.size(); ++k) {
      for (const double end : {task_.space.unknowns[k].low, task_.space.unknowns[k].high}) {
        DesignPlace there = place;
        there.values[k] = end;
        if (std::abs(cost_of(there) - here) > 1e-9 * std::abs(here)) cost[k] = true;
      }
    }
    return cost;
  }

  /// Moves the unknowns of one choice on, and takes the place where it passes if that is better than the best.
  /// `until_it_passes`: ends there; `held`: unknowns that stay. Returns the last place where it passed.
  std::optional<std::vector<double>> move_from(const DesignPlace& start, design::Sought sought, bool until_it_passes,
                                               const std::vector<bool>& held = {}) {
    std::vector<double> low;
    std::vector<double> high;
    std::vector<double> step;
    for (const UnknownValues& one : task_.space.unknowns) {
      low.push_back(one.low);
      high.push_back(one.high);
      step.push_back((one.high - one.low) / static_cast<double>(2 * std::max<std::size_t>(one.values.size() - 1, 2)));
    }
    for (std::size_t k = 0; k < held.size(); ++k) {
      if (held[k]) low[k] = high[k] = start.values[k];
    }
    CheckConstraints constraints;
    std::optional<std::vector<double>> passed;
    const auto look = [&](const std::vector<double>& values) -> std::optional<design::ConstrainedPoint> {
      if ((passed && until_it_passes) || !go_on()) return {};
      const DesignPlace place{.choice = start.choice, .values = values};
      const DesignRun one = run(place, Depth::checks);
      if (found_.ended) return {};
      design::ConstrainedPoint point;
      if (one.result.status != Status::ok) {
        point.value = std::nan("");
        point.over = constraints.nothing();
        return point;
      }
      SizingCandidate here{.choice = start.choice, .cost = 0, .trial = trial_of(one.result, task_.list_of)};
      here.cost = measured_ ? measure(one, here.trial) : cost_of(place);
      point.value = here.cost;
      point.over = constraints.of(one.result);
      if (here.trial.passes) passed = values;
      if (here.trial.passes && (!found_.feasible || better(here, found_.best.answer.best))) take(here, values);
      return point;
    };
    design::ConstrainedOptions options;
    options.tolerance = until_it_passes || !held.empty() ? coarse : finest_share;
    if (until_it_passes) options.most_evaluations = trials_of_near_miss;
    design::least_within(look, sought, {.start = start.values, .low = low, .high = high, .step = step}, options);
    return passed;
  }

  void take(const SizingCandidate& one, const std::vector<double>& values) {
    found_.best.values = values;
    found_.best.answer.best = one;
    found_.best.answer.outcome = {};
    found_.feasible = found_.refined = true;
  }

  void move_on() {
    part_ = 1 - share_;
    tried_here_ = 0;
    most_here_ = trials_between;
    words_ = "between the places of the grid";
    if (found_.feasible) move_best();
    for (const auto& [choice, values] : near_misses()) {
      if (found_.ended) return;
      if (may_be_cheaper(choice)) move_near_miss(choice, values);
    }
    if (found_.feasible && found_.refined) settle();
  }

  /// Where some unknowns do not change the cost, these move on to the most reserve at the cost found.
  void use_the_rest() {
    const DesignPlace place{.choice = found_.best.answer.best.choice, .values = found_.best.values};
    const std::vector<bool> cost = that_cost(place);
    const auto free = std::count(cost.begin(), cost.end(), false);
    if (free == 0 || free == std::ssize(cost) || measured_) return;
    move_from(place, design::Sought::most_reserve, false, cost);
  }

  /// At the values found no cheaper choice is to pass; and its neighbours are those at these values.
  void settle() {
    use_the_rest();
    for (int round = 0; round < most_rounds && !found_.ended; ++round) {
      words_ = "at the values found";
      DesignPoint here{.values = found_.best.values, .answer = least_at(found_.best.values)};
      try_aside(here);
      SizingAnswer& answer = here.answer;
      if (answer.ended || !answer.outcome.ok()) return;
      const bool is_better =
          answer.best.choice != found_.best.answer.best.choice && better(answer.best, found_.best.answer.best);
      found_.best.answer.below = std::move(answer.below);
      found_.best.answer.above = std::move(answer.above);
      found_.best.answer.aside = std::move(answer.aside);
      if (!is_better) return;
      take(answer.best, found_.best.values);
      move_near_miss(answer.best.choice, found_.best.values);
      use_the_rest();
    }
  }

  design::Sought sought_of(const DesignPlace& place) {
    const std::vector<bool> cost = that_cost(place);
    return std::find(cost.begin(), cost.end(), true) == cost.end() ? design::Sought::most_reserve
                                                                   : design::Sought::least_value;
  }

  /// The best choice, from the best places of the grid.
  void move_best() {
    const std::vector<std::size_t> choice = found_.best.answer.best.choice;
    std::vector<const DesignPoint*> points;
    for (const DesignPoint& point : found_.points) {
      if (point.answer.outcome.ok()) points.push_back(&point);
    }
    std::stable_sort(points.begin(), points.end(),
                     [](const DesignPoint* a, const DesignPoint* b) { return better(a->answer.best, b->answer.best); });
    if (points.size() > starts) points.resize(starts);
    const design::Sought sought = sought_of({.choice = choice, .values = found_.best.values});
    for (const DesignPoint* point : points) {
      if (!found_.ended) move_from({.choice = choice, .values = point->values}, sought, false);
    }
  }

  /// The least cost of a choice with the unknowns where the best has them, or at a place of the grid.
  double least_cost_of(const std::vector<std::size_t>& choice) {
    double least = cost_of({.choice = choice, .values = found_.best.values});
    for (const DesignPoint& point : found_.points) {
      least = std::min(least, cost_of({.choice = choice, .values = point.values}));
    }
    return least;
  }

  /// Whether a choice could be better than the best.
  bool may_be_cheaper(const std::vector<std::size_t>& choice) {
    return !found_.feasible || measured_ || least_cost_of(choice) < found_.best.answer.best.cost;
  }

  /// Choices beside the best one that may pass, or be better, between the places of the grid: those that come nearest,
  /// the cheapest first, each with its best place.
  std::vector<std::pair<std::vector<std::size_t>, std::vector<double>>> near_misses() {
    std::vector<std::pair<SizingCandidate, std::vector<double>>> close;
    for (const auto& [choice, one] : tried_) {
      const double use = one.first.trial.utilisation;
      const bool near = found_.feasible ? use < near_enough : std::isfinite(use);
      const bool is_best = found_.feasible && choice == found_.best.answer.best.choice;
      if (near && !is_best && may_be_cheaper(choice)) close.push_back(one);
    }
    std::stable_sort(close.begin(), close.end(), [](const auto& a, const auto& b) {
      return a.first.trial.utilisation < b.first.trial.utilisation;
    });
    if (close.size() > most_near_misses) close.resize(most_near_misses);
    for (auto& [candidate, values] : close) {
      if (found_.feasible && !measured_) candidate.cost = least_cost_of(candidate.choice);
    }
    std::stable_sort(close.begin(), close.end(),
                     [](const auto& a, const auto& b) { return a.first.cost < b.first.cost; });
    std::vector<std::pair<std::vector<std::size_t>, std::vector<double>>> all;
    all.reserve(close.size());
    for (const auto& [candidate, values] : close) all.emplace_back(candidate.choice, values);
    return all;
  }

  /// First to where it passes, from there on as the best one.
  void move_near_miss(const std::vector<std::size_t>& choice, const std::vector<double>& values) {
    std::optional<std::vector<double>> start = values;
    if (!tried_.at(choice).first.trial.passes) {
      start = move_from({.choice = choice, .values = values}, design::Sought::most_reserve, true);
    }
    if (start && !found_.ended)
      move_from({.choice = choice, .values = *start}, sought_of({.choice = choice, .values = *start}), false);
  }

  const DesignTask& task_;
  bool measured_;
  std::function<bool(const Progress&)> ask_;
  DesignFound found_;
  std::map<std::vector<std::size_t>, std::pair<SizingCandidate, std::vector<double>>> tried_;
  CandidateRecord record_;                                // of one place of the grid
  std::set<std::string> answered_;                        // load cases that some choice has an answer in
  std::map<std::string, std::string> without_;            // load cases that some choice has none in, and why
  std::map<std::set<std::string>, DesignPlace> all_but_;  // by these the first choice that passes all others
  std::map<std::vector<double>, DesignLengths> lengths_;
  double part_ = 0, share_ = 1;  // how far the search is, and what the place it is at adds to it
  int tried_here_ = 0;
  double most_here_ = 1;
  bool sets_nothing_aside_ = false;
  double spent_on_aside_ = 0;  // trials
  std::string words_;
};

}  // namespace

bool is_measured(Seek seek) { return seek == Seek::least_tension || seek == Seek::most_reserve; }

DesignFound search_design(const DesignTask& task) { return Searching(task).search(); }

DesignPlace first_place(const DesignSpace& space) {
  DesignPlace place;
  place.choice.assign(space.ropes.size() + space.sections.size(), 0);
  for (const UnknownValues& one : space.unknowns)
    place.values.push_back(one.values.empty() ? one.low : one.values.front());
  return place;
}

}  // namespace taut::design
