#include "taut/app/absurd.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "taut/calc/shown.hpp"
#include "taut/machine/rounds.hpp"
#include "taut/machine/state.hpp"
#include "taut/rope/tangent.hpp"

namespace taut::app {
namespace {

bool in_a_name(char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0; }

/// Calls `f` with each word of a text: "car" and "z" of "car.z".
template <class F>
void for_each_word(std::string_view text, const F& f) {
  for (std::size_t i = 0; i < text.size();) {
    if (!in_a_name(text[i])) {
      ++i;
      continue;
    }
    const std::size_t first = i;
    while (i < text.size() && in_a_name(text[i])) ++i;
    f(text.substr(first, i - first));
  }
}

/// Whether a text holds a name with nothing of a word before and behind it: "first car" in "first car.z".
bool mentions(std::string_view text, std::string_view name) {
  for (std::size_t i = text.find(name); i != std::string_view::npos; i = text.find(name, i + 1)) {
    const std::size_t end = i + name.size();
    if ((i == 0 || !in_a_name(text[i - 1])) && (end == text.size() || !in_a_name(text[end]))) return true;
  }
  return false;
}

/// Every text of a deck that may name a part of the machine, and where it stands.
class Mentions {
 public:
  explicit Mentions(const MachineDeck& deck) : given_(given_of(MachineDeck::describe(), &deck)) {
    for (const Given& one : given_) {
      for_each_word(one.text, [&](std::string_view word) { by_word_[word].push_back(&one); });
      if (names_by_key(one)) for_each_word(one.key, [&](std::string_view word) { by_word_[word].push_back(&one); });
    }
  }

  /// `list`: where the part is described itself.
  bool of(std::string_view list, const std::string& name) const {
    const std::string own = fmt::format("machine.{}.{}.", list, name);
    const auto elsewhere = [&](const Given& one) { return !one.key.starts_with(own); };
    if (std::all_of(name.begin(), name.end(), in_a_name)) {
      const auto found = by_word_.find(name);
      return found != by_word_.end() &&
             std::any_of(found->second.begin(), found->second.end(), [&](const Given* one) { return elsewhere(*one); });
    }
    return std::any_of(given_.begin(), given_.end(), [&](const Given& one) {
      return elsewhere(one) && (mentions(one.text, name) || (names_by_key(one) && mentions(one.key, name)));
    });
  }

 private:
  static bool names_by_key(const Given& one) { return !one.key.starts_with("machine."); }

  std::vector<Given> given_;
  std::unordered_map<std::string_view, std::vector<const Given*>> by_word_;
};

template <class Parts>
void add_unused(const Mentions& all, const char* list, const char* kind, const char* what, const Parts& parts,
                std::vector<std::string>& warnings) {
  for (const auto& part : parts) {
    if (all.of(list, part.name)) continue;
    warnings.push_back(fmt::format("{} '{}' {}: name it where it belongs, or take it away", kind, part.name, what));
  }
}

using NodePlaces = std::vector<const machine::Node*>;

bool rests(const machine::Model& model, const machine::Node& node) {
  if (node.at.body == machine::ground) return true;
  const machine::Body& body = model.bodies[node.at.body];
  return body.free.empty() && body.driven.empty();
}

bool on_carriage(const machine::Model& model, const machine::Node& node) {
  return std::any_of(model.carriages.begin(), model.carriages.end(),
                     [&](const machine::Carriage& car) { return car.body == node.at.body; });
}

/// The nodes of a rope but those that run along it.
NodePlaces stops_of_rope(const machine::Model& model, const machine::Reeving& rope) {
  NodePlaces stops;
  for (const machine::Node& node : rope.nodes) {
    const bool end = &node == &rope.nodes.front() || &node == &rope.nodes.back();
    const bool runs = node.kind == machine::NodeKind::load || (on_carriage(model, node) && !end);
    if (!runs) stops.push_back(&node);
  }
  return stops;
}

/// The straight way of a rope with ends, arcs counted, m; empty where it depends on the answer.
std::optional<double> straight_way(const machine::Model& model, const machine::State& state,
                                   const machine::Reeving& rope) {
  const NodePlaces stops = stops_of_rope(model, rope);
  if (!std::all_of(stops.begin(), stops.end(), [&](const machine::Node* node) { return rests(model, *node); }))
    return {};
  double way = 0;
  std::optional<rope::TangentLine> last;
  for (std::size_t k = 1; k < stops.size(); ++k) {
    const auto line = rope::tangent_line(round_at(state, *stops[k - 1]), round_at(state, *stops[k]));
    if (!line) return {};
    way += line->length;
    if (last) {
      double wrap = rope::wrap_angle(stops[k - 1]->side, last->angle_to, line->angle_from);
      if (wrap >= 1.5 * std::numbers::pi) wrap -= 2 * std::numbers::pi;  // as in a state's beginning
      way += stops[k - 1]->radius * (wrap + 2 * std::numbers::pi * stops[k - 1]->turns);
    }
    last = *line;
  }
  return way;
}

void add_short_ropes(const machine::Model& model, const Display& display, std::vector<std::string>& warnings) {
  const machine::State state = machine::initial_state(model);
  for (const machine::Reeving& rope : model.reevings) {
    if (rope.closed || rope.put_up || rope.given != machine::Given::length || std::isinf(rope.stiffness)) continue;
    const auto way = straight_way(model, state, rope);
    const double length = rope.value * (1 + rope.thermal_strain);
    if (!way || !(length < *way)) continue;
    const auto [is, needs] = brief_apart(length, *way, si::m, display);
    warnings.push_back(
        fmt::format("rope '{}' is shorter than its way: {} of rope for {} from '{}' to '{}'; it has to stretch by "
                    "{:.3g} %, which takes {}",
                    rope.name, is, needs, rope.nodes.front().name, rope.nodes.back().name, 100 * (*way / length - 1),
                    display.brief(rope.stiffness * (*way / length - 1), si::N)));
  }
}

/// A rope that lies in the plane z = 0 without a round that lies there too.
bool lies_flat(const machine::Model& model, const machine::State& state, const machine::Reeving& rope) {
  std::vector<double> y;
  for (const machine::Node* node : stops_of_rope(model, rope)) {
    if (node->radius > 0 && std::abs(round_at(state, *node).axis.z()) > M_SQRT1_2) return false;
    if (on_carriage(model, *node)) continue;  // its place follows from its line
    const Vector3 place = machine::in_ground(state, node->at);
    if (place.z() != 0) return false;
    if (rests(model, *node)) y.push_back(place.y());
  }
  return y.size() >= 2 && std::any_of(y.begin(), y.end(), [&](double one) { return one != y.front(); });
}

void add_flat_ropes(const machine::Model& model, std::vector<std::string>& warnings) {
  if (model.gravity == 0) return;
  const machine::State state = machine::initial_state(model);
  std::string names;
  for (const machine::Reeving& rope : model.reevings) {
    if (lies_flat(model, state, rope)) names += fmt::format("{}'{}'", names.empty() ? "" : ", ", rope.name);
  }
  if (names.empty()) return;
  warnings.push_back(fmt::format("z is 0 everywhere and y is used along {}: z is up, weights pull along -z", names));
}

/// A span, from one stop of a rope to the next one.
struct DeepSag {
  double share = 0.5;  ///< sag/span
  double sag = 0, span = 0;
  std::string rope, from, to, state;
};

/// A part of a rope between two of its stops.
struct Stops {
  const machine::Reeving& rope;
  const machine::Node& from;
  const machine::Node& to;
};

void note(DeepSag& worst, double sag, double span, const Stops& stops, const std::string& state) {
  if (!(span > 0) || !(sag > worst.share * span)) return;
  worst = {.share = sag / span,
           .sag = sag,
           .span = span,
           .rope = stops.rope.name,
           .from = stops.from.name,
           .to = stops.to.name,
           .state = state};
}

void note_spans(const results::Answer& answer, DeepSag& worst) {
  for (const solve::BranchResult& branch : answer.result->branches) {
    const machine::Reeving& rope = answer.model->reevings[branch.reeving];
    note(worst, branch.sag, branch.chord, {.rope = rope, .from = rope.nodes[branch.from], .to = rope.nodes[branch.to]},
         answer.words);
  }
}

/// Carriages below the line between the stops of their rope.
void note_carriages(const results::Answer& answer, DeepSag& worst) {
  const machine::State& state = answer.result->state;
  for (const machine::Carriage& car : answer.model->carriages) {
    const machine::Reeving& rope = answer.model->reevings[car.reeving];
    const int count = static_cast<int>(rope.nodes.size());
    const auto next = [&](int step) -> const machine::Node* {
      for (int k = 1; k < count; ++k) {
        const int n = car.node + k * step;
        if (!rope.closed && (n < 0 || n >= count)) return nullptr;
        const machine::Node& node = rope.nodes[(n + count) % count];
        if (!on_carriage(*answer.model, node)) return rests(*answer.model, node) ? &node : nullptr;
      }
      return nullptr;
    };
    const machine::Node *before = next(-1), *after = next(1);
    if (before == nullptr || after == nullptr) continue;
    const Vector3 from = machine::in_ground(state, before->at), chord = machine::in_ground(state, after->at) - from;
    const Vector3 place = state.bodies[car.body].position - from;
    const double level = chord.head<2>().norm();
    if (!(level > 0)) continue;
    const double part = place.head<2>().dot(chord.head<2>()) / (level * level);
    note(worst, part * chord.z() - place.z(), chord.norm(), {.rope = rope, .from = *before, .to = *after},
         answer.words);
  }
}

bool has_motion(const MachineDeck& deck) {
  return std::any_of(deck.analyses.begin(), deck.analyses.end(),
                     [](const study::AnalysisRequest& one) { return one.transient.has_value(); });
}

/// What happens and is recorded in motions only, in a deck without one: its states know nothing of it.
void add_motionless(const MachineDeck& deck, std::vector<std::string>& warnings) {
  if (has_motion(deck)) return;
  const auto warn = [&](bool given, const char* key) {
    if (given)
      warnings.push_back(fmt::format("'{}' belongs to motions, and no analysis of the deck is a 'transient'", key));
  };
  warn(!deck.machine.events.empty(), "events");
  warn(!deck.machine.observe.empty(), "observe");
}

/// A temperature of a rope or beam by itself says nothing: what counts is the difference to that of the machine.
void add_references(const machine::Machine& machine, std::vector<std::string>& warnings) {
  if (machine.temperature) return;
  std::string names;
  const auto add = [&](const auto& one) {
    if (one.reference_temperature) names += fmt::format("{}'{}'", names.empty() ? "" : ", ", one.name);
  };
  std::for_each(machine.ropes.begin(), machine.ropes.end(), add);
  std::for_each(machine.beams.begin(), machine.beams.end(), add);
  if (names.empty()) return;
  warnings.push_back(fmt::format(
      "the 'reference_temperature' of {} counts only in analyses that say a temperature: give the machine its own",
      names));
}

/// Saddles that say nothing of their friction: their ropes slip over them without any loss.
void add_smooth_saddles(const machine::Machine& machine, std::vector<std::string>& warnings) {
  using machine::description::RoundLaw;
  std::string names;
  const auto add = [&](const machine::description::Round& one, bool usual) {
    const bool saddle = one.law == RoundLaw::saddle || (one.law == RoundLaw::usual && usual);
    if (saddle && !one.friction) names += fmt::format("{}'{}'", names.empty() ? "" : ", ", one.name);
  };
  for (const auto& one : machine.sheaves) add(one, false);
  for (const auto& one : machine.supports) add(one, true);
  if (names.empty()) return;
  warnings.push_back(fmt::format(
      "the rope slips over {} without friction: a saddle does not turn; give its 'friction' (0 where that is meant)",
      names));
}

/// The carriage at which a body hangs, or which it is; null without one.
const machine::Carriage* carriage_over(const machine::Model& model, int body) {
  const auto meets = [](const machine::Reeving& rope, int one) {
    return std::any_of(rope.nodes.begin(), rope.nodes.end(), [&](const auto& node) { return node.at.body == one; });
  };
  for (const machine::Carriage& car : model.carriages) {
    if (car.body == body) return &car;
  }
  for (const machine::Carriage& car : model.carriages) {
    const bool hangs = std::any_of(model.reevings.begin(), model.reevings.end(),
                                   [&](const auto& rope) { return meets(rope, car.body) && meets(rope, body); });
    if (hangs) return &car;
  }
  return nullptr;
}

/// In plan: where a carriage's line goes, and where its mainline draws it (zero without one).
struct WaysOfCarriage {
  Vector3 line = Vector3::Zero(), pull = Vector3::Zero();
};
WaysOfCarriage ways_of(const machine::Model& model, const machine::Carriage& car) {
  const auto place = [&](const machine::Node& node) { return machine::in_ground(model, node.at); };
  const auto& line = model.reevings[car.reeving].nodes;
  const auto count = static_cast<int>(line.size());
  WaysOfCarriage ways;
  ways.line = place(line[(car.node + car.rollers) % count]) - place(line[(car.node + count - 1) % count]);
  if (car.mainline) {
    const auto& nodes = model.reevings[*car.mainline].nodes;
    const auto at =
        std::find_if(nodes.begin(), nodes.end(), [&](const auto& node) { return node.at.body == car.body; });
    ways.pull = place(at == nodes.begin() ? nodes[1] : *std::prev(at)) - model.bodies[car.body].position;
  }
  ways.line.z() = ways.pull.z() = 0;
  return ways;
}

}  // namespace

std::vector<std::string> absurd_machine(const MachineDeck& deck, const machine::Model& model) {
  std::vector<std::string> warnings;
  const Mentions all(deck);
  const machine::Machine& m = deck.machine;
  add_unused(all, "sheaves", "sheave", "touches no rope", m.sheaves, warnings);
  add_unused(all, "supports", "support", "touches no rope", m.supports, warnings);
  add_unused(all, "drums", "drum", "has no rope", m.drums, warnings);
  add_unused(all, "points", "point", "is used by nothing", m.points, warnings);
  add_unused(all, "ropes", "rope", "is on no path", m.ropes, warnings);
  add_unused(all, "bodies", "body", "is used by nothing", m.bodies, warnings);
  add_unused(all, "signals", "signal", "is used by nothing", m.signals, warnings);
  add_short_ropes(model, deck.display, warnings);
  add_flat_ropes(model, warnings);
  add_smooth_saddles(m, warnings);
  add_motionless(deck, warnings);
  add_references(m, warnings);
  return warnings;
}

std::vector<std::string> dragged_astray(const machine::Machine& given, const machine::Model& model) {
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < given.loads.size(); ++i) {
    const machine::Carriage* const car =
        given.loads[i].dragged ? carriage_over(model, model.loads[i].at.body) : nullptr;
    if (car == nullptr) continue;
    const Vector3 along = Vector3(given.loads[i].dragged->along[0], given.loads[i].dragged->along[1], 0).normalized();
    const WaysOfCarriage ways = ways_of(model, *car);
    if (std::abs(along.dot(ways.line)) < M_SQRT1_2 * ways.line.norm()) {
      warnings.push_back(
          fmt::format("loads[{}].dragged.along goes across the line of '{}': the friction of the ground "
                      "would not act against the winch; give the direction of travel",
                      i, car->name));
    } else if (along.dot(ways.pull) < 0) {
      warnings.push_back(
          fmt::format("loads[{}].dragged.along points away from '{}', the mainline of '{}': the friction of the ground "
                      "helps the winch, which is right only where the bunch is let down by it",
                      i, model.reevings[*car->mainline].name, car->name));
    }
  }
  return warnings;
}

std::vector<std::string> absurd_answers(const std::vector<results::Answer>& answers, const Display& display) {
  DeepSag worst;
  for (const results::Answer& answer : answers) {
    note_spans(answer, worst);
    note_carriages(answer, worst);
  }
  if (worst.rope.empty()) return {};
  return {
      fmt::format("rope '{}' sags by {} between '{}' and '{}', {} apart ({}): more than half the span; is its length, "
                  "or its tension, meant so?",
                  worst.rope, display.brief(worst.sag, si::m), worst.from, worst.to, display.brief(worst.span, si::m),
                  worst.state)};
}

}  // namespace taut::app
