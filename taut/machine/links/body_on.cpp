#include "taut/machine/links/body_on.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "taut/base/array.hpp"
#include "taut/base/suggest.hpp"

namespace taut::machine {
namespace {

/// Driven by more than constants, which only say where it stands.
bool is_moved(const Body& body) {
  return std::any_of(body.driven.begin(), body.driven.end(),
                     [](const DrivenWay& way) { return !std::holds_alternative<double>(way.signal.law); });
}

/// The body that each one is on; empty: on none, or on one that can't be.
Array<std::optional<int>> parents_of(const Machine& machine, const Model& model, std::vector<Complaint>& complaints) {
  std::vector<std::string> names;
  names.reserve(machine.bodies.size());
  for (const auto& body : machine.bodies) names.push_back(body.name);
  Array<std::optional<int>> parents(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto& given = machine.bodies[i];
    if (!given.on) continue;
    const std::string path = fmt::format("bodies.{}.on", given.name);
    const auto found = std::find(names.begin(), names.end(), *given.on);
    if (found == names.end()) {
      complaints.push_back({path, fmt::format("there is no body '{}'{}", *given.on, did_you_mean(*given.on, names))});
      continue;
    }
    parents[i] = static_cast<int>(found - names.begin());
    if (given.motion) {
      complaints.push_back({path, "a driven body has its place in the ground frame"});
    }
    const bool stays = !given.guide && std::none_of(given.free.begin(), given.free.end(),
                                                    [](const std::string& way) { return way.front() != 'r'; });
    if (stays && is_moved(model.bodies[*parents[i]])) {
      complaints.push_back(
          {path, fmt::format("'{}' has a 'motion', and '{}' would stay behind: 'on' gives its place at the start, no "
                             "joint. Give it the same 'motion', or 'free' ways and what holds it",
                             *given.on, given.name)});
    }
    const auto joined = [&](const auto& beam) { return beam.from == given.name || beam.to == given.name; };
    if (std::any_of(machine.beams.begin(), machine.beams.end(), joined)) {
      complaints.push_back({path, "a beam is joined to this body: give its place in the ground frame"});
    }
  }
  return parents;
}

}  // namespace

void place_bodies_on_others(const Machine& machine, Model& model, std::vector<Complaint>& complaints) {
  const auto parents = parents_of(machine, model, complaints);
  enum class Now { open, under_way, done };
  Array<Now> now(parents.size(), Now::open);
  for (std::size_t first = 0; first < parents.size(); ++first) {
    // up to a body that stands, then down again
    Array<std::size_t> chain;
    for (std::optional i = static_cast<int>(first); i && now[*i] != Now::done; i = parents[*i]) {
      const auto k = static_cast<std::size_t>(*i);
      if (now[k] == Now::under_way) {
        complaints.push_back(
            {fmt::format("bodies.{}.on", machine.bodies[k].name), "the bodies stand on each other in a circle"});
        return;
      }
      now[k] = Now::under_way;
      chain.push_back(k);
    }
    std::reverse(chain.begin(), chain.end());
    for (const std::size_t i : chain) {
      now[i] = Now::done;
      if (!parents[i]) continue;
      const Body& under = model.bodies[*parents[i]];
      Body& body = model.bodies[i];
      body.position = under.position + under.orientation * body.position;
      body.orientation = under.orientation * body.orientation;
      for (Freedom& way : body.free) {
        way.along = under.orientation * way.along;
        way.about = under.orientation * way.about;
      }
    }
  }
}

}  // namespace taut::machine
