#include "taut/machine/compile/guides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/base/number.hpp"
#include "taut/base/suggest.hpp"

namespace taut::machine {
namespace {

constexpr double on_guide = 1e-6;  ///< m: nearer, a carriage is on neither side of a guide
constexpr double no_angle = 1e-6;  ///< cosine: a direction across the line tells no side
constexpr const char* ahead_word = "ahead_of";

/// A text in two words; the second may be empty.
struct TwoWords {
  std::string first, second;
};

TwoWords two_words(const std::string& text) {
  const auto from = text.find_first_not_of(" \t");
  if (from == std::string::npos) return {};
  const auto end = std::min(text.find_first_of(" \t", from), text.size());
  const auto next = text.find_first_not_of(" \t", end);
  if (next == std::string::npos) return {.first = text.substr(from, end - from), .second = {}};
  return {.first = text.substr(from, end - from), .second = text.substr(next, text.find_last_not_of(" \t") + 1 - next)};
}

void check_round(const Machine& machine, const char* list, const description::Round& round,
                 std::vector<Complaint>& complaints) {
  if (!round.holds || ahead_of(machine, round)) return;
  const TwoWords words = two_words(*round.holds);
  const std::string path = fmt::format("{}.{}.holds", list, round.name);
  if (words.first == "behind") {
    complaints.push_back({path, fmt::format("write '{} CARRIAGE': ahead is towards where the rope comes from, for a "
                                            "mainline as for a haulback",
                                            ahead_word)});
    return;
  }
  if (words.first != ahead_word || words.second.empty()) {
    complaints.push_back({path, fmt::format("'{}' is not understood: write '{} CARRIAGE', with the carriage at which "
                                            "its rope ends",
                                            *round.holds, ahead_word)});
    return;
  }
  std::vector<std::string> known;
  known.reserve(machine.carriages.size());
  for (const auto& car : machine.carriages) known.push_back(car.name);
  complaints.push_back(
      {path, fmt::format("there is no carriage '{}'{}", words.second, did_you_mean(words.second, known))});
}

/// Indices of the stops from the first guide to the last one, counted from what the rope comes from; `far`: that.
struct Run {
  Array<std::size_t> guides;
  std::size_t far = 0;
};

/// The run of guides beside one end of a path.
Run run_at(const Array<Stop>& stops, bool at_end, int first_carriage) {
  Run run;
  const std::size_t count = stops.size();
  const auto stop = [&](std::size_t k) { return at_end ? count - 1 - k : k; };
  const int car = stops[stop(0)].node.at.body - first_carriage;
  std::size_t k = 1;
  while (k + 1 < count && stops[stop(k)].ahead_of && stops[stop(k)].ahead_of->carriage == car) ++k;
  run.far = stop(k);
  while (k-- > 1) run.guides.push_back(stop(k));
  return run;
}

Vector3 in_plan(const Vector3& v) { return {v.x(), v.y(), 0}; }

/// Complains of guides of which one lies behind the next one, seen from where the rope comes from.
bool in_order(const Run& run, const Array<Stop>& stops, const Array<Vector3>& places, const Vector3& away,
              std::vector<Complaint>& complaints) {
  std::size_t before = run.far;
  for (const std::size_t k : run.guides) {
    const double step = away.dot(places[k] - places[before]);
    if (step < 0 || (step == 0 && before != run.far)) {
      complaints.push_back(
          {stops[k].ahead_of->path,
           fmt::format("'{}' does not lie beyond '{}' as seen along the path: guides that the carriage "
                       "passes stand in the path in the order in which it passes them",
                       stops[k].node.name, stops[before].node.name)});
      return false;
    }
    before = k;
  }
  return true;
}

const Node& carriage_end(const Reeving& rope, const Guides& guides) {
  return guides.at_end ? rope.nodes.back() : rope.nodes.front();
}

/// Where a node stands at the start.
Vector3 starts_at(const Model& model, const Node& node) {
  if (node.at.body == ground) return node.at.at;
  const Body& body = model.bodies[node.at.body];
  return body.position + body.orientation * node.at.at;
}

/// Puts the first `held` guides into the path, in place of those that are in it.
void put(Model& model, int reeving, Guides& guides, int held) {
  Array<Node>& nodes = model.reevings[reeving].nodes;
  const auto count = static_cast<std::ptrdiff_t>(guides.all.size());
  const auto old_first = guides.at_end ? nodes.end() - 1 - guides.held : nodes.begin() + 1;
  const auto at = nodes.erase(old_first, old_first + guides.held);
  const auto first = guides.at_end ? guides.all.begin() : guides.all.begin() + (count - held);
  nodes.insert(at, first, first + held);
  if (!guides.at_end) {
    const int shift = held - guides.held;
    for (Carriage& car : model.carriages) {
      if (car.reeving == reeving) car.node += shift;
      if (car.grip && car.grip->reeving == reeving) car.grip->node += shift;
    }
  }
  guides.held = held;
}

/// The guide number k, counted from where the rope comes from.
const Node& guide_number(const Guides& guides, int k) {
  const auto count = static_cast<int>(guides.all.size());
  return guides.all[guides.at_end ? k : count - 1 - k];
}

/// How many hold a rope whose end is at this coordinate along `away`.
int held_at(const Model& model, const Guides& guides, double coordinate) {
  int held = 0;
  while (held < static_cast<int>(guides.all.size()) &&
         coordinate > guides.away.dot(starts_at(model, guide_number(guides, held)))) {
    ++held;
  }
  return held;
}

template <class Change>
void each_guides(Model& model, const Change& change) {
  for (std::size_t r = 0; r < model.reevings.size(); ++r) {
    for (Guides& guides : model.reevings[r].guides)
      change(static_cast<int>(r), carriage_end(model.reevings[r], guides).at.body, guides);
  }
}

}  // namespace

std::optional<int> ahead_of(const Machine& machine, const description::Round& round) {
  if (!round.holds) return std::nullopt;
  const TwoWords words = two_words(*round.holds);
  if (words.first != ahead_word) return std::nullopt;
  const auto& cars = machine.carriages;
  const auto car = std::find_if(cars.begin(), cars.end(), [&](const auto& one) { return one.name == words.second; });
  if (car == cars.end()) return std::nullopt;
  return static_cast<int>(car - cars.begin());
}

void check_holds(const Machine& machine, std::vector<Complaint>& complaints) {
  for (const auto& round : machine.sheaves) check_round(machine, "sheaves", round, complaints);
  for (const auto& round : machine.supports) check_round(machine, "supports", round, complaints);
}

Array<Guides> guides_of(const Array<Stop>& stops, const Array<Vector3>& places, CarriageBodies carriages,
                        std::vector<Complaint>& complaints) {
  Array<Guides> all;
  const auto flagged = std::count_if(stops.begin(), stops.end(), [](const Stop& s) { return s.ahead_of.has_value(); });
  if (flagged == 0) return all;
  std::size_t found = 0;
  for (const bool at_end : {false, true}) {
    const Run run = run_at(stops, at_end, carriages.first);
    if (run.guides.empty()) continue;
    found += run.guides.size();
    const Stop& last = stops[run.guides.back()];
    const Vector3 way = in_plan(places[run.guides.back()] - places[run.far]);
    if (carriages.contains(stops[run.far].node.at.body) || way.norm() == 0) {
      complaints.push_back({last.ahead_of->path,
                            fmt::format("'{}' and '{}', from where its rope comes, lie at one place in plan or on a "
                                        "carriage: what is ahead of the carriage is not known",
                                        last.node.name, stops[run.far].node.name)});
      continue;
    }
    Guides guides{.all = {}, .at_end = at_end, .held = static_cast<int>(run.guides.size()), .away = way.normalized()};
    if (!in_order(run, stops, places, guides.away, complaints)) continue;
    for (const std::size_t k : run.guides) guides.all.push_back(stops[k].node);
    if (!at_end) std::reverse(guides.all.begin(), guides.all.end());
    all.push_back(std::move(guides));
  }
  if (static_cast<std::size_t>(flagged) == found) return all;
  for (const Stop& stop : stops) {
    if (!stop.ahead_of) continue;
    complaints.push_back({stop.ahead_of->path,
                          fmt::format("'{}' holds a rope that ends at its carriage, and stands in the path beside that "
                                      "end, with nothing but such guides between: {{anchor: CARRIAGE}}",
                                      stop.node.name)});
    break;
  }
  return all;
}

void release_guides(Model& model, int body) {
  each_guides(model, [&](int reeving, int end, Guides& guides) {
    if (end == body) put(model, reeving, guides, 0);
  });
}

void hold_guides(Model& model, int body, double x, const Vector3& along) {
  each_guides(model, [&](int reeving, int end, Guides& guides) {
    if (end != body) return;
    const double share = guides.away.dot(along);
    if (std::abs(share) < no_angle) {
      put(model, reeving, guides, held_at(model, guides, guides.away.dot(model.bodies[body].position)));
      return;
    }
    guides.away = share > 0 ? along : Vector3(-along);
    put(model, reeving, guides, held_at(model, guides, share > 0 ? x : -x));
  });
}

Model with_guides_at_start(Model model) {
  each_guides(model, [&](int reeving, int end, Guides& guides) {
    put(model, reeving, guides, held_at(model, guides, guides.away.dot(model.bodies[end].position)));
  });
  return model;
}

Model with_guides_at(Model model, const State& state) {
  each_guides(model, [&](int reeving, int end, Guides& guides) {
    put(model, reeving, guides, held_at(model, guides, guides.away.dot(state.bodies[end].position)));
  });
  return model;
}

bool same_guides(const Model& a, const Model& b) {
  for (std::size_t r = 0; r < a.reevings.size(); ++r) {
    for (std::size_t g = 0; g < a.reevings[r].guides.size(); ++g) {
      if (a.reevings[r].guides[g].held != b.reevings[r].guides[g].held) return false;
    }
  }
  return true;
}

Array<PlacedGuide> guides_ahead_of(const Model& model, int carriage) {
  Array<PlacedGuide> all;
  for (const Reeving& rope : model.reevings) {
    for (const Guides& guides : rope.guides) {
      if (carriage_end(rope, guides).at.body != model.carriages[carriage].body) continue;
      for (const Node& node : guides.all) all.push_back({.node = &node, .place = starts_at(model, node)});
    }
  }
  return all;
}

std::string misplaced_guide(const Model& model, const Array<Pose>& bodies) {
  for (const Reeving& rope : model.reevings) {
    for (const Guides& guides : rope.guides) {
      const int body = carriage_end(rope, guides).at.body;
      const double coordinate = guides.away.dot(bodies[body].position);
      const int held = held_at(model, guides, coordinate);
      const int wrong = held == guides.held ? -1 : std::min(held, guides.held);
      if (wrong < 0) continue;
      const Node& node = guide_number(guides, wrong);
      const std::string& car = model.bodies[body].name;
      const bool on = std::abs(coordinate - guides.away.dot(starts_at(model, node))) <= on_guide;
      return fmt::format(
          "carriage '{}' comes to rest at x = {} m, {} '{}', which was taken to {} ('holds: ahead_of {}'): put the "
          "carriage somewhere with 'carriage' and 'x', or give '{}' another length",
          car, place_number(bodies[body].position.x() + model.origin.x()),
          on                   ? "at"
          : held > guides.held ? "beyond"
                               : "before",
          node.name,
          held > guides.held ? fmt::format("be passed and not to hold '{}'", rope.name)
                             : fmt::format("hold '{}'", rope.name),
          car, rope.name);
    }
  }
  return {};
}

}  // namespace taut::machine
