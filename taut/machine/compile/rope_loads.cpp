#include "taut/machine/compile/rope_loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "taut/base/array.hpp"
#include "taut/base/suggest.hpp"
#include "taut/machine/links/signals_of.hpp"
#include "taut/machine/rounds.hpp"
#include "taut/rope/tangent.hpp"

namespace taut::machine {
namespace {

using description::RopeLoadDirection;
using GivenLoad = description::RopeLoad;

constexpr int most_elements = 16;  ///< by themselves; the error goes with the square of a part's length
constexpr double elements_per_span = 32;
constexpr double nearest = 1e-6;  ///< share between two loads

const std::string* name_of(const description::PathElement& e) {
  for (const auto* name : {&e.anchor, &e.over, &e.through, &e.drum}) {
    if (*name) return &**name;
  }
  return nullptr;
}

/// One point of the rope with its load.
RopeLoad load_of(const GivenLoad& given, bool reversed) {
  RopeLoad load;
  load.force = given.tangential.value_or(0);
  load.open = !given.tangential && !given.rate;
  const bool against = given.direction == RopeLoadDirection::against_motion ||  //
                       given.direction == RopeLoadDirection::against_path;
  load.sense = against ? -1 : 1;
  load.by_motion =
      given.direction == RopeLoadDirection::against_motion || given.direction == RopeLoadDirection::with_motion;
  load.share = given.position.value_or(0.5);
  if (reversed) load.share = 1 - load.share;
  return load;
}

Array<RopeLoad> loads_of(const GivenLoad& given, bool reversed) {
  RopeLoad load = load_of(given, reversed);
  if (!given.rate) return {load};
  double from = given.from.value_or(0), to = given.to.value_or(1);
  const int usual = std::clamp(static_cast<int>(std::ceil(elements_per_span * (to - from))), 1, most_elements);
  const int n = given.elements.value_or(usual);
  if (reversed) std::tie(from, to) = std::pair(1 - to, 1 - from);
  load.rate = *given.rate;
  load.part = (to - from) / n;
  Array<RopeLoad> all;
  for (int i = 0; i < n; ++i) {
    load.share = from + (i + 0.5) * load.part;
    all.push_back(load);
  }
  return all;
}

/// The straight rope between two nodes.
std::pair<Vector3, Vector3> line_between(const Model& model, const Node& a, const Node& b) {
  const rope::Round from = round_at(model, a), to = round_at(model, b);
  if (const auto line = rope::tangent_line(from, to)) return {line->from, line->to};
  return {from.centre, to.centre};
}

/// A span of a path: the indices of its two ends among the nodes; with loads already between them.
struct Span {
  std::size_t from = 0, to = 0;
  bool reversed = false;
};

Array<std::size_t> stops_of(const Reeving& reeving) {
  Array<std::size_t> stops;
  for (std::size_t n = 0; n < reeving.nodes.size(); ++n) {
    if (reeving.nodes[n].kind != NodeKind::load) stops.push_back(n);
  }
  return stops;
}

Array<Span> spans_between(const Reeving& reeving, const std::string& first, const std::string& second) {
  const Array<std::size_t> stops = stops_of(reeving);
  Array<Span> along, against;
  const std::size_t count = reeving.closed ? stops.size() : stops.size() - 1;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t a = stops[k], b = stops[(k + 1) % stops.size()];
    const std::string &from = reeving.nodes[a].name, &to = reeving.nodes[b].name;
    if (from == first && to == second) along.push_back({a, b, false});
    if (from == second && to == first) against.push_back({a, b, true});
  }
  return along.empty() ? against : along;
}

std::string path_words(const Reeving& reeving) {
  std::string words;
  for (const std::size_t n : stops_of(reeving)) {
    words += fmt::format("{}'{}'", words.empty() ? "" : ", ", reeving.nodes[n].name);
  }
  return words;
}

class Adder {
 public:
  Adder(const Machine& machine, Model& model, std::vector<Complaint>& complaints)
      : machine_(machine), model_(model), complaints_(complaints) {}

  void add(std::size_t i) {
    const GivenLoad& given = machine_.rope_loads[i];
    const std::string path = fmt::format("rope_loads[{}]", i);
    const auto at = std::find_if(model_.reevings.begin(), model_.reevings.end(),
                                 [&](const Reeving& one) { return one.name == given.rope; });
    if (at == model_.reevings.end()) return;
    const auto spans = spans_between(*at, given.between[0], given.between[1]);
    if (spans.size() != 1) {
      const std::string why = spans.empty() ? fmt::format("are no neighbours on it: {}", path_words(*at))
                                            : fmt::format("are neighbours {} times", spans.size());
      complaints_.push_back({path + ".between", fmt::format("'{}' and '{}' on the path of '{}' {}", given.between[0],
                                                            given.between[1], given.rope, why)});
      return;
    }
    const auto reeving = static_cast<std::size_t>(at - model_.reevings.begin());
    check_motor(given, model_.reevings[reeving], path);
    Array<RopeLoad> loads = loads_of(given, spans[0].reversed);
    add_signal(given, loads, path);
    const std::string name = unused(given.name.value_or(given.rope + ".load"));
    for (std::size_t k = 0; k < loads.size(); ++k) {
      // in the deck's order of counting
      const std::size_t number = spans[0].reversed ? loads.size() - k : k + 1;
      insert(reeving, given, loads[k], loads.size() == 1 ? name : fmt::format("{}[{}]", name, number), path);
    }
  }

 private:
  void add_signal(const GivenLoad& given, Array<RopeLoad>& loads, const std::string& path) {
    if (!given.signal) return;
    if (!given.tangential && !given.rate) {
      complaints_.push_back({path + ".signal", "needs 'tangential' or 'rate' beside it, for what is at rest"});
      return;
    }
    if (signals_.empty()) signals_ = signals_of(machine_, complaints_);
    const Unit& unit = given.rate ? si::N_per_m : si::N;
    const auto signal = signal_or_constant(*given.signal, unit, signals_, path + ".signal", complaints_);
    for (RopeLoad& load : loads) load.signal = signal;
  }

  void check_motor(const GivenLoad& given, const Reeving& reeving, const std::string& path) {
    if (given.tangential || given.rate) return;
    const bool driven =
        reeving.closed && reeving.given == machine::Given::length && reeving.nodes.front().tension_drop.has_value();
    const bool another = std::any_of(reeving.nodes.begin(), reeving.nodes.end(),
                                     [](const Node& n) { return n.kind == NodeKind::load && n.load.open; });
    if (!driven || another) {
      complaints_.push_back({path,
                             "needs 'tangential' or 'rate'; one load of an endless rope with a given length may go "
                             "without, where its motor has a 'torque' to overcome it"});
    }
  }

  /// The name, or with a number where another load has it.
  std::string unused(const std::string& wanted) const {
    const auto known = [&](const std::string& name) {
      return std::any_of(model_.bodies.begin(), model_.bodies.end(),
                         [&](const Body& body) { return body.name == name || body.name == name + "[1]"; });
    };
    std::string name = wanted;
    for (int i = 2; known(name); ++i) name = fmt::format("{}_{}", wanted, i);
    return name;
  }

  /// Between the nodes of its span, in the order of the shares.
  void insert(std::size_t reeving, const GivenLoad& given, const RopeLoad& load, const std::string& name,
              const std::string& path) {
    Reeving& rope = model_.reevings[reeving];
    const Span span = spans_between(rope, given.between[0], given.between[1]).front();
    std::size_t at = span.from + 1;
    while (at < rope.nodes.size() && at != span.to && rope.nodes[at].load.share < load.share) ++at;
    const auto near = [&](std::size_t n) {
      return n < rope.nodes.size() && rope.nodes[n].kind == NodeKind::load &&
             std::abs(rope.nodes[n].load.share - load.share) < nearest;
    };
    if (near(at) || near(at - 1)) {
      complaints_.push_back({path, "another load acts at the same place of the span: add them, or move one"});
      return;
    }
    const auto [from, to] = line_between(model_, rope.nodes[span.from], rope.nodes[span.to]);
    Body body;
    body.name = name;
    body.of_rope = true;
    body.position = from + load.share * (to - from);
    for (const Vector3& way : {Vector3(Vector3::UnitX()), Vector3(Vector3::UnitY()), Vector3(Vector3::UnitZ())}) {
      body.free.push_back({way, Vector3::Zero()});
    }
    Node node;
    node.name = name;
    node.kind = NodeKind::load;
    node.at.body = static_cast<int>(model_.bodies.size());
    node.load = load;
    model_.bodies.push_back(std::move(body));
    rope.nodes.insert(rope.nodes.begin() + static_cast<std::ptrdiff_t>(at), std::move(node));
    for (Carriage& car : model_.carriages) {
      if (car.reeving == static_cast<int>(reeving) && car.node >= static_cast<int>(at)) ++car.node;
      const bool grips = car.grip && car.grip->reeving == static_cast<int>(reeving);
      if (grips && car.grip->node >= static_cast<int>(at)) ++car.grip->node;
    }
  }

  const Machine& machine_;
  Model& model_;
  std::vector<Complaint>& complaints_;
  Array<Signal> signals_;
};

void check_amounts(const GivenLoad& given, const std::string& path, std::vector<Complaint>& complaints) {
  const auto complain = [&](const char* key, const char* words) { complaints.push_back({path + key, words}); };
  if (given.tangential && given.rate) complain("", "either 'tangential' or 'rate', not both");
  if (given.rate && given.position)
    complain(".position", "belongs to a 'tangential' force; a rate has 'from' and 'to'");
  if (!given.rate && given.from) complain(".from", "belongs to a 'rate'; a single force has a 'position'");
  if (!given.rate && given.to) complain(".to", "belongs to a 'rate'; a single force has a 'position'");
  if (!given.rate && given.elements) complain(".elements", "belongs to a 'rate'");
  if (given.from.value_or(0) >= given.to.value_or(1)) complain("", "'from' has to be less than 'to'");
}

}  // namespace

void check_rope_loads(const Machine& machine, std::vector<Complaint>& complaints) {
  if (machine.rope_loads.empty()) return;
  std::vector<std::string> names;
  names.reserve(machine.reevings.size());
  for (const auto& one : machine.reevings) names.push_back(name_of(one));
  for (std::size_t i = 0; i < machine.rope_loads.size(); ++i) {
    const GivenLoad& given = machine.rope_loads[i];
    const std::string path = fmt::format("rope_loads[{}]", i);
    check_amounts(given, path, complaints);
    if (given.between.size() != 2 || given.between[0] == given.between[1]) {
      complaints.push_back(
          {path + ".between", "two neighbours of the rope's path are expected, such as [drive, idler]"});
    }
    const auto at = std::find(names.begin(), names.end(), given.rope);
    if (at == names.end()) {
      complaints.push_back(
          {path + ".rope", fmt::format("there is no reeving '{}'{}", given.rope, did_you_mean(given.rope, names))});
      continue;
    }
    std::vector<std::string> stops;
    for (const auto& e : machine.reevings[static_cast<std::size_t>(at - names.begin())].path) {
      if (const std::string* name = name_of(e)) stops.push_back(*name);
      stops.insert(stops.end(), e.between.begin(), e.between.end());
    }
    for (const std::string& name : given.between) {
      if (std::find(stops.begin(), stops.end(), name) != stops.end()) continue;
      complaints.push_back({path + ".between", fmt::format("the path of '{}' has no '{}'{}", given.rope, name,
                                                           did_you_mean(name, stops))});
    }
  }
}

void add_rope_loads(const Machine& machine, Model& model, std::vector<Complaint>& complaints) {
  Adder adder(machine, model, complaints);
  for (std::size_t i = 0; i < machine.rope_loads.size(); ++i) adder.add(i);
}

}  // namespace taut::machine
