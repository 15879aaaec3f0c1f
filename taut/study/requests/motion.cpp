#include "taut/study/requests/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "taut/base/suggest.hpp"

namespace taut::study {
namespace {

using solve::Motion;

const std::map<std::string, solve::Motion> motions = {{"at_rest", solve::Motion::at_rest},
                                                      {"hoist", solve::Motion::hoist},
                                                      {"lower", solve::Motion::lower},
                                                      {"in", solve::Motion::in},
                                                      {"out", solve::Motion::out}};
const std::map<std::string, int> signs = {{"1", 1}, {"+1", 1}, {"+", 1}, {"-1", -1}, {"-", -1}, {"0", 0}};

/// The flow through the contacts of one rope at a motion of the whole machine.
int flow_of(solve::Motion motion, const machine::Reeving& rope) {
  if (motion == solve::Motion::at_rest) return 0;
  return motion == solve::Motion::hoist || motion == solve::Motion::in ? rope.haul : -rope.haul;
}

Array<Array<int>> flow_of(solve::Motion motion, const machine::Model& model) {
  Array<Array<int>> all;
  all.reserve(model.reevings.size());
  for (const machine::Reeving& rope : model.reevings) all.emplace_back(rope.nodes.size(), flow_of(motion, rope));
  return all;
}

}  // namespace

const Description& MotionRequest::describe() {
  static const Description d = Describe<MotionRequest>()
                                   .field(&MotionRequest::sense, "sense", "hoist, lower, in, out, at_rest, or a sign")
                                   .required();
  return d;
}

solve::EquilibriumOptions options_of(const std::vector<MotionRequest>& motion, const machine::Model& model,
                                     const std::string& path, std::vector<Complaint>& complaints) {
  solve::EquilibriumOptions options;
  std::vector<std::string> senses;
  senses.reserve(motions.size());
  for (const auto& [name, sense] : motions) senses.push_back(name);
  for (const MotionRequest& one : motion) {
    const auto named = motions.find(one.sense);
    const auto sign = signs.find(one.sense);
    const std::string at = one.name.empty() ? path : fmt::format("{}.{}", path, one.name);
    if (named == motions.end() && sign == signs.end()) {
      const std::string hint = did_you_mean(one.sense, senses);
      complaints.push_back(
          {at, fmt::format("there is no motion '{}'{}", one.sense,
                           hint.empty() ? "; write hoist, lower, in, out, at_rest, 1, -1 or 0" : hint)});
      continue;
    }
    if (one.name.empty() && named != motions.end()) {
      options.motion = named->second;
      continue;
    }
    if (options.flow.empty()) options.flow = flow_of(solve::Motion::at_rest, model);
    bool found = false;
    std::vector<std::string> contacts;
    for (std::size_t r = 0; r < model.reevings.size(); ++r) {
      const machine::Reeving& rope = model.reevings[r];
      for (std::size_t n = 0; n < rope.nodes.size(); ++n) {
        const machine::NodeKind kind = rope.nodes[n].kind;
        if (kind != machine::NodeKind::contact && kind != machine::NodeKind::load) continue;
        contacts.push_back(rope.nodes[n].name);
        if (!one.name.empty() && rope.nodes[n].name != one.name && rope.name != one.name) continue;
        options.flow[r][n] = sign != signs.end() ? sign->second : flow_of(named->second, rope);
        found = true;
      }
    }
    if (found || one.name.empty()) continue;
    complaints.push_back(
        {at, fmt::format("there is no sheave, support or rope of this name{}", did_you_mean(one.name, contacts))});
  }
  return options;
}

std::string words_of(const std::vector<MotionRequest>& motion) {
  std::string words;
  for (const MotionRequest& one : motion) {
    words += fmt::format("{}{}{}", words.empty() ? "" : ", ", one.name.empty() ? "" : one.name + " ",
                         one.sense == "at_rest" ? "at rest" : one.sense);
  }
  return words.empty() ? "at rest" : words;
}

}  // namespace taut::study
