#include "taut/solve/drives.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include "taut/base/array.hpp"
#include "taut/machine/compile/drums.hpp"
#include "taut/mechanics/bend.hpp"
#include "taut/rope/contact.hpp"
#include "taut/solve/running.hpp"

namespace taut::solve {
namespace {

int sense_of(const Array<int>& flow) {
  const auto moves = std::find_if(flow.begin(), flow.end(), [](int f) { return f != 0; });
  return moves == flow.end() ? 0 : *moves;
}

const ContactResult* contact_at(const EquilibriumResult& result, int reeving, int node) {
  const auto found = std::find_if(result.contacts.begin(), result.contacts.end(),
                                  [&](const ContactResult& c) { return c.reeving == reeving && c.node == node; });
  return found == result.contacts.end() ? nullptr : &*found;
}

double bearing_pull(const machine::Node& node, double T_in, double T_out, double centrifugal) {
  return mechanics::bearing_share(node.law) * (T_in + T_out - 2 * centrifugal);
}

void fill_grip(const machine::Node& node, const machine::Reeving& rope, const std::optional<double>& working_arc,
               DriveResult& d) {
  const double high = std::max(d.T_in, d.T_out), low = std::min(d.T_in, d.T_out);
  d.arc = working_arc ? std::min(*working_arc, d.wrap) : d.wrap;
  d.ratio =
      low > d.centrifugal ? (high - d.centrifugal) / (low - d.centrifugal) : std::numeric_limits<double>::infinity();
  d.creep = (high - low) / rope.stiffness;
  d.limit = std::exp(node.law.friction * d.arc);
  d.slip_arc = std::isinf(node.law.friction) ? 0 : std::log(d.ratio) / node.law.friction;
  d.rest_arc = d.arc - d.slip_arc;
}

/// Where the power of an endless running rope goes. It passes unstretched rope at the rate u everywhere; where its
/// tension grows from T_a to T_b against what holds it, it gives off the integral of v dT = u (T_b - T_a) (1 + (T_a +
/// T_b)/(2 EA)).
void fill_ledger(const machine::Reeving& rope, int sense, const EquilibriumResult& result, DriveResult& d) {
  const double arrives = sense > 0 ? d.T_in : d.T_out;
  const double u = std::abs(*d.speed) / (1 + arrives / rope.stiffness);
  d.power_loads = d.power_losses = d.power_carriages = 0;
  double driven = 0, given = 0;
  for (const ContactResult& c : result.contacts) {
    if (c.reeving != d.reeving || c.state == ContactState::lifted) continue;
    const double grows = sense * (c.T_out - c.T_in);
    const double power = rope.copies * u * grows * (1 + (c.T_in + c.T_out) / (2 * rope.stiffness));
    switch (rope.nodes[c.node].kind) {
      case machine::NodeKind::load:
        *d.power_loads += power;
        break;
      case machine::NodeKind::clamp:
        *d.power_carriages += power;
        break;
      case machine::NodeKind::contact:
        if (!rope.nodes[c.node].tension_drop) {
          *d.power_losses += power;
          break;
        }
        [[fallthrough]];  // another motor helps the drive
      case machine::NodeKind::drive:
        driven -= power;
        given += rope.copies * (c.T_in - c.T_out) * *d.speed;
        *d.power_losses +=
            rope.copies * std::abs(*d.speed) * bearing_pull(rope.nodes[c.node], c.T_in, c.T_out, d.centrifugal);
        break;
      case machine::NodeKind::anchor:
        break;
    }
  }
  d.power_creep = given - driven;
}

/// Nodes of driven sheaves, or of wheels with several grooves.
struct Groove {
  const machine::Reeving* rope;
  const machine::Node* node;
};

}  // namespace

std::optional<std::string> undetermined_drive(const machine::Model& model) {
  std::map<int, Array<Groove>> wheels;
  for (const machine::Reeving& rope : model.reevings) {
    const machine::Node* leads = nullptr;
    for (const machine::Node& node : rope.nodes) {
      if (node.wheel) wheels[*node.wheel].push_back({&rope, &node});
      if (!node.motor || node.tension_drop) continue;
      if (leads != nullptr && leads->name != node.name) {
        return fmt::format(
            "'{}' and '{}' both drive '{}': how they share its pull follows from the creep of the rope, in motion "
            "only; give all motors but one a 'torque'",
            leads->name, node.name, rope.name);
      }
      leads = &node;
    }
  }
  for (const auto& [wheel, grooves] : wheels) {
    const machine::Node& first = *grooves.front().node;
    std::set<const machine::Reeving*> ropes;
    for (const Groove& groove : grooves) ropes.insert(groove.rope);
    const bool by_speed = first.motor && !first.tension_drop;  // it gives each rope what it needs
    if (grooves.size() < 2 || (by_speed && ropes.size() == grooves.size())) continue;
    return fmt::format(
        "'{}' is one wheel with {} grooves: how they share its torque follows from the creep of the ropes, in motion "
        "only",
        first.name, grooves.size());
  }
  return std::nullopt;
}

std::optional<std::string> not_ready(const machine::Model& model) {
  for (const machine::Reeving& rope : model.reevings) {
    if (rope.is_to_install) {
      return fmt::format("the guy '{}' has not been put up: call taut::study::put_up_all(model) first", rope.name);
    }
  }
  return undetermined_drive(model);
}

namespace {

/// What a contact at rest, or of a motion, has for its drive.
template <class Contact>
DriveResult at_contact(const Contact& c, double centrifugal) {
  DriveResult d;
  d.reeving = c.reeving;
  d.node = c.node;
  d.T_in = c.T_in;
  d.T_out = c.T_out;
  d.wrap = c.wrap;
  d.centrifugal = centrifugal;
  return d;
}

}  // namespace

Array<DriveResult> drives(const machine::Model& model, const EquilibriumResult& result) {
  Array<DriveResult> all;
  for (int r = 0; r < static_cast<int>(model.reevings.size()); ++r) {
    const machine::Reeving& rope = model.reevings[r];
    for (int n = 0; n < static_cast<int>(rope.nodes.size()); ++n) {
      const machine::Node& node = rope.nodes[n];
      const bool drives = node.kind == machine::NodeKind::drive || node.tension_drop;
      const ContactResult* c = drives ? contact_at(result, r, n) : nullptr;
      if (c == nullptr) continue;
      DriveResult d = at_contact(*c, centrifugal(rope, result.flow[r]));
      const int sense = sense_of(result.flow[r]);
      d.bearing = std::abs(sense) * bearing_pull(node, d.T_in, d.T_out, d.centrifugal);
      const double pull = rope.copies * (d.T_in - d.T_out + sense * d.bearing);
      d.torque = node.radius * pull;
      fill_grip(node, rope, node.motor ? model.motors[*node.motor].working_arc : std::nullopt, d);
      if (rope.speed > 0 && sense != 0) {
        d.speed = sense * rope.speed;
        d.power = pull * *d.speed;
        if (rope.closed && node.kind == machine::NodeKind::drive) fill_ledger(rope, sense, result, d);
      }
      all.push_back(d);
    }
  }
  return all;
}

Array<DriveResult> drives(const machine::Model& model, const TransientFrame& frame) {
  Array<DriveResult> all;
  for (const TransientFrame::Contact& c : frame.contacts) {
    const machine::Reeving& rope = model.reevings[c.reeving];
    const machine::Node& node = rope.nodes[c.node];
    if (!node.motor || c.state == ContactState::lifted) continue;
    DriveResult d = at_contact(c, c.centrifugal);
    fill_grip(node, rope, model.motors[*node.motor].working_arc, d);
    all.push_back(d);
  }
  return all;
}

namespace {

/// Of the end of a rope that lies on a drum, before it is known in which layer: `pull` at its drum, and the rope on
/// that, m; empty: not known.
DrumResult at_drum(const machine::Model& model, int reeving, bool at_end, double pull, std::optional<double> length) {
  const machine::Reeving& rope = model.reevings[reeving];
  const machine::Node& node = at_end ? rope.nodes.back() : rope.nodes.front();
  const machine::Drum& drum = model.drums[*node.drum];
  DrumResult d;
  d.drum = *node.drum;
  d.reeving = reeving;
  d.at_end = at_end;
  d.pull = pull;
  d.layer = drum.layer;
  d.radius = node.radius;
  d.length = length;
  return d;
}

double stretch_on(const machine::Drum& drum, const machine::Reeving& rope) {
  return 1 + drum.wound_at.value_or(0) / rope.stiffness;
}

/// What the end takes up on its drum, m^3.
double room_of(const machine::Model& model, const DrumResult& d) {
  const machine::Reeving& rope = model.reevings[d.reeving];
  return machine::room_of(d.length.value_or(0) * stretch_on(model.drums[d.drum], rope), rope.diameter, rope.copies);
}

/// The layer that the end reaches where all ropes of its drum take up `room`, and what follows from it.
void set_layer(const machine::Model& model, double room, DrumResult& d) {
  const machine::Reeving& rope = model.reevings[d.reeving];
  const machine::Drum& drum = model.drums[d.drum];
  const rope::DrumLayers measures = machine::measures_of(drum, rope.diameter);
  if (measures.width > 0) {
    const double stretch = stretch_on(drum, rope);
    if (d.length && *d.length >= 0) {
      const rope::OnDrum on = rope::on_drum(measures, room / (rope.diameter * rope.diameter));
      d.filled = on.layer;
      if (drum.automatic_layers) d.layer = on.layer;
      const double share = room > 0 ? room_of(model, d) / (rope.copies * room) : 1;
      d.wraps = share * ((on.layer - 1) * rope::turns_per_layer(measures) + on.turns);
    }
    d.radius = rope::layer_radius(measures, d.layer);
    if (measures.flange_diameter > 0) {
      const int last = rope::layers_within_flanges(measures);
      d.capacity = rope::drum_capacity(measures, last) / stretch;
      if (last > 0) d.pull_last_layer = d.pull * d.radius / rope::layer_radius(measures, last);
    }
  }
  d.torque = rope.copies * d.pull * d.radius;
}

void set_layers(const machine::Model& model, Array<DrumResult>& ends) {
  std::map<int, double> rooms;
  for (const DrumResult& d : ends) rooms[d.drum] += room_of(model, d);
  for (DrumResult& d : ends) set_layer(model, rooms[d.drum], d);
}

/// The ends of ropes that lie on drums.
template <class Each>
void for_each_end_on_drum(const machine::Model& model, const Each& each) {
  for (int r = 0; r < static_cast<int>(model.reevings.size()); ++r) {
    const machine::Reeving& rope = model.reevings[r];
    if (rope.nodes.front().drum) each(r, false, *rope.nodes.front().drum);
    if (rope.nodes.back().drum) each(r, true, *rope.nodes.back().drum);
  }
}

/// In which sense each end is wound on its drum. `sides`: of the nodes of each reeving, where a state has its own.
void set_senses(const machine::Model& model, const Array<Array<int>>& sides, Array<DrumResult>& ends) {
  std::map<int, Vector3> axes;
  for (DrumResult& d : ends) {
    const machine::Reeving& rope = model.reevings[d.reeving];
    const std::size_t k = d.at_end ? rope.nodes.size() - 1 : 0;
    const int side = sides.empty() ? rope.nodes[k].side : sides[d.reeving][k];
    const Vector3 axis = (d.at_end ? side : -side) * rope.nodes[k].axis;
    d.sense = axes.try_emplace(d.drum, axis).first->second.dot(axis) < 0 ? -1 : 1;
  }
}

/// The free length beside which the drums of a rope hold their `length_on_drum`.
std::optional<double> length_beside_drums(const machine::Reeving& rope) {
  if (rope.described_length) return rope.described_length;
  return rope.given == machine::Given::length ? std::optional(rope.value) : std::nullopt;
}

/// Tension of a rope at its start or end.
template <class Branches>
double tension_at(const Branches& branches, int reeving, bool at_end) {
  const auto own = [&](const auto& branch) { return branch.reeving == reeving; };
  if (at_end) return std::find_if(branches.rbegin(), branches.rend(), own)->T_to;
  return std::find_if(branches.begin(), branches.end(), own)->T_from;
}

}  // namespace

Array<DrumResult> drums(const machine::Model& model, const EquilibriumResult& result) {
  Array<DrumResult> all;
  for_each_end_on_drum(model, [&](int r, bool at_end, int on) {
    const machine::Drum& drum = model.drums[on];
    const machine::Reeving& rope = model.reevings[r];
    std::optional<double> length = drum.length_on_drum;
    const std::optional<double> free = length_beside_drums(rope);
    if (length && free) *length += *free - result.ropes[r].unstretched;
    DrumResult d = at_drum(model, r, at_end, tension_at(result.branches, r, at_end), length);
    const int sense = sense_of(result.flow[r]);
    if (drum.drive.kind == machine::DriveKind::speed && rope.speed > 0 && sense != 0) {
      d.speed = (sense == (at_end ? 1 : -1) ? 1 : -1) * rope.speed;
    }
    all.push_back(d);
  });
  set_layers(model, all);
  set_senses(model, result.state.sides, all);
  return all;
}

double largest_at_end(const machine::Model& model, const EquilibriumResult& result, int reeving, bool at_end) {
  double T = 0;
  for (const BranchResult& s : result.branches) {
    if (s.reeving != reeving) continue;
    T = at_end ? std::max(s.T_to, s.T_to_max) : std::max(s.T_from, s.T_from_max);
    if (!at_end) break;
  }
  return model.reevings[reeving].copies * T;
}

std::optional<double> length_on_drums(const machine::Model& model, int reeving) {
  const machine::Reeving& rope = model.reevings[reeving];
  double wound = 0;
  if (rope.closed) return wound;
  for (const machine::Node* end : {&rope.nodes.front(), &rope.nodes.back()}) {
    if (!end->drum) continue;
    const std::optional<double> own = model.drums[*end->drum].length_on_drum;
    if (!own) return std::nullopt;
    wound += *own;
  }
  return wound;
}

std::optional<double> whole_length(const machine::Model& model, const EquilibriumResult& result, int reeving) {
  const machine::Reeving& rope = model.reevings[reeving];
  if (rope.closed || !(rope.nodes.front().drum || rope.nodes.back().drum)) return result.ropes[reeving].unstretched;
  const std::optional<double> wound = length_on_drums(model, reeving);
  const std::optional<double> free = length_beside_drums(rope);
  if (!wound || !free) return std::nullopt;
  return *free + *wound;
}

Array<DrumResult> drums(const machine::Model& model, const TransientFrame& frame) {
  Array<DrumResult> all;
  for (const TransientFrame::OnDrum& end : frame.on_drums) {
    const bool known = model.drums[end.drum].length_on_drum.has_value();
    const double pull = tension_at(frame.branches, end.reeving, end.at_end);
    all.push_back(at_drum(model, end.reeving, end.at_end, pull, known ? std::optional(end.content) : std::nullopt));
  }
  set_layers(model, all);
  set_senses(model, {}, all);
  std::map<int, double> radii;
  for (DrumResult& one : all) {
    const double first = radii.try_emplace(one.drum, one.radius).first->second;  // whose speed the frame has
    one.speed = one.sense * frame.drums[one.drum].speed * one.radius / first;
  }
  return all;
}

}  // namespace taut::solve
