#include "taut/design/design_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace taut::design {
namespace {

using design::SizingTrial;

constexpr double most_over = 10;
constexpr double least_margin = 1.05;

/// How far a check is over its limit, as a share: <= 0 exactly where it passes.
double over_of(const Check& c) {
  double over = c.utilisation - 1;
  const bool fits = std::isfinite(over) && (over <= 0) == c.passes && c.utilisation >= 0;
  if (!fits) {
    const double beyond = c.sense == Sense::at_most ? c.value - c.limit : c.limit - c.value;
    over = beyond / (std::abs(c.limit) > 0 ? std::abs(c.limit) : 1);
  }
  if (!std::isfinite(over) || (over <= 0) != c.passes) over = c.passes ? 0 : most_over;
  return std::clamp(over, -most_over, most_over);
}

}  // namespace

SizingTrial trial_of(const Result& r, const std::map<std::string, std::size_t>& list_of) {
  if (r.status != Status::ok) return {.passes = false, .utilisation = std::nan(""), .governs = r.message};
  // What is asked must be made, and a part that is chosen needs a limit: nothing passes because nothing spoke against
  // it.
  if (!r.unmade.empty()) return {.passes = false, .utilisation = std::nan(""), .governs = r.unmade.front()};
  if (!r.missing.empty())
    return {.passes = false,
            .utilisation = std::nan(""),
            .governs = r.missing.front().analysis + ": " + r.missing.front().reason};
  for (const std::string& part : r.unjudged) {
    if (list_of.find(part) != list_of.end()) {
      return {.passes = false,
              .utilisation = std::nan(""),
              .governs = fmt::format("'{}' is chosen and has no limit", part)};
    }
  }
  const bool limited = std::any_of(r.checks.begin(), r.checks.end(), [](const Check& c) { return c.limits; });
  if (!limited && !r.unjudged.empty())
    return {.passes = false, .utilisation = std::nan(""), .governs = "no limit is given for " + r.unjudged.front()};
  SizingTrial trial{.passes = true, .utilisation = 0, .governs = "no check"};
  for (const Check& c : r.checks) {
    if (std::isnan(c.utilisation) && c.passes) continue;
    double u = std::isnan(c.utilisation) ? HUGE_VAL : c.utilisation;
    if (!c.passes) trial.passes = false;
    if (!c.passes && u <= 1) u = 1 + over_of(c);
    if (u < trial.utilisation) continue;
    trial.utilisation = u;
    trial.governs = c.refused ? c.name + ", refused as unverified" : c.name;
  }
  return trial;
}

void disregard(const std::vector<std::string>& names, Result& r) {
  std::erase_if(r.checks, [&](const Check& c) {
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& name) { return c.name == name || c.name.starts_with(name + " ["); });
  });
}

std::vector<double> CheckConstraints::of(const Result& r) {
  std::vector<std::pair<std::string, double>> all;
  all.reserve(r.checks.size());
  std::map<std::string, int> met;
  for (const Check& c : r.checks) all.emplace_back(fmt::format("{}#{}", c.name, met[c.name]++), over_of(c));
  if (count_ == 0) {
    for (const auto& [name, over] : all) slots_.emplace(name, slots_.size());
    count_ = slots_.size() + 1;
  }
  std::vector<double> over(count_, -most_over);
  for (const auto& [name, value] : all) {
    const auto slot = slots_.find(name);
    double& own = over[slot == slots_.end() ? count_ - 1 : slot->second];
    own = std::max(own, value);
  }
  return over;
}

std::vector<double> CheckConstraints::nothing() const {
  return std::vector<double>(std::max<std::size_t>(count_, 1), most_over);
}

void CandidateRecord::take(const std::vector<std::size_t>& choice, const Result& r) {
  if (choice.size() < 2 || r.status != Status::ok) return;
  std::map<std::size_t, std::pair<double, std::string>> worst;
  for (const Check& c : r.checks) {
    const auto list = list_of_->find(c.part);
    if (list == list_of_->end() || c.kind == PartKind::drum || c.kind == PartKind::sheave) continue;
    const double use = 1 + over_of(c);
    const auto own = worst.try_emplace(list->second, use, c.name).first;
    if (use > own->second.first) own->second = {use, c.name};
  }
  for (const auto& [k, one] : worst) {
    Fate& own = fates_[{k, choice[k]}];
    own.least = own.trials == 0 ? one.first : std::min(own.least, one.first);
    own.most = own.trials == 0 ? one.first : std::max(own.most, one.first);
    own.governs = one.second;
    ++own.trials;
    double& changed = changed_.try_emplace(k, 1).first->second;
    if (own.least > 0) changed = std::max(changed, own.most / own.least);
  }
}

std::optional<SizingTrial> CandidateRecord::hopeless(const std::vector<std::size_t>& choice) const {
  for (std::size_t k = 0; k < choice.size() && choice.size() > 1; ++k) {
    const auto known = fates_.find({k, choice[k]});
    if (known == fates_.end() || known->second.trials < 2) continue;
    const double changed = changed_.at(k);
    if (!(known->second.least > std::max(least_margin, changed * changed))) continue;
    SizingTrial trial;
    trial.utilisation = known->second.least;
    trial.governs = known->second.governs;
    trial.skipped = true;
    return trial;
  }
  return {};
}

}  // namespace taut::design
