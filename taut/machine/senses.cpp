#include "taut/machine/senses.hpp"

#include <algorithm>

namespace taut::machine {
namespace {

int sign_of(double value) { return (value > 0) - (value < 0); }

Vector3 place_at_start(const Model& model, const Node& node) {
  if (node.at.body == ground) return node.at.at;
  const Body& body = model.bodies[node.at.body];
  return body.position + body.orientation * node.at.at;
}

/// A carriage in its span: the nodes beside it on the rope on which it rolls, and its place.
struct CarriageSpan {
  int before = 0, after = 0;
  Vector3 along = Vector3::UnitX();  ///< unit vector
  double x = 0;                      ///< of the carriage, along that, m
  int path = 0;                      ///< 1: the path goes along it, -1: against it
};

CarriageSpan carriage_span(const Model& model, int index, const std::optional<Prescribed>& prescribed) {
  const Carriage& car = model.carriages[index];
  const Array<Node>& nodes = model.reevings[car.reeving].nodes;
  CarriageSpan s{.before = car.node - 1, .after = car.node + car.rollers};
  while (nodes[s.before].at.body == car.body) --s.before;
  while (nodes[s.after].at.body == car.body) ++s.after;
  const Vector3 chord = place_at_start(model, nodes[s.after]) - place_at_start(model, nodes[s.before]);
  const bool placed = prescribed && prescribed->carriage == index;
  const Vector3 level(chord.x(), chord.y(), 0);
  s.along = placed ? prescribed->along : Vector3(level.norm() > 0 ? level.normalized() : chord.normalized());
  s.x = placed ? prescribed->x : s.along.dot(model.bodies[car.body].position);
  s.path = sign_of(s.along.dot(chord));
  return s;
}

/// Which way along the span a rope that ends at the carriage draws it: towards its first node off the carriage where
/// its free part becomes shorter, by running off from there, or into a drum on the carriage.
int drawn_by(const Model& model, const Carriage& car, const CarriageSpan& span, const Reeving& rope) {
  const bool at_end = rope.nodes.back().at.body == car.body;
  const Node& own = at_end ? rope.nodes.back() : rope.nodes.front();
  const Node& beside = at_end ? rope.nodes[rope.nodes.size() - 2] : rope.nodes[1];
  const int runs_off = at_end ? -rope.haul : rope.haul;
  return (own.drum ? -1 : 1) * runs_off * sign_of(span.along.dot(place_at_start(model, beside)) - span.x);
}

/// Whether a rope that ends at the carriage is drawn off its winch while the mainline hauls.
bool follows(const Model& model, const Carriage& car, const CarriageSpan& span, const Reeving& rope) {
  const bool ends_there = rope.nodes.front().at.body == car.body || rope.nodes.back().at.body == car.body;
  if (!car.mainline || !ends_there || rope.closed || rope.haul_is_told) return false;
  const Reeving& mainline = model.reevings[*car.mainline];
  if (&rope == &mainline) return false;
  return drawn_by(model, car, span, mainline) * drawn_by(model, car, span, rope) < 0;
}

/// Which way along the span the carriage moves while the machine hauls in; 0: nothing says it.
int moves(const Model& model, const Carriage& car, const CarriageSpan& span) {
  if (const auto pulls = car.mainline ? car.mainline : car.haulback) {
    return drawn_by(model, car, span, model.reevings[*pulls]);
  }
  if (!car.grip) return 0;
  const Reeving& rope = model.reevings[car.grip->reeving];
  const auto count = static_cast<int>(rope.nodes.size());
  const auto place = [&](int n) { return place_at_start(model, rope.nodes[(n + count) % count]); };
  return rope.haul * sign_of(span.along.dot(place(car.grip->node + 1) - place(car.grip->node - 1)));
}

/// Whether an open rope on which a carriage rolls runs as that carriage moves: not where the deck says how, nor where
/// it pulls that carriage itself.
bool rolls_on(const Reeving& rope, const Carriage& car) {
  return !rope.haul_is_told && rope.nodes.front().at.body != car.body && rope.nodes.back().at.body != car.body;
}

/// Over the supports beside a carriage's span, towards it.
void set_creep(const Reeving& rope, const CarriageSpan& span, Array<int>& creep) {
  for (int n = 1; n + 1 < static_cast<int>(rope.nodes.size()); ++n) {
    if (n > span.before && n < span.after) {
      creep[n] = 0;
    } else if (loses(rope.nodes[n])) {
      creep[n] = n <= span.before ? 1 : -1;
    }
  }
}

}  // namespace

bool loses(const Node& node) {
  return node.kind == NodeKind::contact && node.law.friction > 0 && node.law.efficiency < 1;
}

bool is_taken_in(const Model& model, int reeving, bool at_end) {
  const Reeving& rope = model.reevings[reeving];
  if (rope.closed) return false;
  const Given tension = at_end ? Given::tension_at_end : Given::tension_at_start;
  if (rope.given == tension || (rope.also && rope.also->first == tension)) return true;
  const Node& own = at_end ? rope.nodes.back() : rope.nodes.front();
  const Node& other = at_end ? rope.nodes.front() : rope.nodes.back();
  if (own.drum) return true;
  return !other.drum && std::any_of(model.carriages.begin(), model.carriages.end(), [&](const Carriage& car) {
    return (car.mainline == reeving || car.haulback == reeving) && other.at.body == car.body && own.at.body != car.body;
  });
}

Senses hauling_in(const Model& model, const std::optional<Prescribed>& prescribed) {
  Senses all;
  for (const Reeving& rope : model.reevings) {
    all.flow.emplace_back(rope.nodes.size(), rope.haul);
    all.creep.emplace_back(rope.nodes.size(), 0);
    all.follows.push_back(false);
  }
  all.moves.resize(model.carriages.size());
  for (int i = 0; i < static_cast<int>(model.carriages.size()); ++i) {
    const Carriage& car = model.carriages[i];
    const Reeving& rope = model.reevings[car.reeving];
    if (rope.closed) continue;
    const CarriageSpan span = carriage_span(model, i, prescribed);
    all.moves[i] = moves(model, car, span);
    for (int r = 0; r < static_cast<int>(model.reevings.size()); ++r) {
      const bool pulls = r == car.reeving || is_taken_in(model, r, false) || is_taken_in(model, r, true);
      if (pulls && follows(model, car, span, model.reevings[r])) all.follows[r] = true;
    }
    if (!rolls_on(rope, car)) continue;
    const int sense = span.path * all.moves[i];
    for (int n = span.before + 1; n < span.after && sense != 0; ++n) all.flow[car.reeving][n] = -sense;
    set_creep(rope, span, all.creep[car.reeving]);
  }
  return all;
}

}  // namespace taut::machine
