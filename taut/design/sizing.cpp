#include "taut/design/sizing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <utility>

#include "taut/base/expects.hpp"

namespace taut::design {
namespace {

using Choice = std::vector<std::size_t>;

/// All choices in the order of their costs. The successors of a choice raise one index, the last one raised or one
/// behind it, so that each choice comes once.
class InOrder {
 public:
  explicit InOrder(const std::vector<std::vector<double>>& costs) : costs_(costs) { push(Choice(costs.size(), 0), 0); }

  bool next(Choice& choice, double& cost) {
    if (queue_.empty()) return false;
    const Entry top = queue_.top();
    queue_.pop();
    for (std::size_t k = top.raised; k < costs_.size(); ++k) {
      Choice after = top.choice;
      if (++after[k] < costs_[k].size()) push(std::move(after), k);
    }
    choice = top.choice;
    cost = top.cost;
    return true;
  }

 private:
  struct Entry {
    double cost = 0;
    Choice choice;
    std::size_t raised = 0;
    bool operator<(const Entry& other) const {  // a priority queue has its largest entry on top
      return cost != other.cost ? cost > other.cost : choice > other.choice;
    }
  };
  void push(Choice choice, std::size_t raised) {
    double cost = 0;
    for (std::size_t k = 0; k < choice.size(); ++k) cost += costs_[k][choice[k]];
    queue_.push({cost, std::move(choice), raised});
  }

  const std::vector<std::vector<double>>& costs_;
  std::priority_queue<Entry> queue_;
};

void expect_ascending(const std::vector<std::vector<double>>& costs) {
  for (const auto& list : costs) {
    expects(!list.empty() && std::is_sorted(list.begin(), list.end()), "lists of costs ascend and are not empty");
  }
}

/// Of all that are given one after the other the last `most` stay.
void keep_last(const SizingCandidate& one, std::size_t most, std::vector<SizingCandidate>& kept) {
  if (most == 0) return;
  if (kept.size() == most) kept.erase(kept.begin());
  kept.push_back(one);
}

double use_of(const SizingCandidate& one) {
  return std::isnan(one.trial.utilisation) ? HUGE_VAL : one.trial.utilisation;
}

/// The `most` that fail by least stay, the nearest last; of equal ones the later.
void keep_nearest(const SizingCandidate& one, std::size_t most, std::vector<SizingCandidate>& kept) {
  const auto place =
      std::find_if(kept.begin(), kept.end(), [&](const auto& other) { return use_of(other) < use_of(one); });
  kept.insert(place, one);
  if (kept.size() > most) kept.erase(kept.begin());
}

/// Whether it stands before an answer: it costs less, or as much and comes first (measured: has more reserve).
bool precedes(const SizingCandidate& one, const SizingCandidate& other, bool measured) {
  if (one.cost != other.cost) return one.cost < other.cost;
  if (measured && use_of(one) != use_of(other)) return use_of(one) < use_of(other);
  return one.choice < other.choice;
}

/// Puts one that passes where it belongs.
void take_passing(const SizingCandidate& one, std::size_t neighbours, SizingAnswer& answer) {
  const auto before = [&](const SizingCandidate& a, const SizingCandidate& b) {
    return precedes(a, b, answer.measured);
  };
  if (!answer.outcome.ok()) {
    answer.outcome = {};
    answer.best = one;
    if (!answer.measured) answer.below.clear();  // those that fail by least, at whatever cost
    return;
  }
  answer.above.push_back(one);
  if (before(one, answer.best)) std::swap(answer.best, answer.above.back());
  std::sort(answer.above.begin(), answer.above.end(), before);
  if (answer.above.size() > neighbours) answer.above.resize(neighbours);
}

}  // namespace

SizingAnswer cheapest(const std::vector<std::vector<double>>& costs,
                      const std::function<SizingTrial(const std::vector<std::size_t>&)>& try_one,
                      const SizingOptions& options) {
  expect_ascending(costs);
  SizingAnswer answer;
  InOrder order(costs);
  SizingCandidate one;
  std::vector<SizingCandidate> nearest;
  bool found = false;
  std::size_t behind = 0;
  while (order.next(one.choice, one.cost)) {
    if (found && (answer.above.size() >= options.neighbours || behind >= options.more_trials)) break;
    if (!found && answer.trials >= options.most_trials) {
      answer.outcome = not_converged(
          fmt::format("no choice has passed within {} trials; narrow the candidates down", options.most_trials));
      answer.below = std::move(nearest);
      return answer;
    }
    one.trial = try_one(one.choice);
    if (one.trial.ended) {
      answer.ended = true;
      break;
    }
    if (one.trial.skipped) {
      if (!found) answer.aside.push_back(one);
      continue;
    }
    ++(found ? behind : answer.trials);
    if (one.trial.passes && !found) {
      found = true;
      answer.best = one;
    } else if (one.trial.passes) {
      answer.above.push_back(one);
    } else if (!found) {
      keep_last(one, options.neighbours, answer.below);
      keep_nearest(one, options.neighbours, nearest);
    }
  }
  if (!found) {
    answer.below = std::move(nearest);
    answer.outcome = answer.ended ? not_converged("ended") : infeasible("no choice passes all checks");
  }
  return answer;
}

SizingAnswer least_measured(const std::vector<std::size_t>& counts,
                            const std::function<SizingTrial(const std::vector<std::size_t>&)>& try_one,
                            const SizingOptions& options) {
  SizingAnswer answer;
  answer.measured = true;
  double choices = 1;
  for (const std::size_t n : counts) choices *= static_cast<double>(n);
  if (choices > static_cast<double>(options.most_trials)) {
    answer.outcome = not_converged(fmt::format(
        "what is sought is known of a choice when it is calculated, and {:.6g} choices are more than {}: narrow the "
        "candidates down",
        choices, options.most_trials));
    return answer;
  }
  std::vector<SizingCandidate> passed;
  std::vector<SizingCandidate> failed;
  Choice choice(counts.size(), 0);
  for (bool more = choices > 0; more;) {
    const SizingTrial trial = try_one(choice);
    if (trial.ended) {
      answer.ended = true;
      break;
    }
    if (trial.skipped) {
      answer.aside.push_back({choice, 0, trial});
    } else {
      ++answer.trials;
      (trial.passes ? passed : failed).push_back({choice, trial.measured, trial});
    }
    more = false;
    for (std::size_t k = choice.size(); k-- > 0 && !more;) {
      more = ++choice[k] < counts[k];
      if (!more) choice[k] = 0;
    }
  }
  std::stable_sort(passed.begin(), passed.end(), [](const SizingCandidate& a, const SizingCandidate& b) {
    return a.cost != b.cost ? a.cost < b.cost : a.trial.utilisation < b.trial.utilisation;
  });
  std::stable_sort(failed.begin(), failed.end(),
                   [](const SizingCandidate& a, const SizingCandidate& b) { return use_of(a) > use_of(b); });
  const auto last = [&](std::size_t n) { return static_cast<std::ptrdiff_t>(std::min(n, options.neighbours)); };
  answer.below.assign(failed.end() - last(failed.size()), failed.end());
  if (passed.empty()) {
    answer.outcome = answer.ended ? not_converged("ended") : infeasible("no choice passes all checks");
    return answer;
  }
  answer.best = passed.front();
  answer.above.assign(passed.begin() + 1, passed.begin() + 1 + last(passed.size() - 1));
  return answer;
}

void try_aside(SizingAnswer& answer, const std::function<SizingTrial(const std::vector<std::size_t>&)>& try_one,
               std::size_t most, const SizingOptions& options) {
  std::vector<SizingCandidate> aside = std::move(answer.aside);
  if (aside.size() > most) std::reverse(aside.begin(), aside.end());
  const auto is_dear = [&](const SizingCandidate& one) {
    return answer.outcome.ok() && !answer.measured && !precedes(one, answer.best, false);
  };
  answer.aside.clear();
  for (SizingCandidate& one : aside) {
    if (is_dear(one)) continue;
    if (most == 0 || answer.ended) {
      answer.aside.push_back(std::move(one));
      continue;
    }
    one.trial = try_one(one.choice);
    if (one.trial.ended) {
      answer.ended = true;
      answer.aside.push_back(std::move(one));
      continue;
    }
    --most;
    ++answer.trials;
    if (answer.measured) one.cost = one.trial.measured;
    if (one.trial.passes) {
      take_passing(one, options.neighbours, answer);
    } else if (!answer.outcome.ok()) {
      keep_nearest(one, options.neighbours, answer.below);
    }
  }
  std::erase_if(answer.aside, is_dear);
  if (answer.outcome.ok() && !answer.measured)
    std::erase_if(answer.below, [&](const auto& one) { return one.cost > answer.best.cost; });
}

}  // namespace taut::design
