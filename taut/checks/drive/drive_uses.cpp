#include "taut/checks/drive/drive_uses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "taut/calc/shown.hpp"
#include "taut/calc/verdict.hpp"
#include "taut/checks/drive/cylinders.hpp"
#include "taut/checks/guy/guy_checks.hpp"
#include "taut/solve/drives.hpp"

namespace taut::checks {
namespace {

/// Of the way of a rim, and of its radius: below, a rope creeps on it as in every start, above it slips.
constexpr double least_slip = 0.01, least_way = 1e-3;
constexpr double least_slide = 0.1;  ///< of the radius: a way that no creep beside a jump of tension makes

/// Above the pull at rest by so much, a motion may still swing (rope::goes_beyond_rest).
constexpr double still_swings = 0.05;

/// Whether a motor's torque is no more than a limit: with the length and all loads given there is nothing it could set.
bool is_limit(const machine::Reeving& r) {
  const bool open = std::any_of(r.nodes.begin(), r.nodes.end(), [](const machine::Node& n) {
    return n.kind == machine::NodeKind::load && n.load.open;
  });
  return r.closed && r.given == machine::Given::length && r.nodes.front().tension_drop && !open;
}

/// Checks that lack a number, by part and name, and why.
using Unmade = std::map<std::pair<Part, std::string>, std::string>;

Part drum_part(const machine::Drum& drum) { return {.kind = PartKind::drum, .name = drum.name}; }
Part sheave_part(const std::string& name) { return {.kind = PartKind::sheave, .name = name}; }

/// "winch.brake_torque"
Check check_of(const Part& part, const char* name, double value, const Unit& unit, Bound bound) {
  Check c = make_check(fmt::format("{}.{}", part.name, name), value, unit, std::move(bound));
  c.part = part.name;
  c.kind = part.kind;
  return c;
}

/// What a torque over time can be at most is known of a constant, a ramp, steps and a table. What stands needs the
/// torque that the motor keeps.
std::optional<machine::SignalRange> torque_range(const Part& part, const machine::Signal& torque, Unmade& unmade) {
  auto range = machine::range_of(torque);
  if (range) return range;
  unmade.try_emplace({part, "torque"},
                     fmt::format("{}.torque is not checked: the largest value of the signal '{}' is not known: give a "
                                 "constant torque, a ramp or a table",
                                 part.name, torque.name));
  return std::nullopt;
}

void check_grip(const machine::Node& own, const solve::DriveResult& d, std::vector<Check>& made) {
  if (!std::isfinite(own.law.friction)) return;
  made.push_back(check_of(
      sheave_part(own.name), "grip", d.ratio, si::one,
      {.sense = Sense::at_most,
       .limit = d.limit,
       .rule = d.centrifugal > 0 ? "ratio of tensions less m v^2 that friction holds, exp(mu theta), Euler-Eytelwein"
                                 : "ratio of tensions that friction holds, exp(mu theta), Euler-Eytelwein",
       .trust = "derived"}));
}

/// The torque of a motor is positive along the path. One way alone it drives, and does not hold back.
void check_motor_torque(const machine::Model& m, const solve::DriveResult& d, std::vector<Check>& made,
                        Unmade& unmade) {
  const machine::Node& own = m.reevings[d.reeving].nodes[d.node];
  const auto range = torque_range(sheave_part(own.name), m.motors[*own.motor].drive.signal, unmade);
  if (!range) return;
  const double rounding = 1e-9 * m.reevings[d.reeving].copies * own.radius * (d.T_in + d.T_out);
  const double torque = std::abs(d.torque) > rounding ? d.torque : 0;
  const bool other_way = (torque > 0 && range->most <= 0) || (torque < 0 && range->least >= 0);
  if (other_way && std::abs(torque) <= range->kept) {
    unmade.try_emplace({sheave_part(own.name), "torque"},
                       fmt::format("{0}.torque is not checked: the motor's torque acts {1} the path of the rope, and "
                                   "the rope needs one {2} it: give the torque its other sign, or let the rope run "
                                   "the other way with 'motion'",
                                   own.name, torque > 0 ? "against" : "along", torque > 0 ? "along" : "against"));
    return;
  }
  made.push_back(
      check_of(sheave_part(own.name), "torque", std::abs(torque), si::N_m,
               {.sense = Sense::at_most, .limit = range->kept, .rule = "the motor's torque", .trust = "user"}));
}

void check_drive(const machine::Model& m, const solve::DriveResult& d, std::vector<Check>& made, Unmade& unmade) {
  const machine::Node& own = m.reevings[d.reeving].nodes[d.node];
  check_grip(own, d, made);
  if (!own.motor || own.kind != machine::NodeKind::drive || !is_limit(m.reevings[d.reeving])) return;
  check_motor_torque(m, d, made, unmade);
}

bool is_broken(const solve::TransientFrame& frame, int reeving) {
  return std::any_of(frame.branches.begin(), frame.branches.end(),
                     [&](const auto& branch) { return branch.reeving == reeving && !branch.whole; });
}

/// A rope that slips stands at the limit, to the accuracy of a step: by how far it slips is a check of its own.
void check_grips(const machine::Model& m, const solve::TransientFrame& frame, std::vector<Check>& made) {
  for (solve::DriveResult& d : solve::drives(m, frame)) {
    if (is_broken(frame, d.reeving)) continue;
    d.ratio = std::min(d.ratio, d.limit);
    check_grip(m.reevings[d.reeving].nodes[d.node], d, made);
  }
}

/// All ropes of a drum together.
struct DrumLoad {
  double torque = 0;   ///< N m
  bool stands = true;  ///< none of them runs
};
/// `flow`: by reeving, how it runs at its nodes; empty: all stand.
std::map<int, DrumLoad> loads_of(const Array<solve::DrumResult>& ends, const Array<Array<int>>& flow) {
  std::map<int, DrumLoad> loads;
  for (const solve::DrumResult& d : ends) {
    DrumLoad& load = loads[d.drum];
    load.torque += d.sense * d.torque;
    if (flow.empty()) continue;
    const Array<int>& runs = flow[d.reeving];
    load.stands = load.stands && std::all_of(runs.begin(), runs.end(), [](int f) { return f == 0; });
  }
  for (auto& [drum, load] : loads) load.torque = std::abs(load.torque);
  return loads;
}

/// What a drum bears where the machine of a state stands while its ropes run. Over losses the tension of a rope falls
/// or grows from the drum on; at rest its pull lies between the smallest and the largest. Ropes that hold each other on
/// the drum need not be at the same end of that.
template <class Branches>
BorneAtRest borne_at_rest(const Array<solve::DrumResult>& ends, const Branches& branches, int drum) {
  double low = 0, high = 0;
  for (const solve::DrumResult& d : ends) {
    if (d.drum != drum || !(d.pull > 0)) continue;
    double least = 1, most = 1;
    for (const auto& branch : branches) {
      if (branch.reeving != d.reeving) continue;
      least = std::min({least, branch.T_from / d.pull, branch.T_to / d.pull});
      most = std::max({most, branch.T_from / d.pull, branch.T_to / d.pull});
    }
    low += d.torque * (d.sense > 0 ? least : -most);
    high += d.torque * (d.sense > 0 ? most : -least);
  }
  const double least = low <= 0 && high >= 0 ? 0 : std::min(std::abs(low), std::abs(high));
  return {.least = least, .most = std::max(std::abs(low), std::abs(high))};
}

/// Of an equilibrium.
Situation situation_at(const machine::Model& m, const solve::EquilibriumResult& state) {
  Array<Vector3> places;
  const auto take_place = [&](const machine::Place& place) {
    if (place.body != machine::ground) places.push_back(machine::in_ground(state.state, place));
  };
  for (std::size_t b = 0; b < m.bodies.size(); ++b) {
    places.push_back(state.state.bodies[b].position);
    take_place({.body = static_cast<int>(b), .at = m.bodies[b].centre});
  }
  for (const machine::Reeving& rope : m.reevings) {  // a body may turn about its origin
    for (const machine::Node& node : rope.nodes) take_place(node.at);
  }
  return situation_of(m, std::move(places));
}

/// What certainly stays of it where its swings have ceased.
double lasting(const LastingTension& borne) {
  return std::max({borne.largest(), borne.mean(), borne.at_end()}) / (1 + still_swings);
}

/// Where the torque of a drum is given, the rope's tension follows from it, or it is a limit; not of a drum whose brake
/// is set, against any drive.
void check_torque(const machine::Drum& drum, const DrumLoad& d, std::vector<Check>& made, Unmade& unmade) {
  if (drum.drive.kind != machine::DriveKind::torque || drum.drive.brake) return;
  const double given = machine::at(drum.drive.signal, 0).value;
  if (d.torque >= given * (1 - 1e-9) && d.torque <= given * (1 + 1e-9)) return;
  const auto range = torque_range(drum_part(drum), drum.drive.signal, unmade);
  if (!range) return;
  const double limit = std::min(range->most, range->kept);
  made.push_back(check_of(drum_part(drum), "torque", d.torque, si::N_m,
                          {.sense = Sense::at_most, .limit = limit, .rule = "the drum's torque", .trust = "user"}));
}

/// A drum that stands does so by its brake, or, where that is not set, by a motor with a torque or a pull.
bool stands_by_brake(const machine::Drum& drum) {
  if (!drum.brake) return false;
  const bool by_motor = drum.drive.kind == machine::DriveKind::torque || drum.drive.kind == machine::DriveKind::pull;
  return drum.drive.brake || !by_motor;
}

/// Its brake is open, and nothing drives it.
bool turns_freely(const machine::Drum& drum) {
  return drum.drive.kind == machine::DriveKind::free && !drum.drive.brake;
}

/// It has to hold the pull of its rope.
void add_brake_check(const machine::Drum& drum, const DrumLoad& d, std::vector<Check>& made) {
  made.push_back(check_of(
      drum_part(drum), "brake_torque", d.torque, si::N_m,
      {.sense = Sense::at_most, .limit = drum.brake->torque, .rule = "what its brake holds", .trust = "user"}));
}

/// All ropes of a drum, against what it takes of each alone.
void check_capacities(const machine::Model& m, const Array<solve::DrumResult>& ends, std::vector<Check>& made) {
  std::map<int, double> used;  // of the drum, as a share
  std::map<int, int> on_drum;  // ends of ropes
  for (const solve::DrumResult& d : ends) {
    ++on_drum[d.drum];
    if (d.length && d.capacity.value_or(0) > 0) used[d.drum] += m.reevings[d.reeving].copies * *d.length / *d.capacity;
  }
  for (const solve::DrumResult& d : ends) {
    if (!d.length || !d.capacity) continue;
    // within flanges that hold no layer there is no share of it
    const int copies = m.reevings[d.reeving].copies;
    const double all = *d.capacity > 0 ? used[d.drum] * *d.capacity : copies * *d.length;
    const bool shared = copies > 1 || on_drum[d.drum] > 1;
    made.push_back(check_of(
        drum_part(m.drums[d.drum]), "capacity", all, si::m,
        {.sense = Sense::at_most,
         .limit = *d.capacity,
         .rule = fmt::format("rope that the drum takes within its flanges{}", shared ? ", all its ropes together" : ""),
         .trust = "derived"}));
  }
}

/// A motion ends where a drum has no rope left.
void check_rest_of_rope(const machine::Model& m, const solve::DrumResult& d, std::vector<Check>& made) {
  if (!d.length || *d.length >= 0) return;
  made.push_back(check_of(drum_part(m.drums[d.drum]), "length_on_drum", *d.length, si::m,
                          {.sense = Sense::at_least, .limit = 0, .rule = "rope left on the drum", .trust = "derived"}));
}

}  // namespace

void DriveUses::keep(std::vector<Check> made, const std::string& words) {
  for (Check& check : made) {
    check.where = words;
    const auto key = std::pair(check.name, check.kind);
    const auto known = worst_.find(key);
    if (known == worst_.end()) {
      worst_.emplace(key, std::move(check));
    } else if (worse_state(check, known->second)) {
      known->second = std::move(check);
    }
  }
}

void DriveUses::take_grips(const machine::Model& m) {
  for (const machine::Reeving& rope : m.reevings) {
    for (const machine::Node& node : rope.nodes) {
      if (!node.motor || std::isfinite(node.law.friction)) continue;
      unmade_.try_emplace({sheave_part(node.name), "grip"},
                          fmt::format("{}.grip is not checked: nothing says how well the rope "
                                      "holds on the driven sheave: give its 'friction'",
                                      node.name));
    }
  }
}

/// The turns on a drum take the tension from the rope's fastening by their friction.
void DriveUses::keep_turns(const machine::Model& m, const solve::DrumResult& d, const std::string& words) {
  if (!d.length) return;
  if (m.drums[d.drum].core_radius == 0) {  // half of a rope's thickness is no radius to count turns by
    const std::string& name = m.drums[d.drum].name;
    unmade_.try_emplace({drum_part(m.drums[d.drum]), "turns"},
                        fmt::format("{}: how many turns are left on it is not checked: give its "
                                    "'core_diameter'",
                                    name));
    return;
  }
  const double left = d.wraps.value_or(std::max(*d.length, 0.0) / (2 * std::numbers::pi * d.radius));
  const auto [at, is_new] = turns_.try_emplace(m.drums[d.drum].name, Turns{.left = left, .words = words});
  if (!is_new && left < at->second.left) at->second = {.left = left, .words = words};
}

/// Pulls, torques and brakes are those of the layer that the machine is calculated with.
void DriveUses::keep_layer(const machine::Model& m, const solve::DrumResult& d, const std::string& words) {
  if (d.filled.value_or(0) <= d.layer) return;
  const machine::Drum& drum = m.drums[d.drum];
  const bool braked = stands_by_brake(drum);
  if (braked || drum.drive.kind == machine::DriveKind::torque) {
    const char* const check = braked ? "brake_torque" : "torque";
    unmade_.try_emplace({drum_part(drum), check},
                        fmt::format("{}.{} is not checked in layer {}, which the rope reaches ({}), but in layer "
                                    "{}: give 'layers: auto'",
                                    drum.name, check, *d.filled, words, d.layer));
    return;
  }
  layers_.try_emplace(drum_part(drum),
                      fmt::format("{}: the rope on '{}' reaches layer {}, but its torque is that of layer "
                                  "{}: give 'layers: auto'",
                                  words, drum.name, *d.filled, d.layer));
}

/// A flange limits the layers. What they hold has to be known, and what lies on them.
void DriveUses::keep_flange(const machine::Model& m, const solve::DrumResult& d) {
  const machine::Drum& drum = m.drums[d.drum];
  if (drum.flange_diameter == 0 || (d.capacity && d.length)) return;
  const double diameter = m.reevings[d.reeving].diameter;
  const char* const missing = drum.width == 0         ? "give its 'face_width'"
                              : drum.core_radius == 0 ? "give its 'core_diameter'"
                              : diameter == 0         ? "give the 'diameter' of its rope"
                              : drum.width < diameter ? "its rope is thicker than the face is wide"
                                                      : "give its 'length_on_drum'";
  unmade_.try_emplace({drum_part(drum), "capacity"},
                      fmt::format("{}.capacity is not checked: whether the rope stays within the flange of "
                                  "{} is not known: {}",
                                  drum.name, display_.brief(drum.flange_diameter, si::m.in("mm")), missing));
}

/// Statics lets every drum stand.
void DriveUses::keep_free(const machine::Drum& drum, double torque, const std::string& words) {
  if (torque == 0) return;
  unmade_.try_emplace(
      {drum_part(drum), "free"},
      fmt::format("{}: nothing holds '{}', whose brake is open, against the {} of its rope: set the brake, "
                  "or give a drive",
                  words, drum.name, display_.brief(torque, si::N_m)));
}

void DriveUses::take(const machine::Model& m, const solve::EquilibriumResult& state, const std::string& words) {
  std::vector<Check> made;
  for (const auto& d : solve::drives(m, state)) check_drive(m, d, made, unmade_);
  keep_runs(m, state, words);
  const Array<solve::DrumResult> ends = solve::drums(m, state);
  keep_winding(m, ends, state.flow);
  keep_senses(m, ends, state, words);
  for (const auto& [drum, load] : loads_of(ends, state.flow)) {
    check_torque(m.drums[drum], load, made, unmade_);
    if (turns_freely(m.drums[drum])) {
      keep_free(m.drums[drum], load.torque, words);
      continue;
    }
    if (!m.drums[drum].brake) continue;
    const std::string& name = m.drums[drum].name;
    if (load.stands && stands_by_brake(m.drums[drum])) {
      add_brake_check(m.drums[drum], load, made);
      brakes_.show(name, situation_at(m, state), load.torque);
    } else {
      brakes_.leave_out(name, situation_at(m, state), borne_at_rest(ends, state.branches, drum),
                        m.drums[drum].brake->torque, words);
    }
  }
  check_capacities(m, ends, made);
  for (const auto& d : ends) {
    check_rest_of_rope(m, d, made);
    keep_turns(m, d, words);
    keep_layer(m, d, words);
    keep_flange(m, d);
  }
  keep(std::move(made), words);
}

void DriveUses::take_bound(const machine::Model& m, const solve::EquilibriumResult& bound, const std::string& words) {
  std::vector<Check> made;
  for (const auto& d : solve::drives(m, bound)) check_drive(m, d, made, unmade_);
  keep_runs(m, bound, words);
  keep(std::move(made), words);
}

/// Swings of a motion go above the pull at rest: what lasts counts, or what it ends with.
void DriveUses::take_turning(const machine::Model& m, const solve::TransientFrame& frame, int drum, long steps) {
  const BorneAtRest borne = borne_at_rest(solve::drums(m, frame), frame.branches, drum);
  Turning& turning = turning_[drum];
  turning.least.take(frame.t, borne.least, steps);
  turning.most.take(frame.t, borne.most, steps);
}

void DriveUses::take_moment(const machine::Model& m, const solve::TransientFrame& frame, long steps, bool slowly,
                            const std::string& words) {
  const std::string when = fmt::format("{}, t = {:.4g} s", words, frame.t);
  take_cylinders(m, frame, {.words = when, .slowly = slowly, .display = display_}, yielding_);
  const auto drums = solve::drums(m, frame);
  const double time = last_moment_ ? frame.t - *last_moment_ : 0;
  last_moment_ = frame.t;
  take_slips(m, frame, time, words);
  take_way(drums, time);
  if (!(time > 0)) turning_.clear();  // a motion begins
  std::vector<Check> made;
  check_grips(m, frame, made);
  dragged_.take_moment(m, frame, time, words);
  check_capacities(m, drums, made);
  for (const auto& [drum, load] : loads_of(drums, {})) {
    if (!m.drums[drum].brake) continue;
    // a motion lets a drum stand whatever that takes, but in a brake that is set; one that is driven at other times
    // stands without a load before it takes one: that shows nothing
    const bool by_itself =
        frame.drums[drum].held && (m.drums[drum].drive.kind == machine::DriveKind::held || load.torque > 0);
    if (!by_itself && !frame.drums[drum].braked) {
      take_turning(m, frame, drum, steps);
      continue;
    }
    add_brake_check(m.drums[drum], load, made);
    brakes_.show(m.drums[drum].name, situation_of(m), load.torque);
  }
  for (const auto& d : drums) {
    keep_turns(m, d, when);
    keep_layer(m, d, when);
    keep_flange(m, d);
  }
  keep(std::move(made), when);
}

/// A rope creeps over its driven sheave by its stretch, a small share of the rim's way. Where it is faster than that
/// against the rim it slips; the ways of these moments add up.
void DriveUses::take_slips(const machine::Model& m, const solve::TransientFrame& frame, double time,
                           const std::string& words) {
  if (slides_.size() != frame.contacts.size() || !(time > 0)) {  // a motion begins
    slides_.assign(frame.contacts.size(), {});
    for (std::size_t c = 0; c < slides_.size(); ++c) slides_[c].speed = std::abs(frame.contacts[c].slip);
    return;
  }
  for (std::size_t c = 0; c < frame.contacts.size(); ++c) {
    const solve::TransientFrame::Contact& is = frame.contacts[c];
    const machine::Node& node = m.reevings[is.reeving].nodes[is.node];
    const double slip = std::abs(is.slip), mean = (slip + slides_[c].speed) / 2;
    slides_[c].speed = slip;
    if (!node.motor || slip < least_slip * std::abs(is.spin) * node.radius) continue;
    if (is_broken(frame, is.reeving)) continue;
    slides_[c].way += mean * time;
    keep_slip(node, slides_[c].way, least_slide * node.radius, "", words);
  }
}

/// How far a rope has slipped on a driven sheave, m; creep stays below `limit`.
void DriveUses::keep_slip(const machine::Node& node, double slipped, double limit, const std::string& share,
                          const std::string& words) {
  if (!(slipped > limit)) return;
  Slip& largest = slips_[sheave_part(node.name)];
  if (slipped <= largest.slipped) return;
  largest = {.slipped = slipped,
             .limit = limit,
             .words = fmt::format("{}: the rope slips on '{}' by {}{}", words, node.name,
                                  display_.brief(slipped, si::m), share),
             .where = words};
}

/// Of a motion without a step, which is a place of rest: no brake can slip there.
void DriveUses::take_set_brakes(const machine::Model& m, const solve::TransientFrame& rest, const std::string& words) {
  std::vector<Check> made;
  for (const auto& [drum, load] : loads_of(solve::drums(m, rest), {})) {
    if (!stands_by_brake(m.drums[drum]) || !m.drums[drum].drive.brake) continue;
    add_brake_check(m.drums[drum], load, made);
    brakes_.show(m.drums[drum].name, situation_of(m), load.torque);
  }
  keep(std::move(made), words);
}

void DriveUses::take(const machine::Model& m, const solve::TransientResult& motion, const std::string& words) {
  for (const auto& [part, told] : dragged_.at_end(m, motion)) {
    if (!yielding_.contains(part)) unbraked_.try_emplace(part, told);  // one at its limit has its own warning
  }
  slides_.clear();
  last_moment_.reset();
  for (std::size_t d = 0; d < m.drums.size(); ++d) {
    const machine::Drum& drum = m.drums[d];
    if (!drum.brake) continue;
    const auto turns = turning_.find(static_cast<int>(d));
    const bool acted = d < motion.brake_ways.size() && motion.brake_ways[d].acted;
    if (acted) brakes_.show(drum.name, situation_of(m), 0);  // its slip judges it
    if (turns != turning_.end()) {
      const auto& [least, most] = turns->second;
      const BorneAtRest borne{.least = lasting(least), .most = lasting(most)};
      brakes_.leave_out(drum.name, situation_of(m), borne, drum.brake->torque, words);
    } else if (!acted) {
      brakes_.leave_out(drum.name, situation_of(m), {}, drum.brake->torque, words);
    }
  }
  turning_.clear();
  take_hauled(m, words);
  const solve::TransientFrame& first = motion.frames.front();
  take_winding(m, solve::drums(m, first));
  if (motion.brake_ways.empty()) take_set_brakes(m, first, words);
  for (std::size_t c = 0; c < motion.ways.size(); ++c) {
    const int reeving = first.contacts[c].reeving;
    const machine::Node& node = m.reevings[reeving].nodes[first.contacts[c].node];
    if (!node.motor || is_broken(motion.frames.back(), reeving)) continue;
    const auto [slipped, rim] = motion.ways[c];
    const std::string share = slipped < rim ? fmt::format(", {:.3g} % of the way of its rim", 100 * slipped / rim) : "";
    keep_slip(node, slipped, std::max(least_slip * rim, least_way * node.radius), share, words);
  }
  take_brakes(m, motion, words);
}

void DriveUses::take_brakes(const machine::Model& m, const solve::TransientResult& motion, const std::string& words) {
  for (std::size_t d = 0; d < motion.brake_ways.size(); ++d) {
    const solve::BrakeWay& slips = motion.brake_ways[d];
    if (slips.let_go) {
      unbraked_.try_emplace(
          drum_part(m.drums[d]),
          fmt::format(
              "{}, t = {:.4g} s: the brake of '{}' is released, or set anew, before it has stopped the drum: its "
              "rope runs at {} then; it does not hold, or is set for too short a time",
              words, *slips.let_go, m.drums[d].name, display_.brief(slips.speed, si::m_per_s)));
    }
    if (slips.way <= least_slip * 2 * std::numbers::pi * m.drums[d].core_radius) continue;
    unbraked_.try_emplace(drum_part(m.drums[d]),
                          fmt::format("{}, t = {:.4g} s: '{}' slips in its brake, which is set and had stopped it, by "
                                      "{} of rope: it does not hold",
                                      words, slips.since, m.drums[d].name, display_.brief(slips.way, si::m)));
  }
  for (std::size_t d = 0; d < motion.state.drum_drive.size(); ++d) {
    const machine::Drive& drive = motion.state.drum_drive[d];
    const double speed = std::abs(motion.frames.back().drums[d].speed);
    if (!drive.brake || speed < standing_drum) continue;
    const std::string since = std::isfinite(drive.brake_since)
                                  ? fmt::format("was set at t = {:.4g} s", drive.brake_since)
                                  : std::string("is set from the start");
    unbraked_.try_emplace(
        drum_part(m.drums[d]),
        fmt::format("{}: '{}' still turns when the motion ends, its rope at {}, though its brake {}: it does not "
                    "hold, or the motion is too short",
                    words, m.drums[d].name, display_.brief(speed, si::m_per_s), since));
  }
}

void DriveUses::add_checks(Result& r) const {
  for (const auto& [name, check] : worst_) r.checks.push_back(check);
  for (const auto& [drum, missing] : brakes_.missing()) {
    const std::string words =
        missing.by_less
            ? fmt::format(
                  "{}.brake_torque is checked under less load only than the drum turns with ({}): add an "
                  "analysis at rest there, with that load",
                  drum, missing.words)
            : fmt::format(
                  "{}.brake_torque is not checked: the drum turns, bears nothing, or is held by its drive, in every "
                  "state ({}); add an analysis at rest in which its brake holds it",
                  drum, missing.words);
    leave_unmade(r, words, {.part = {.kind = PartKind::drum, .name = drum}});
  }
  for (const auto& [rope, words] : paid_out_) {
    if (!hauled_.contains(rope)) leave_unmade(r, words, {.part = {.kind = PartKind::rope, .name = rope}});
  }
  for (const auto& [motor, runs] : runs_) {
    if (!runs.as_driven) leave_unmade(r, runs.words, {.part = sheave_part(motor)});
  }
  for (const auto& [check, words] : unmade_) leave_unmade(r, words, {.part = check.first});
  const auto warn = [&r](const Part& part, const std::string& words) {
    const AboutPart about(r, part);
    warn_unsafe(r, words);
  };
  for (const auto& [part, slip] : slips_) {
    warn(part, slip.words);
    r.checks.push_back(check_of(part, "slipped", slip.slipped, si::m,
                                {.sense = Sense::at_most,
                                 .limit = slip.limit,
                                 .rule = "way that a rope creeps on its sheave",
                                 .trust = "derived"}));
    r.checks.back().where = slip.where;
  }
  for (const auto* const warned : {&unbraked_, &yielding_, &layers_}) {
    for (const auto& [part, words] : *warned) warn(part, words);
  }
  const RuleLimit least = rule_limit("layout.turns_left", false);
  for (const auto& [drum, turns] : turns_) {
    if (turns.left >= least.value) continue;
    warn({.kind = PartKind::drum, .name = drum},
         fmt::format("{}: {:.2g} turns are left on '{}'; at least {:g} have to take the tension from the "
                     "rope's end. Put more rope on it",
                     turns.words, turns.left, drum, least.value));
  }
}

}  // namespace taut::checks
