#include "taut/checks/rope/rope_uses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "taut/catalogue/rope_words.hpp"
#include "taut/checks/check_state.hpp"
#include "taut/machine/compile/drums.hpp"
#include "taut/math/index.hpp"
#include "taut/rope/life.hpp"
#include "taut/rope/rope_check.hpp"

namespace taut::checks {

rope::BendKind kind_of(const machine::Node& node) {
  const bool turns = node.kind == machine::NodeKind::drive || node.law.efficiency > 0;
  return turns ? rope::BendKind::sheave : rope::BendKind::saddle;
}

namespace {

constexpr double still_grows = 0.01;  ///< in LastingTension::gap: what is less comes to rest

double largest(const solve::ContactResult& c) { return std::max({c.T_in, c.T_out, c.T_in_max, c.T_out_max}); }

constexpr double whole_turn = 2 * std::numbers::pi;

Vector3 axis_of(const machine::State& state, const machine::Node& node) {
  return node.at.body == machine::ground ? node.axis : Vector3(state.bodies[node.at.body].orientation * node.axis);
}

machine::State described_places(const machine::Model& model) {
  machine::State state;
  for (const machine::Body& body : model.bodies) state.bodies.push_back({body.position, body.orientation});
  return state;
}

/// Directions along the path at the ends of a branch.
std::pair<Vector3, Vector3> ends_of(const machine::State& state, const solve::BranchResult& b) {
  const machine::BranchState& known = state.branches[b.reeving][b.from];
  if (known.leaves != Vector3::Zero() && known.arrives != Vector3::Zero()) return {known.leaves, known.arrives};
  const Vector3 straight = (b.end - b.start).normalized();
  return {straight, straight};
}

/// Notes how a state turns the rope there: on which side of the round's own axis, which turns with its body, and about
/// which axis in space, by which neighbours are compared.
void turn(rope::Bend& bend, int& first_side, int side, const Vector3& axis) {
  if (bend.wrap == 0) {
    first_side = side;  // of the first state that bends it
    bend.about = side * axis;
  } else if (side != first_side) {
    bend.both_ways = true;
  }
}

/// By which a round on a drum is known: a rope may have both its ends on one.
std::string key_of_drum(const machine::Node& node, bool at_end) {
  return fmt::format("drum {} {}", at_end ? "end" : "start", node.name);
}

/// What is not known of a drum and its rope, for the layers.
std::vector<std::string> lacks_of_layers(const machine::Drum& drum, double rope_diameter) {
  std::vector<std::string> all;
  if (!(drum.width > 0)) all.emplace_back("'face_width'");
  if (!drum.length_on_drum) all.emplace_back("'length_on_drum'");
  if (!(rope_diameter > 0)) all.emplace_back("the 'diameter' of its rope in 'ropes' of the machine");
  return all;
}

/// Of branches in the order of the paths; of a rope in segments the whole of its first or last branch.
template <class Branches, class Ends>
BesideDrum beside_drum(const Branches& branches, int reeving, bool at_end, const Ends& ends_of) {
  BesideDrum found;
  Vector3 start = Vector3::Zero(), end = Vector3::Zero();
  bool met = false;
  int from = 0;
  for (const auto& b : branches) {
    if (b.reeving != reeving || (met && !at_end && b.from != from)) continue;
    if (!met || (at_end && b.from != from)) {
      start = b.start;
      found.leaves = ends_of(b).first;
    }
    met = true;
    from = b.from;
    end = b.end;
    found.arrives = ends_of(b).second;
    found.next = at_end ? b.from : b.to;
  }
  found.length = (end - start).norm();
  if (at_end) {
    std::swap(found.leaves, found.arrives);
    found.leaves *= -1;
    found.arrives *= -1;
  }
  return found;
}

/// Largest angle of the rope between a drum and the next round out of the plane of either of them, the rope at one
/// flange or the other, rad. `rope` is that in the middle of the face: where the rounds are askew it runs sideways too.
/// At a flange it goes half the face farther sideways.
double fleet_angle_of(const machine::State& state, const machine::Node& drum, const machine::Node& next, double face,
                      const BesideDrum& rope) {
  const Vector3 axis = axis_of(state, drum);
  double largest = 0;
  for (const double aside : {-face / 2, face / 2}) {
    const auto out_of_plane = [&](const Vector3& direction, const Vector3& normal) {
      const Vector3 way = rope.length * direction - aside * axis;
      const double out = std::abs(way.dot(normal));
      return std::atan2(out, std::sqrt(std::max(way.squaredNorm() - out * out, 0.0)));
    };
    largest = std::max(largest, out_of_plane(rope.leaves, axis));
    if (next.radius > 0) largest = std::max(largest, out_of_plane(rope.arrives, axis_of(state, next)));
  }
  return largest;
}

/// What all ropes of a drum pull that are wound on it as this one, N, at its radius.
double haul_of(const Array<solve::DrumResult>& ends, const solve::DrumResult& own) {
  double torque = 0;
  for (const solve::DrumResult& d : ends) {
    if (d.drum == own.drum && d.sense == own.sense) torque += d.torque;
  }
  return own.radius > 0 ? torque / own.radius : 0;
}

}  // namespace

const std::string& rope_name_of(const machine::Machine& machine, std::size_t reeving) {
  const std::size_t first_guy = machine.reevings.size();
  return reeving < first_guy ? machine.reevings[reeving].rope : machine.guys[reeving - first_guy].rope;
}

catalogue::RopeRow row_of(const machine::description::Rope& given) {
  catalogue::RopeRow row;
  row.id = given.name;
  row.trust = row.area_trust = catalogue::Trust::verified;
  if (given.rope) {
    if (const auto found = catalogue::find_rope_in_words(*given.rope)) row = *found;
  }
  row.diameter = given.diameter.value_or(row.diameter);
  row.mass_per_length = given.mass.value_or(row.mass_per_length);
  if (given.breaking_force) {
    row.breaking_force = *given.breaking_force;
    row.trust = catalogue::Trust::verified;
  }
  return row;
}

catalogue::RopeRow row_in(const CheckedDeck& deck, const std::string& rope) {
  if (const auto chosen = deck.chosen.find(rope); chosen != deck.chosen.end()) return chosen->second;
  for (const auto& one : deck.machine.ropes) {
    if (one.name == rope) return row_of(one);
  }
  return {};
}

RopeUses::RopeUses(const CheckedDeck& deck, const machine::Model& model)
    : uses_(model.reevings.size()), lasting_(model.reevings.size()), bends_(model.reevings.size()) {
  const machine::State described = described_places(model);
  for (std::size_t i = 0; i < uses_.size(); ++i) {
    uses_[i].name = model.reevings[i].name;
    uses_[i].display = deck.display;
    uses_[i].measurable = true;
    uses_[i].closed = model.reevings[i].closed;
    uses_[i].copies = model.reevings[i].copies;
    uses_[i].rope = row_in(deck, rope_name_of(deck.machine, i));
    std::map<std::string, int> met;
    for (const machine::Node& node : model.reevings[i].nodes) {
      const bool turns = node.kind == machine::NodeKind::contact || node.kind == machine::NodeKind::drive;
      if (node.drum || node.kind == machine::NodeKind::anchor) continue;
      if (node.radius > 0) {
        bend_at(i, node, met[node.name]++, axis_of(described, node));
      } else if (turns && !machine::is_saddle(node) && !machine::rides(model, node)) {
        uses_[i].unmeasured.push_back(fmt::format("'{}'", node.name));
      }
    }
    if (model.reevings[i].closed) continue;
    add_end(i, model, false);
    add_end(i, model, true);
  }
}

void RopeUses::add_end(std::size_t reeving, const machine::Model& model, bool at_end) {
  const machine::Reeving& rope = model.reevings[reeving];
  const machine::Node& node = at_end ? rope.nodes.back() : rope.nodes.front();
  if (!node.drum) {
    uses_[reeving].ends.push_back({node.name, 0});
    return;
  }
  if (const double radius = model.drums[*node.drum].core_radius; radius > 0) {
    bends_[reeving].try_emplace(key_of_drum(node, at_end),
                                Met{.bend = {.name = node.name,
                                             .kind = rope::BendKind::drum,
                                             .diameter = 2 * radius + rope.diameter,
                                             .tension = 0,
                                             .wrap = whole_turn,
                                             .about = node.side * axis_of(described_places(model), node)},
                                    .order = at_end ? std::numeric_limits<int>::max() : -1});
  } else {
    uses_[reeving].unmeasured.push_back(fmt::format("'{}'", node.name));
  }
  auto& drums = uses_[reeving].drums;
  const auto same = [&](const rope::DrumEnd& one) { return one.name == node.name; };
  if (std::any_of(drums.begin(), drums.end(), same)) return;
  drums.push_back({.name = node.name,
                   .tension = 0,
                   .haul = 0,
                   .fleet_angle = {},
                   .layers = {},
                   .first_radius = {},
                   .last_radius = {},
                   .lacks = lacks_of_layers(model.drums[*node.drum], rope.diameter)});
}

void RopeUses::take(const machine::Model& model, const solve::EquilibriumResult& state, const std::string& words) {
  take_forces(model, state, words);
  Array<solve::DrumResult> ends = solve::drums(model, state);
  for (const solve::DrumResult& d : ends) {
    const auto directions = [&](const solve::BranchResult& b) { return ends_of(state.state, b); };
    take_drum(model, state.state, d, beside_drum(state.branches, d.reeving, d.at_end, directions));
  }
  for (solve::DrumResult& d : ends) d.torque = d.radius * solve::largest_at_end(model, state, d.reeving, d.at_end);
  for (const solve::DrumResult& d : ends) {
    rope::DrumEnd& known = drum_end(model, d);
    known.haul = std::max(known.haul, haul_of(ends, d));
  }
}

void RopeUses::take_empty(const machine::Model& model, const solve::EquilibriumResult& state,
                          const std::string& words) {
  take_forces(model, state, words);
}

Array<int> RopeUses::uses_in(const machine::Model& model) const {
  Array<int> own(model.reevings.size(), -1);
  for (std::size_t i = 0; i < own.size(); ++i) {
    const auto use =
        std::find_if(uses_.begin(), uses_.end(), [&](const auto& one) { return one.name == model.reevings[i].name; });
    if (use != uses_.end()) own[i] = static_cast<int>(use - uses_.begin());
  }
  return own;
}

namespace {

/// Of an analysis at rest.
void take_largest(double T, const std::string& words, rope::RopeUse& use) {
  use.analysed = use.analysed || (T > 0 && !rope::goes_beyond_rest(use.tension, T));
  if (T <= use.tension) return;
  use.tension = T;
  use.where = words;
  use.lasts = false;
}

}  // namespace

void RopeUses::take_forces(const machine::Model& model, const solve::EquilibriumResult& state,
                           const std::string& words) {
  const Array<int> own = uses_in(model);
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (own[i] < 0) continue;
    take_largest(state.ropes[i].T_max, words, uses_[as_size(own[i])]);
  }
  Array<std::map<std::string, int>> met(model.reevings.size());
  Array<std::vector<Turned>> turned(uses_.size());
  for (const solve::ContactResult& c : state.contacts) {
    machine::Node node = model.reevings[c.reeving].nodes[c.node];
    if (own[c.reeving] < 0 || !(node.radius > 0)) continue;
    if (!state.state.sides.empty()) node.side = state.state.sides[c.reeving][c.node];
    const Vector3 axis = axis_of(state.state, node);
    auto& [bend, side, order] = bend_at(as_size(own[c.reeving]), node, met[c.reeving][node.name]++, axis);
    if (c.state == solve::ContactState::lifted) continue;
    turn(bend, side, node.side, axis);
    if (bend.kind != rope::BendKind::saddle) turned[as_size(own[c.reeving])].push_back({&bend, node.side * axis});
    bend.tension = std::max(bend.tension, largest(c));
    bend.wrap = std::max(bend.wrap, c.wrap);
  }
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (own[i] >= 0) compare_neighbours(model.reevings[i], state.state, as_size(own[i]), std::move(turned[own[i]]));
  }
  for (const solve::BranchResult& s : state.branches) {
    const machine::Reeving& rope = model.reevings[s.reeving];
    if (own[s.reeving] < 0 || rope.closed) continue;
    if (s.from == 0) raise_end(as_size(own[s.reeving]), rope.nodes.front(), false, std::max(s.T_from, s.T_from_max));
    if (as_size(s.to) + 1 == rope.nodes.size())
      raise_end(as_size(own[s.reeving]), rope.nodes.back(), true, std::max(s.T_to, s.T_to_max));
  }
}

/// The largest tension may be that of the last step. Where a signal has not come to its end, an earlier peak or a swing
/// may hide that the tension grows: then the largest of the last moments counts beside that of as many before them.
/// Where a signal swings by itself, it takes more of them.
void RopeUses::take_growth(int reeving, const solve::Extreme& T, const machine::GoesOn& then, bool slowly,
                           const std::string& words, double rest) {
  constexpr double same_time = 1e-9;  // relative; the last step and the last output differ by rounding
  const LastingTension& lasting = lasting_[reeving];
  const bool at_last = T.t_max >= (1 - same_time) * lasting.last_moment();
  // each moment of a slow motion is at rest, where it may well end
  const bool peaks = at_last && (then.ramps || !slowly) && T.max > (1 + still_grows) * lasting.before_end();
  const bool grows = (then.ramps && lasting.growth(LastingTension::gap) > still_grows) ||
                     ((then.ramps || then.swings) && lasting.growth(LastingTension::lasts / 2) > still_grows);
  if (!peaks && !grows) return;
  const double ends_with = peaks ? T.max : lasting.largest_within(LastingTension::gap);
  if (!rope::goes_beyond_rest(ends_with, rest)) return;
  const rope::RopeUse& use = uses_[reeving];
  growing_.emplace_back(
      use.name,
      fmt::format("{}: the tension of {} {} where the motion ends, {} at t = {:.4g} s: its peak may lie behind the "
                  "end; give a longer 'duration'",
                  words, use.name, peaks ? "is largest" : "still grows", use.display.brief(ends_with, si::N),
                  lasting.last_moment()));
}

void RopeUses::take_motion(int reeving, const solve::RopeExtreme& extreme, bool slowly, const machine::GoesOn& then,
                           const std::string& words) {
  rope::RopeUse& use = uses_[reeving];
  const solve::Extreme& T = extreme.T;
  const double rest = std::max(use.tension, extreme.T_static);
  const std::string peak_words = fmt::format("{}, t = {:.4g} s", words, T.t_max);
  const auto take_tension = [&](double tension, const std::string& where, bool lasts, bool analysed) {
    if (!(tension > use.tension)) return;  // nor one that is not known
    const bool known = use.analysed && !rope::goes_beyond_rest(tension, use.tension);
    use.tension = tension;
    use.where = where;
    use.lasts = lasts;
    use.analysed = analysed || known;
  };
  if (slowly) take_tension(T.max, peak_words, false, true);
  take_tension(extreme.T_static, words + ", before it begins", false, false);
  const LastingTension& lasting = lasting_[reeving];
  take_tension(lasting.largest(),
               fmt::format("{}, for {:g} s until t = {:.4g} s", words, LastingTension::lasts, lasting.when()), true,
               false);
  use.last = std::max(use.last, lasting.at_end());
  if (lasting.mean() > use.mean) {
    use.mean = lasting.mean();
    use.mean_where =
        fmt::format("{}, over {:g} s until t = {:.4g} s", words, LastingTension::lasts, lasting.when_mean());
  }
  take_growth(reeving, T, then, slowly, words, slowly ? rest : use.tension);
  if (T.max <= use.peak) return;
  use.peak = T.max;
  use.peak_where = peak_words;
}

void RopeUses::compare_neighbours(const machine::Reeving& rope, const machine::State& state, std::size_t own,
                                  std::vector<Turned> along) {
  const auto drum_at = [&](bool at_end) -> std::optional<Turned> {
    const machine::Node& node = at_end ? rope.nodes.back() : rope.nodes.front();
    const auto found = bends_[own].find(key_of_drum(node, at_end));
    if (rope.closed || !node.drum || found == bends_[own].end()) return std::nullopt;
    return Turned{.bend = &found->second.bend, .about = node.side * axis_of(state, node)};
  };
  if (const auto first = drum_at(false)) along.insert(along.begin(), *first);
  if (const auto last = drum_at(true)) along.push_back(*last);
  for (std::size_t k = 1; k < along.size(); ++k) {
    if (rope::turns_back(along[k - 1].about, along[k].about)) along[k].bend->turned_back = true;
  }
}

RopeUses::Met& RopeUses::bend_at(std::size_t reeving, const machine::Node& node, int times, const Vector3& axis) {
  auto& known = bends_[reeving];
  const Met fresh{.bend = {.name = node.name,
                           .kind = kind_of(node),
                           .diameter = 2 * node.radius,
                           .tension = 0,
                           .wrap = 0,
                           .about = node.side * axis},
                  .order = static_cast<int>(known.size())};
  return known.try_emplace(fmt::format("{} {}", node.name, times), fresh).first->second;
}

rope::DrumEnd& RopeUses::drum_end(const machine::Model& model, const solve::DrumResult& d) {
  const machine::Reeving& rope = model.reevings[d.reeving];
  const machine::Node& node = d.at_end ? rope.nodes.back() : rope.nodes.front();
  auto& drums = uses_[d.reeving].drums;
  return *std::find_if(drums.begin(), drums.end(), [&](const rope::DrumEnd& one) { return one.name == node.name; });
}

void RopeUses::take_drum(const machine::Model& model, const machine::State& state, const solve::DrumResult& d,
                         const BesideDrum& beside) {
  const machine::Reeving& rope = model.reevings[d.reeving];
  const machine::Node& node = d.at_end ? rope.nodes.back() : rope.nodes.front();
  const machine::Drum& drum = model.drums[d.drum];
  rope::DrumEnd& known = drum_end(model, d);
  if (drum.width > 0) {
    const machine::Node& next = rope.nodes[as_size(beside.next)];
    const double angle = fleet_angle_of(state, node, next, drum.width - rope.diameter, beside);
    known.fleet_angle = std::max(known.fleet_angle.value_or(0), angle);
  }
  const rope::DrumLayers measures = machine::measures_of(drum, rope.diameter);
  if (!(measures.width > 0) || !d.length) return;
  const int layers = std::max(d.filled.value_or(1), known.layers.value_or(1));
  known.layers = layers;
  known.first_radius = rope::layer_radius(measures, 1);
  known.last_radius = rope::layer_radius(measures, layers);
}

void RopeUses::take_moment(const machine::Model& model, const solve::TransientFrame& frame, long steps, bool at_rest) {
  Array<double> largest(uses_.size(), 0.0);
  for (const auto& s : frame.branches) largest[s.reeving] = std::max({largest[s.reeving], s.T_from, s.T_to});
  for (std::size_t i = 0; i < largest.size(); ++i) lasting_[i].take(frame.t, largest[i], steps);
  const machine::State places = places_of(frame);
  std::map<std::pair<int, std::string>, int> met;
  Array<std::vector<Turned>> turned(uses_.size());
  for (const auto& c : frame.contacts) {
    const machine::Node& node = model.reevings[c.reeving].nodes[c.node];
    if (!(node.radius > 0)) continue;
    const Vector3 axis = axis_of(places, node);
    auto& [bend, side, order] = bend_at(as_size(c.reeving), node, met[{c.reeving, node.name}]++, axis);
    if (c.state == solve::ContactState::lifted) continue;
    turn(bend, side, c.side, axis);
    if (bend.kind != rope::BendKind::saddle) turned[as_size(c.reeving)].push_back({&bend, c.side * axis});
    bend.wrap = std::max(bend.wrap, c.wrap);
    if (at_rest) bend.tension = std::max({bend.tension, c.T_in, c.T_out});
  }
  for (std::size_t i = 0; i < turned.size(); ++i)
    compare_neighbours(model.reevings[i], places, i, std::move(turned[i]));
  const Array<solve::DrumResult> ends = solve::drums(model, frame);
  for (const solve::DrumResult& d : ends) {
    const auto directions = [](const solve::TransientFrame::Branch& b) { return std::pair(b.leaves, b.arrives); };
    take_drum(model, places, d, beside_drum(frame.branches, d.reeving, d.at_end, directions));
    const double haul = haul_of(ends, d);
    LastingTension& lasting = lasting_hauls_[{d.reeving, d.at_end}];
    lasting.take(frame.t, haul, steps);
    rope::DrumEnd& known = drum_end(model, d);
    known.haul = std::max({known.haul, lasting.largest(), at_rest ? haul : 0});
    known.haul_peak = std::max(known.haul_peak, haul);
  }
  for (const auto& s : frame.branches) {
    const machine::Reeving& rope = model.reevings[s.reeving];
    if (!at_rest || rope.closed) continue;
    if (s.from == 0) raise_end(as_size(s.reeving), rope.nodes.front(), false, s.T_from);
    if (as_size(s.to) + 1 == rope.nodes.size()) raise_end(as_size(s.reeving), rope.nodes.back(), true, s.T_to);
  }
}

void RopeUses::raise_end(std::size_t reeving, const machine::Node& node, bool at_end, double T) {
  const auto raise = [&](auto& all) {
    for (auto& end : all) {
      if (end.name == node.name) end.tension = std::max(end.tension, T);
    }
  };
  raise(uses_[reeving].ends);
  if (!node.drum) return;
  raise(uses_[reeving].drums);
  const auto found = bends_[reeving].find(key_of_drum(node, at_end));
  if (found == bends_[reeving].end()) return;
  rope::Bend& bend = found->second.bend;
  bend.tension = std::max(bend.tension, T);
}

std::vector<rope::RopeUse> RopeUses::all() const {
  std::vector<rope::RopeUse> all = uses_;
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::vector<Met> met;
    met.reserve(bends_[i].size());
    for (const auto& [key, one] : bends_[i]) met.push_back(one);
    std::stable_sort(met.begin(), met.end(), [](const Met& a, const Met& b) { return a.order < b.order; });
    const double least = lasting_[i].largest();
    for (Met& one : met) {
      // a round that the rope comes to in a motion alone has the tension of the whole rope
      const double own = one.bend.tension > 0 ? least : all[i].tension;
      if (one.bend.wrap >= rope::least_wrap) one.bend.tension = std::max(one.bend.tension, own);
      all[i].bends.push_back(std::move(one.bend));
    }
    for (rope::RopeEnd& end : all[i].ends) end.tension = std::max(end.tension, least);
    for (rope::DrumEnd& end : all[i].drums) end.tension = std::max(end.tension, least);
  }
  return all;
}

}  // namespace taut::checks
