#include "taut/machine/compile/path.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "taut/base/array.hpp"
#include "taut/machine/compile/carriages.hpp"
#include "taut/machine/compile/drums.hpp"
#include "taut/machine/compile/guides.hpp"

namespace taut::machine {
namespace {

using description::PathElement;
using description::Round;
using description::RoundLaw;
using description::Side;
using description::Uplift;

/// Below this sine of the bend a path runs straight through or straight back.
constexpr double straight_bend = 1e-6;

Vector3 unit_axis(const Triple& axis) {
  const Vector3 v = vector_of(axis);
  return v.norm() > 0 ? v.normalized() : Vector3::UnitY();
}

bool is_over(const PathElement& e, const std::string& name) { return e.over && *e.over == name; }

const Round& given_round(const Machine& machine, const Target& target) {
  const auto sheaves = machine.sheaves.size();
  const auto index = static_cast<std::size_t>(target.index);
  return index < sheaves ? machine.sheaves[index] : machine.supports[index - sheaves];
}

Stop round_stop(const Machine& machine, const Target& target, Side side) {
  const Round& round = given_round(machine, target);
  Stop stop;
  const bool support = static_cast<std::size_t>(target.index) >= machine.sheaves.size();
  stop.saddle = round.law == RoundLaw::saddle || (round.law == RoundLaw::usual && support);
  stop.side = side;
  Node& node = stop.node;
  stop.drives = round.motor.has_value();
  stop.by_torque = stop.drives && round.motor->torque.has_value();
  if (stop.drives || round.one_wheel) node.wheel = target.index;
  node.name = round.name;
  node.kind = NodeKind::contact;
  node.at = target.place;
  node.radius = round.diameter / 2;
  node.axis = round.axis ? unit_axis(*round.axis) : Vector3::UnitY();
  // what several ropes drive turns about one axis
  stop.axis_open = !round.axis && target.place.body == ground && !node.wheel;
  node.inertia = stop.saddle ? 0 : round.inertia.value_or(0);
  node.drag = round.drag;
  if (stop.saddle) {
    const double mu = round.friction.value_or(0);
    node.law = {.friction = mu, .efficiency = mu > 0 ? 0.0 : 1.0};
  } else {
    node.law = {.friction = round.friction.value_or(std::numeric_limits<double>::infinity()),
                .efficiency = round.efficiency};
  }
  const bool upright_axis = std::abs(node.axis.z()) > M_SQRT1_2;
  Uplift uplift = round.uplift;
  if (uplift == Uplift::usual) uplift = stop.saddle && !upright_axis ? Uplift::report : Uplift::hold;
  if (uplift != Uplift::hold) node.support = up();
  node.may_lift = uplift == Uplift::lift;
  return stop;
}

class PathReader {
 public:
  PathReader(const Machine& machine, const Links& links, std::string reeving, const RopeData& rope,
             const Array<RopeData>& ropes, std::vector<Complaint>& complaints)
      : machine_(machine),
        links_(links),
        reeving_(std::move(reeving)),
        rope_(rope),
        ropes_(ropes),
        complaints_(complaints) {}

  /// An element of an endless rope.
  void add_closed(const PathElement& e, const DeckPlace& at) {
    if (e.anchor || e.drum) complain(at, "an endless rope is fixed nowhere: 'over' and 'through' only");
    if (e.parts != 1 || !e.between.empty()) complain(at, "an endless rope has no tackle; write its sheaves one by one");
    if (e.grip && !e.through) complain({at, "grip"}, "belongs to an element with 'through'");
    if (!e.over && e.turns != 0) complain({at, "turns"}, "belongs to an element with 'over'");
    if (e.through) carriage(*e.through, e.grip, {at, "through"});
    if (!e.over) return;
    const Target* own = links_.find(*e.over, {Thing::sheave}, {at, "over"}, complaints_);
    if (own == nullptr) return;
    stops.push_back(round_stop(machine_, *own, e.side));
    wind(stops.back(), e.turns, at);
    if (given_round(machine_, *own).holds) {
      complain({at, "over"},
               fmt::format("'{}' holds a rope that ends at a carriage ('holds'); this one is endless", *e.over));
    }
  }

  void add(const std::vector<PathElement>& path, std::size_t i, const DeckPlace& at) {
    const PathElement& e = path[i];
    const bool is_end = i == 0 || i + 1 == path.size();
    if (e.anchor || e.drum) {
      if (!is_end) complain(at, "a rope is fixed at its ends only; here it runs on");
      e.anchor ? anchor(*e.anchor, {at, "anchor"}) : drum(e, {at, "drum"});
    } else if (is_end) {
      complain(at, "a rope's first and last element is an 'anchor' or a 'drum'");
    } else if (e.through) {
      carriage(*e.through, e.grip, {at, "through"});
    } else if (e.over) {
      over(path, i, at);
    }
    if (e.grip && !e.through) complain({at, "grip"}, "belongs to an element with 'through'");
    if (!e.over && e.parts != 1) complain({at, "parts"}, "belongs to an element with 'over'");
    if (!e.over && e.turns != 0) complain({at, "turns"}, "belongs to an element with 'over'");
    if (e.between.empty() || (e.over && e.parts > 1)) return;
    complain({at, "between"},
             e.over ? "belongs to a tackle of two 'parts' or more; one part is the rope to the next sheave"
                    : "belongs to an element with 'over'");
  }

  Array<Stop> stops;

 private:
  void complain(const DeckPlace& at, std::string message) { complaints_.push_back({at.text(), std::move(message)}); }

  void anchor(const std::string& name, const DeckPlace& path) {
    const Target* t = links_.find(name, {Thing::point, Thing::body, Thing::carriage, Thing::sheave}, path, complaints_);
    if (t == nullptr) return;
    Stop stop;
    stop.node.name = name;
    stop.node.at = t->place;
    stops.push_back(std::move(stop));
  }

  void drum(const PathElement& e, const DeckPlace& path) {
    const Target* t = links_.find(*e.drum, {Thing::drum}, path, complaints_);
    if (t == nullptr) return;
    const description::Drum& drum = machine_.drums[static_cast<std::size_t>(t->index)];
    Stop stop;
    stop.side = e.side;
    stop.node.name = drum.name;
    stop.node.at = t->place;
    stop.node.axis = unit_axis(drum.axis);
    stop.node.drum = t->index;
    stop.node.radius = radius_of({.machine = machine_, .ropes = ropes_, .drum = drum, .rope = rope_});
    stops.push_back(std::move(stop));
  }

  void carriage(const std::string& name, bool grip, const DeckPlace& path) {
    const Target* t = links_.find(name, {Thing::carriage}, path, complaints_);
    if (t == nullptr) return;
    const description::Carriage& car = machine_.carriages[static_cast<std::size_t>(t->index)];
    const bool carries = car.fixed_to && *car.fixed_to == reeving_;
    if (grip && !carries) {
      complain(path, fmt::format("'grip' belongs to the rope that '{}' is 'fixed_to'", name));
    }
    const bool grips = carries && (grip || car.rides != reeving_);
    for (Stop& stop : machine::stops_of(car, t->index, t->place, grips)) stops.push_back(std::move(stop));
  }

  void wind(Stop& stop, int turns, const DeckPlace& at) {
    if (turns == 0) return;
    stop.node.turns = turns;
    if (stop.node.radius > 0) return;
    complain({at, "turns"}, fmt::format("'{}' has no 'diameter' round which the rope could turn", stop.node.name));
  }

  /// One motor per rope with ends, and one pass over it.
  void drive(const std::string& name, const DeckPlace& at) {
    const auto other = std::find_if(stops.begin(), stops.end(), [](const Stop& stop) { return stop.drives; });
    if (other == stops.end()) return;
    complain({at, "over"},
             other->node.name == name
                 ? fmt::format("a rope with two ends passes the driven sheave '{}' once; whole turns round it are "
                               "'turns: N' of this element",
                               name)
                 : fmt::format("'{}' drives this rope already, and a rope with two ends has one driven sheave",
                               other->node.name));
  }

  /// The other sheave of a tackle.
  std::optional<std::string> partner(const std::vector<PathElement>& path, std::size_t i, const DeckPlace& at) {
    const PathElement& e = path[i];
    if (e.between.empty()) {
      if (path[i - 1].over) return path[i - 1].over;
      if (path[i + 1].over) return path[i + 1].over;
      if (e.parts == 2) return e.over;  // one turn: no other sheave is needed
      complain({at, "parts"}, "no sheave is beside this one in the path; say 'between: [A, B]'");
      return std::nullopt;
    }
    const bool fits =
        e.between.size() == 2 && e.between[0] != e.between[1] && (e.between[0] == *e.over || e.between[1] == *e.over);
    if (fits) return e.between[0] == *e.over ? e.between[1] : e.between[0];
    complain({at, "between"}, fmt::format("two sheaves are expected, '{}' and another one", *e.over));
    return std::nullopt;
  }

  void over(const std::vector<PathElement>& path, std::size_t i, const DeckPlace& at) {
    const PathElement& e = path[i];
    const Target* own = links_.find(*e.over, {Thing::sheave}, {at, "over"}, complaints_);
    if (own == nullptr) return;
    const Stop single = round_stop(machine_, *own, e.side);
    const Round& round = given_round(machine_, *own);
    if (e.parts == 1) {
      if (single.drives) drive(*e.over, at);
      stops.push_back(single);
      wind(stops.back(), e.turns, at);
      if (single.drives) stops.back().node.kind = NodeKind::drive;
      if (const auto carriage = ahead_of(machine_, round))
        stops.back().ahead_of = AheadOf{.carriage = *carriage, .path = DeckPlace(at, "over").text()};
      if (single.drives && round.holds) {
        complain({at, "over"}, fmt::format("'{}' has a motor; a guide that 'holds' has none", *e.over));
      }
      return;
    }
    if (e.turns != 0) complain({at, "turns"}, "belongs to an element of one part; a tackle's sheaves have no more");
    if (round.holds) complain({at, "over"}, fmt::format("'{}' has 'holds'; a tackle's sheaves have not", *e.over));
    if (single.drives) complain({at, "over"}, fmt::format("'{}' has a motor; a tackle's sheaves have none", *e.over));
    const auto name = partner(path, i, at);
    if (!name) return;
    const Target* other = links_.find(*name, {Thing::sheave}, {at, "between"}, complaints_);
    if (other == nullptr) return;
    const bool between = !e.between.empty();
    const int turns = between && !is_over(path[i - 1], *name) ? e.parts : e.parts - 1;
    for (int k = 0; k < turns; ++k) {
      stops.push_back(round_stop(machine_, k % 2 == 0 ? *own : *other, e.side));
      stops.back().axis_open = false;  // its parts are parallel
    }
  }

  const Machine& machine_;
  const Links& links_;
  std::string reeving_;  ///< its name
  const RopeData& rope_;
  const Array<RopeData>& ropes_;
  std::vector<Complaint>& complaints_;
};

/// The horizontal axis of a round by the directions in plan to its neighbours: see set_axes.
Vector3 axis_across(const Vector3& h, const Vector3& k) {
  constexpr double much_longer = 2;
  const double both = h.norm() * k.norm(), along = h.dot(k);
  Vector3 way = along < 0 ? Vector3(h - k) : Vector3(h + k);
  if (!(std::abs(along) >= M_SQRT1_2 * both) || both == 0) {
    const Vector3 &longer = h.norm() > k.norm() ? h : k, &shorter = h.norm() > k.norm() ? k : h;
    if (!(longer.norm() > much_longer * shorter.norm())) return Vector3::UnitY();
    way = longer;
  }
  if (std::abs(way.y()) <= straight_bend * straight_bend * way.norm()) return Vector3::UnitY();
  const Vector3 across = up().cross(way).normalized();
  const bool turned = std::abs(across.y()) > straight_bend ? across.y() < 0 : across.x() > 0;
  return turned ? Vector3(-across) : across;
}

/// +1 where the tangent point lies above the centre of a rope in direction `d`.
int upper_side(const Vector3& d, const Vector3& axis) { return d.cross(axis).z() >= -straight_bend ? 1 : -1; }

/// The side of a contact by the bend of its path; 0 where the path runs straight back.
int bend_side(const Stop& stop, const Vector3& before, const Vector3& at, const Vector3& after) {
  const Vector3& axis = stop.axis;
  const Vector3 in = (at - before).normalized();
  const Vector3 out = (after - at).normalized();
  const bool from_above = stop.saddle || (!stop.carriage && stop.node.support != Vector3::Zero());
  if (from_above && std::abs(axis.z()) <= M_SQRT1_2) return upper_side((after - before).normalized(), axis);
  const double bend = in.cross(out).dot(axis);
  // a rope that comes back beside itself, nearer than the sheave is wide, does not say which way round it went
  const double width = 2 * stop.node.radius / std::min((at - before).norm(), (after - at).norm());
  if (in.dot(out) < 0 && std::abs(bend) <= std::max(straight_bend, width)) return 0;
  if (std::abs(bend) > straight_bend) return bend > 0 ? 1 : -1;
  return upper_side(in, axis);
}

/// How much a branch that ends at this stop carries: rolling loads before those that are fixed to it.
int carries(const Stop& stop) {
  if (!stop.carriage) return 0;
  return stop.node.kind == NodeKind::contact ? 2 : 1;
}

/// What a round's own surroundings say about its side.
struct Bend {
  int side = 0;       ///< 0: the bend does not say, the rope comes back beside itself
  int likely = 1;     ///< then: the side that is taken where the neighbours do not say either,
  double weight = 0;  ///< and how much speaks for it
};

Bend bend_of(const Stop& stop, const Stop& from, const Stop& to, const Vector3& before, const Vector3& at,
             const Vector3& after) {
  Bend bend;
  bend.side = bend_side(stop, before, at, after);
  const Vector3 in = (at - before).normalized(), out = (after - at).normalized();
  const double turn = in.cross(out).dot(stop.axis);
  if (carries(from) != carries(to)) {
    // the carriage runs on the upper one of two branches
    bend.likely = upper_side(carries(from) > carries(to) ? in : out, stop.axis);
    bend.weight = 2;
  } else if (std::abs(turn) > straight_bend) {
    bend.likely = turn > 0 ? 1 : -1;
    bend.weight = std::abs(turn);
  } else {
    bend.likely = upper_side(in, stop.axis);
  }
  return bend;
}

/// The sides that no bend says. `open`: which.
class OpenSides {
 public:
  OpenSides(Array<Stop>& stops, Array<Bend> bends, Array<bool> open)
      : stops_(stops), bends_(std::move(bends)), open_(std::move(open)) {}

  void set() {
    follow_all();
    while (true) {
      const std::size_t best = plainest();
      if (best == stops_.size()) return;
      stops_[best].node.side = bends_[best].likely;
      open_[best] = false;
      follow_all();
    }
  }

 private:
  /// The open one whose side has most to be said for it; the number of stops: none is left.
  std::size_t plainest() const {
    std::size_t best = stops_.size();
    for (std::size_t i = 0; i < stops_.size(); ++i) {
      // with a margin, so that rounding does not choose between equals
      if (open_[i] && (best == stops_.size() || bends_[i].weight > bends_[best].weight * (1 + straight_bend))) best = i;
    }
    return best;
  }

  void follow_all() {
    for (std::size_t i = 1; i < stops_.size(); ++i) follow(i, i - 1);
    for (std::size_t i = stops_.size() - 1; i-- > 0;) follow(i, i + 1);
  }

  void follow(std::size_t i, std::size_t from) {
    const NodeKind kind = stops_[from].node.kind;
    const bool round = stops_[from].node.radius > 0 && (kind == NodeKind::contact || kind == NodeKind::drive);
    if (!open_[i] || open_[from] || !round) return;
    const double same = stops_[from].axis.dot(stops_[i].axis);
    stops_[i].node.side = same >= 0 ? stops_[from].node.side : -stops_[from].node.side;
    open_[i] = false;
  }

  Array<Stop>& stops_;
  Array<Bend> bends_;
  Array<bool> open_;
};

/// Turns an endless path so that its drive comes first: the first motor without a given torque, which gives what the
/// others leave, else the first one.
void begin_at_drive(Array<Stop>& stops, const std::string& path, std::vector<Complaint>& complaints) {
  auto drive =
      std::find_if(stops.begin(), stops.end(), [](const Stop& stop) { return stop.drives && !stop.by_torque; });
  if (drive == stops.end())
    drive = std::find_if(stops.begin(), stops.end(), [](const Stop& stop) { return stop.drives; });
  if (drive == stops.end()) {
    complaints.push_back({path, "an endless rope needs a sheave with a 'motor' that drives it"});
    return;
  }
  std::rotate(stops.begin(), drive, stops.end());
  stops.front().node.kind = NodeKind::drive;
}

}  // namespace

Array<Stop> stops_of(const Machine& machine, const Links& links, const DescribedReeving& described,
                     std::vector<Complaint>& complaints) {
  const auto& [reeving, rope, ropes, path] = described;
  PathReader reader(machine, links, name_of(reeving), rope, ropes, complaints);
  if (reeving.path.size() < 2) complaints.push_back({path, "a rope runs from one element to another one"});
  reader.stops.reserve(reeving.path.size());
  const DeckPlace here(path);
  const DeckPlace elements(here, "path");
  for (std::size_t i = 0; i < reeving.path.size(); ++i) {
    const DeckPlace at(elements, i);
    reeving.closed ? reader.add_closed(reeving.path[i], at) : reader.add(reeving.path, i, at);
  }
  if (reeving.closed) begin_at_drive(reader.stops, path, complaints);
  return std::move(reader.stops);
}

void set_axes(Array<Stop>& stops, const Array<Vector3>& places, bool closed) {
  const std::size_t count = stops.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (!stops[i].axis_open || (!closed && (i == 0 || i + 1 == count))) continue;
    const Vector3& at = places[i];
    const auto to = [&](std::size_t k) {
      Vector3 direction = (places[k] - at).normalized();
      direction.z() = 0;
      return direction;
    };
    stops[i].node.axis = axis_across(to((i + count - 1) % count), to((i + 1) % count));
  }
}

void set_sides(Array<Stop>& stops, const Array<Vector3>& places, bool closed) {
  Array<Bend> bends(stops.size());
  Array<bool> open(stops.size(), false);
  const auto last = stops.size() - 1;
  for (std::size_t i = 0; i < stops.size(); ++i) {
    Node& node = stops[i].node;
    if (stops[i].side != Side::automatic) {
      // looking along the axis, what lies to the left of the path turns it left: left-handed about the axis
      node.side = stops[i].side == Side::left ? -1 : 1;
    } else if (!closed && (i == 0 || i == last)) {
      const Vector3 d = i == 0 ? places[1] - places[0] : places[last] - places[last - 1];
      node.side = upper_side(d.normalized(), stops[i].axis);
      node.side_by_place = node.drum.has_value();
    } else {
      const std::size_t from = i == 0 ? last : i - 1, to = i == last ? 0 : i + 1;
      bends[i] = bend_of(stops[i], stops[from], stops[to], places[from], places[i], places[to]);
      node.side = bends[i].side;
      open[i] = bends[i].side == 0;
      node.side_open =
          !stops[i].carriage && node.support == Vector3::Zero() && node.radius > 0 && node.kind == NodeKind::contact;
    }
  }
  OpenSides(stops, std::move(bends), std::move(open)).set();
}

}  // namespace taut::machine
