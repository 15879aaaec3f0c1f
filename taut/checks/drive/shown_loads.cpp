#include "taut/checks/drive/shown_loads.hpp"

#include <algorithm>

namespace taut::checks {
namespace {

/// Relative, of sums and of answers: less more than that is no other load.
constexpr double same_load = 1e-9;

bool is_more(double one, double other) { return one > (1 + same_load) * other; }

}  // namespace

double weight_of(const machine::Model& model) {
  double weight = 0;
  for (std::size_t body = 0; body < model.bodies.size(); ++body)
    weight += machine::weight_on(model, static_cast<int>(body));
  return weight;
}

void ShownLoads::show(const std::string& part, const AskedLoad& load) {
  AskedLoad& most = shown_[part];
  most = {.weight = std::max(most.weight, load.weight), .least = std::max(most.least, load.least)};
}

void ShownLoads::leave_out(const std::string& part, const AskedLoad& load, const std::string& words) {
  const auto [at, is_first] =
      left_out_.try_emplace(part, LeftOut{.most = load, .first = words, .heaviest = words, .hardest = words});
  if (is_first) return;
  LeftOut& one = at->second;
  if (is_more(load.weight, one.most.weight)) {
    one.most.weight = load.weight;
    one.heaviest = words;
  }
  if (is_more(load.least, one.most.least)) {
    one.most.least = load.least;
    one.hardest = words;
  }
}

std::map<std::string, ShownLoads::Missing> ShownLoads::missing() const {
  std::map<std::string, Missing> parts;
  for (const auto& [part, one] : left_out_) {
    const auto known = shown_.find(part);
    if (known == shown_.end()) {
      parts.emplace(part, Missing{.words = one.first, .by_less = false});
    } else if (is_more(one.most.weight, known->second.weight)) {
      parts.emplace(part, Missing{.words = one.heaviest});
    } else if (is_more(one.most.least, known->second.least)) {
      parts.emplace(part, Missing{.words = one.hardest});
    }
  }
  return parts;
}

}  // namespace taut::checks
