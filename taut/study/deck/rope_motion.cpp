#include "taut/study/deck/rope_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "taut/base/array.hpp"
#include "taut/base/suggest.hpp"
#include "taut/machine/senses.hpp"
#include "taut/solve/running.hpp"

namespace taut::study {
namespace {

const std::map<std::string, solve::Motion> motions = {{"at_rest", solve::Motion::at_rest},
                                                      {"hoist", solve::Motion::hoist},
                                                      {"lower", solve::Motion::lower},
                                                      {"in", solve::Motion::in},
                                                      {"out", solve::Motion::out}};
const std::map<std::string, int> signs = {{"1", 1}, {"+1", 1}, {"+", 1}, {"-1", -1}, {"-", -1}, {"0", 0}};

/// As words of a state have it.
std::string sense_words(const std::string& sense) { return sense == "at_rest" ? "at rest" : sense; }

bool runs_over(const machine::Node& node) {
  return node.kind == machine::NodeKind::contact || node.kind == machine::NodeKind::load;
}

/// The sense of a word or a sign; none where it is neither.
std::optional<std::variant<solve::Motion, int>> sense_of(const std::string& text) {
  if (const auto motion = motions.find(text); motion != motions.end()) return motion->second;
  if (const auto sign = signs.find(text); sign != signs.end()) return sign->second;
  return std::nullopt;
}

std::string unknown_motion(const std::string& text) {
  std::vector<std::string> senses;
  senses.reserve(motions.size());
  for (const auto& [name, sense] : motions) senses.push_back(name);
  const std::string hint = did_you_mean(text, senses);
  return fmt::format("there is no motion '{}'{}", text,
                     hint.empty() ? "; write hoist, lower, in, out, at_rest, 1, -1 or 0" : hint);
}

/// A complaint where no contact and no rope has the name.
std::optional<std::string> unknown_contact(const std::string& name, const machine::Model& model) {
  std::vector<std::string> contacts;
  for (const machine::Reeving& rope : model.reevings) {
    for (const machine::Node& node : rope.nodes) {
      if (!runs_over(node)) continue;
      if (node.name == name || rope.name == name) return std::nullopt;
      contacts.push_back(node.name);
    }
  }
  return fmt::format("there is no sheave, support or rope of this name{}", did_you_mean(name, contacts));
}

/// What a part of a request says of the contacts that it names, or of all.
void set_senses(const machine::Model& model, const machine::Senses& in, const RopeMotion::Part& part,
                solve::EquilibriumOptions& options) {
  const auto* const motion = std::get_if<solve::Motion>(&part.sense);
  const bool moves = motion != nullptr && *motion != solve::Motion::at_rest;
  for (std::size_t r = 0; r < model.reevings.size(); ++r) {
    const machine::Reeving& rope = model.reevings[r];
    for (std::size_t n = 0; n < rope.nodes.size(); ++n) {
      if (!runs_over(rope.nodes[n])) continue;
      if (!part.name.empty() && rope.nodes[n].name != part.name && rope.name != part.name) continue;
      options.flow[r][n] = motion != nullptr ? solve::sign_of(*motion) * in.flow[r][n] : std::get<int>(part.sense);
      options.creep[r][n] = moves ? in.creep[r][n] : 0;
    }
  }
}

}  // namespace

const Description& MotionRequest::describe() {
  static const Description d = Describe<MotionRequest>()
                                   .field(&MotionRequest::sense, "sense", "hoist, lower, in, out, at_rest, or a sign")
                                   .required();
  return d;
}

solve::EquilibriumOptions RopeMotion::options(const machine::Model& model) const {
  solve::EquilibriumOptions options;
  const machine::Senses in = machine::hauling_in(model);
  for (const Part& part : parts) {
    const auto* const motion = std::get_if<solve::Motion>(&part.sense);
    if (part.name.empty() && motion != nullptr) {
      options.motion = *motion;
      continue;
    }
    if (options.flow.empty()) {
      options.flow = options.creep = in.creep;
      for (auto* all : {&options.flow, &options.creep}) {
        for (Array<int>& rope : *all) std::fill(rope.begin(), rope.end(), 0);
      }
    }
    set_senses(model, in, part, options);
  }
  return options;
}

RopeMotion rope_motion(const std::vector<MotionRequest>& motion, const machine::Model& model, const DeckPlace& path,
                       std::vector<Complaint>& complaints) {
  RopeMotion all;
  if (!motion.empty()) all.words.clear();
  for (const MotionRequest& one : motion) {
    const DeckPlace at = one.name.empty() ? path : DeckPlace(path, one.name);
    if (!all.words.empty()) all.words += ", ";
    if (!one.name.empty()) all.words += one.name + " ";
    all.words += sense_words(one.sense);
    const auto sense = sense_of(one.sense);
    if (!sense) {
      complaints.push_back({at.text(), unknown_motion(one.sense)});
      continue;
    }
    if (!one.name.empty()) {
      if (auto wrong = unknown_contact(one.name, model)) complaints.push_back({at.text(), std::move(*wrong)});
    }
    all.parts.push_back({one.name, *sense});
  }
  return all;
}

RopeMotion rope_motion(solve::Motion motion) {
  const auto word = std::find_if(motions.begin(), motions.end(), [&](const auto& m) { return m.second == motion; });
  return {.parts = {{.name = "", .sense = motion}}, .words = sense_words(word->first)};
}

}  // namespace taut::study
