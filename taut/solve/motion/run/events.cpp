#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "taut/base/array.hpp"
#include "taut/machine/compile/drums.hpp"
#include "taut/machine/signals_in.hpp"
#include "taut/math/index.hpp"
#include "taut/solve/motion/parts/couple.hpp"
#include "taut/solve/motion/run/run.hpp"

namespace taut::solve::dynamics {
namespace {

constexpr std::size_t most_notes = 20000;  ///< beyond it only what is_kept

/// Whether a note is kept however many there are: what a verdict reads. Of what comes again and again the first one.
bool is_kept(Run& run, const std::string& what, const std::string& where) {
  if (what == "break" || what == "stop" || what == "unstable") return true;
  if (what != "slack" && what != "lift_off") return false;
  return run.noted.insert(what + " " + where).second;
}

std::string line_name(const Run& run, const Line& line) {
  const machine::Reeving& rope = run.model.reevings[line.reeving];
  if (rope.nodes.size() == 2 && line.segment < 0) return rope.name;
  const std::string branch =
      fmt::format("{}: {} - {}", rope.name, rope.nodes[line.from].name, rope.nodes[line.to].name);
  return line.segment < 0 ? branch : fmt::format("{} ({})", branch, line.segment + 1);
}

std::string contact_name(const Run& run, const Contact& contact) {
  return run.model.reevings[contact.reeving].nodes[contact.node].name;
}

/// What counts from a time on only has no value before.
bool holds(const Run& run, const Values& v, const machine::Condition& condition) {
  if (v.t < condition.of.since) return false;
  const double value = observe(run, v, condition.of);
  return condition.above ? value > condition.threshold : value < condition.threshold;
}

/// The line that an event breaks, of those that are whole: where the tension is largest; of equal ones, whatever their
/// rounding, the first. -1: they all are broken; or the rope is, somewhere, and what is left of it hangs loose.
int breaking_line(const Run& run, const Values& v, const machine::Event& event) {
  const auto [first, lines] = run.m.first_line[event.index];
  const int pieces = std::max(1, run.model.reevings[event.index].segments);
  int from = first, to = first + lines;
  if (event.part) {
    from = first + *event.part * pieces;
    to = from + pieces;
  }
  constexpr double rounding = 1e-9;
  int worst = -1;
  bool broken = false;
  for (int i = from; i < to; ++i) {
    const bool whole = v.lines[i].gone == 1;
    broken = broken || !whole;
    if (whole && (worst < 0 || v.lines[i].T > (1 + rounding) * v.lines[worst].T)) worst = i;
  }
  return worst >= 0 && broken && v.lines[worst].T <= 0 ? -1 : worst;
}

void break_rope(Run& run, Values& v, const machine::Event& event) {
  const int line = breaking_line(run, v, event);
  if (line < 0) return;
  run.breaking.push_back({line, v.t, event.over});
  note(run, v.t, "break", line_name(run, run.m.lines[line]), {{"T", v.lines[line].T}}, event.index);
}

/// A drum that has pulled its rope goes on with a torque or in its brake: it turns as its rope goes, and its drive has
/// seen to that.
void turn_with_rope(Run& run, Values& v, int drum) {
  for (std::size_t i = 0; i < run.m.contacts.size(); ++i) {
    const Contact& contact = run.m.contacts[i];
    if (contact.drum != drum) continue;
    const Spin& spin = run.m.spins[contact.spin];
    if (spin.contacts.front().first != static_cast<int>(i) || spin.inertia <= 0) continue;
    const double omega = contact.sense * v.contacts[i].flow * v.contacts[i].lambda / working_radius(run.m, contact, v);
    v.nu[spin.column] = v.spins[contact.spin].omega = omega;
    const double given = spin.inertia * omega * omega / 2;
    run.ledger.supplied += given;
    run.ledger.now.kinetic += given;
  }
}

/// When a brake that is set begins to act, and when it acts in full.
Array<double> stops_of_brake(const machine::Drum& drum, const machine::Drive& drive) {
  if (!drum.brake || !drive.brake) return {};
  const double acts = drive.brake_since + drum.brake->delay;
  return {acts, acts + drum.brake->rise};
}

/// There a step ends.
void stop_at_brake(Run& run, int drum, const Values& v) {
  for (const double stop : stops_of_brake(run.model.drums[drum], v.drum_drive[drum])) {
    if (stop > v.t && stop < run.end)
      run.stops.insert(std::lower_bound(run.stops.begin(), run.stops.end(), stop), stop);
  }
}

bool apply_event(Run& run, Values& v, std::size_t index) {
  const machine::Event& event = run.model.events[index];
  switch (event.kind) {
    case machine::EventKind::breaks:
      break_rope(run, v, event);
      break;
    case machine::EventKind::stop:
      note(run, v.t, "stop", event.words);
      return true;
    case machine::EventKind::brake: {
      auto& drives = event.of_motor ? v.motor_drive : v.drum_drive;
      machine::Drive& drive = drives[event.index];
      const bool lets_go = drive.kind == machine::DriveKind::pull && !event.of_motor && !drive.brake;
      if (event.brake_set && lets_go && run.m.model->drums[event.index].brake) turn_with_rope(run, v, event.index);
      if (event.brake_set && !drive.brake) drive.brake_since = v.t;
      drive.brake = event.brake_set;
      if (!event.brake_set && drive.kind == machine::DriveKind::held) drive.kind = machine::DriveKind::free;
      if (event.brake_set && !event.of_motor) stop_at_brake(run, event.index, v);
      note(run, v.t, "brake", event.words);
      break;
    }
    case machine::EventKind::drive: {
      auto& drives = event.of_motor ? v.motor_drive : v.drum_drive;
      machine::Drive& drive = drives[event.index];
      const bool lets_go = drive.kind == machine::DriveKind::pull && !event.of_motor && !drive.brake;
      // what drives it is one thing, what holds it another: a brake opens by its own event
      drive.kind = event.drive.kind;
      drive.signal = event.drive.signal;
      drive.by = static_cast<int>(index);
      if (lets_go && drive.kind == machine::DriveKind::torque) turn_with_rope(run, v, event.index);
      note(run, v.t, "drive", drive.brake ? event.words + ", its brake stays set" : event.words);
      break;
    }
    case machine::EventKind::actuator:
      set_mode(run.m, v, event.index, event.mode);
      note(run, v.t, "actuator", event.words);
      break;
  }
  return false;
}

constexpr double no_rope_on_drum = 1e-6;     ///< m
constexpr double rounding_of_radius = 1e-9;  ///< share of a radius

/// How a drum takes the rope of this contact; width 0 where nobody knows.
rope::DrumLayers layers_on(const Run& run, const Contact& contact) {
  return machine::measures_of(run.model.drums[contact.drum], run.model.reevings[contact.reeving].diameter);
}

/// The layer on which the end of a rope lies, as statics has it: by what all ropes of its drum take up, and the tension
/// at which they were wound. `content_of`: unstretched rope of a contact with a drum, m.
template <class Content>
int layer_of(const Run& run, const Contact& contact, const Content& content_of) {
  const machine::Drum& drum = run.model.drums[contact.drum];
  const rope::DrumLayers layers = layers_on(run, contact);
  if (layers.width == 0) return drum.layer;
  double room = 0;
  for (const Contact& one : run.m.contacts) {
    if (one.drum != contact.drum) continue;
    const machine::Reeving& rope = run.model.reevings[one.reeving];
    const double strain = drum.wound_at.value_or(0) / run.m.lines[std::max(one.in, one.out)].stiffness;
    room += machine::room_of(content_of(one) * (1 + strain), rope.diameter, rope.copies);
  }
  return rope::on_drum(layers, room / (layers.rope_diameter * layers.rope_diameter)).layer;
}

}  // namespace

void note(Run& run, double t, std::string what, std::string where, Array<std::pair<std::string, double>> values,
          std::optional<int> reeving) {
  const bool kept = is_kept(run, what, where);
  const bool full = run.result.events.size() >= most_notes;
  if (full && !run.cut) run.result.events.push_back({t, "cut", "what comes again is left out from here on", {}, {}});
  run.cut = run.cut || full;
  if (full && !kept) return;
  run.result.events.push_back({t, std::move(what), std::move(where), std::move(values), reeving});
}

void note_slack(Run& run, std::size_t line, double e_before, double e_now, double t, double h) {
  if ((e_before > 0) == (e_now > 0)) return;
  const double share = e_before / (e_before - e_now);
  const Line& of = run.m.lines[line];
  note(run, t + share * h, e_now > 0 ? "taut" : "slack", line_name(run, of), {}, of.reeving);
}

namespace {

/// Points that meet their face or leave it, stick or slip.
void note_faces(Run& run) {
  for (std::size_t i = 0; i < run.now.faces.size(); ++i) {
    const FaceValues &was = run.before.faces[i], &is = run.now.faces[i];
    const std::string& name = run.model.contacts[i].name;
    if (was.closed != is.closed) {
      const double share = was.pen * is.pen < 0 ? was.pen / (was.pen - is.pen) : 1;
      const double t = run.before.t + share * run.scheme.h;
      const double speed = was.pen_rate + share * (is.pen_rate - was.pen_rate);
      if (is.closed) {
        note(run, t, "contact", name, {{"v", was.pen < 0 ? was.pen_rate : speed}});
      } else {
        note(run, t, "apart", name);
      }
    } else if (is.closed && was.sticks != is.sticks) {
      note(run, run.now.t, is.sticks ? "stick" : "slip", name, {{"N", is.N}});
    }
  }
}

}  // namespace

void note_changes(Run& run) {
  for (std::size_t i = 0; i < run.m.lines.size(); ++i) {
    const Line& line = run.m.lines[i];
    const LineValues &was = run.before.lines[i], &is = run.now.lines[i];
    if (is.gone == 0) continue;
    if (sags(line, is) && run.tight_first[i] <= 0) continue;  // it hangs by its weight from the start
    note_slack(run, i, strain_of_chord(line, was), strain_of_chord(line, is), run.before.t, run.scheme.h);
  }
  for (std::size_t i = 0; i < run.m.contacts.size(); ++i) {
    const Grip was = run.before.contacts[i].grip, is = run.now.contacts[i].grip;
    const Contact& contact = run.m.contacts[i];
    if (was == is || contact.in < 0 || contact.out < 0) continue;
    if (was == Grip::equal || is == Grip::equal) {
      const Pressure p = pressure(contact, run.now);
      const double G = run.now.lines[contact.out].thrust[0];
      if (is == Grip::equal && G > 0 && run.now.contacts[i].log_ratio > 0 && std::max(p.in, p.out) > -G) {
        note(run, run.now.t, "lift_off", contact_name(run, contact), {{"G", G}});
      }
      continue;
    }
    note(run, run.now.t, is == Grip::stuck ? "stick" : "slip", contact_name(run, contact));
  }
  note_faces(run);
}

double content_at(const Run& run, const Contact& contact, const Values& v) {
  const bool leaves = contact.in < 0;  // the drum is where its path begins
  const auto line = as_size(leaves ? contact.out : contact.in);
  const std::size_t end = leaves ? 0 : 1;
  const LineValues &was = run.before.lines[line], &is = v.lines[line];
  double onto = v.q[contact.column] - run.before.q[contact.column];
  if (winds(run.m.lines[line], is, end) && !has_run_off(was)) {
    const double winding = run.before.contacts[as_size(run.m.lines[line].contact[end])].winding;
    onto -= is.radius[end] / winding * (is.angle[end] - was.angle[end]);
  }
  return run.before.on_drums[contact.on_drum].content + (leaves ? -onto : onto);
}

namespace {

/// The same; none where the description does not say how much there is.
std::optional<double> known_content(const Run& run, const Contact& contact, const Values& v) {
  if (contact.drum < 0 || !run.model.drums[contact.drum].length_on_drum) return {};
  return content_at(run, contact, v);
}

/// Whether a drum changes its layer in the step to `v`, or has no rope left then.
bool winds_on(const Run& run, const Values& v) {
  return std::any_of(run.m.contacts.begin(), run.m.contacts.end(), [&](const Contact& contact) {
    const auto content = known_content(run, contact, v);
    if (!content) return false;
    const machine::Drum& drum = run.model.drums[contact.drum];
    const auto ahead = [&](const Contact& one) { return content_at(run, one, v); };
    const bool climbs =
        drum.automatic_layers && layer_of(run, contact, ahead) != run.before.on_drums[contact.on_drum].layer;
    return climbs || *content < -no_rope_on_drum;
  });
}

}  // namespace

bool run_out(Run& run) {
  for (std::size_t i = 0; i < run.before.actuators.size(); ++i) {
    if (!(run.before.actuators[i].length < 0)) continue;
    const std::string& name = run.model.actuators[i].name;
    note(run, run.before.t, "length_zero", name, {{"L", run.before.actuators[i].length}});
    run.result.outcome = infeasible(
        fmt::format("at t = {:.6g} s the actuator '{}' has no length left: lock it or stop the motion before, or let a "
                    "contact hold what it moves",
                    run.before.t, name));
    return true;
  }
  for (const Contact& contact : run.m.contacts) {
    const auto content = known_content(run, contact, run.before);
    if (!content || *content >= -no_rope_on_drum) continue;
    const std::string& drum = run.model.drums[contact.drum].name;
    note(run, run.before.t, "length_zero", drum, {{"L", *content}}, contact.reeving);
    run.result.outcome = infeasible(
        fmt::format("at t = {:.6g} s no rope is left on the drum '{}' ('{}'): stop the motion before, or give it more",
                    run.before.t, drum, run.model.reevings[contact.reeving].name));
    return true;
  }
  return false;
}

bool comes_true(const Run& run, const Values& v) {
  if (!run.model.drums.empty() && winds_on(run, v)) return true;
  const auto overdrawn = [](const LineValues& line) { return line.gone == 0 && !(line.L > 0); };
  if (std::any_of(v.lines.begin(), v.lines.end(), overdrawn)) return true;  // the end runs off before
  const auto is_gone = [](const ActuatorValues& actuator) { return actuator.length < 0; };
  if (std::any_of(v.actuators.begin(), v.actuators.end(), is_gone)) return true;
  for (std::size_t i = 0; i < run.model.events.size(); ++i) {
    const machine::Event& event = run.model.events[i];
    if (!run.happened[i] && event.when && holds(run, v, *event.when)) return true;
  }
  return meets_an_edge(run.m, v);
}

bool happen(Run& run, Values& v, bool& stop) {
  bool any = false;
  for (std::size_t i = 0; i < run.model.events.size(); ++i) {
    const machine::Event& event = run.model.events[i];
    if (run.happened[i]) continue;
    const bool due = (event.at && v.t >= *event.at) || (event.when && holds(run, v, *event.when));
    if (!due) continue;
    run.happened[i] = 1;
    any = true;
    stop = apply_event(run, v, i) || stop;
  }
  if (any) fade(run, v.t, v);
  return any;
}

void fade(const Run& run, double t, Values& v) {
  for (const Run::Breaking& one : run.breaking) {
    v.lines[one.line].gone = one.over > 0 ? std::clamp(1 - (t - one.from) / one.over, 0.0, 1.0) : 0.0;
  }
}

double step_of_fading(const Run& run) {
  constexpr double steps = 32;
  double shortest = run.options.duration;
  for (const Run::Breaking& one : run.breaking) {
    if (run.before.t < one.from + one.over) shortest = std::min(shortest, one.over / steps);
  }
  return shortest;
}

bool change_layers(Run& run, Values& v) {
  bool any = false;
  for (std::size_t i = 0; i < run.m.contacts.size(); ++i) {
    const Contact& contact = run.m.contacts[i];
    if (contact.drum < 0) continue;
    const machine::Drum& drum = run.model.drums[contact.drum];
    if (!drum.automatic_layers || !drum.length_on_drum) continue;
    OnDrumValues& is = v.on_drums[contact.on_drum];
    const rope::DrumLayers layers = layers_on(run, contact);
    if (layers.width == 0) continue;
    const int layer = layer_of(run, contact, [&](const Contact& one) { return v.on_drums[one.on_drum].content; });
    const int line = contact.in >= 0 ? contact.in : contact.out;
    const std::size_t end = contact.in >= 0 ? 1 : 0;
    LineValues& rope = v.lines[line];
    const double radius = rope::layer_radius(layers, layer);
    if (layer == is.layer && std::abs(rope.radius[end] - radius) <= rounding_of_radius * radius) continue;
    // the strain is kept: a rope climbs onto the next layer within a turn
    const double strain = std::max(0.0, end_strain(run.m, v, line, end));
    while (static_cast<int>(is.strain.size()) < layer) is.strain.push_back(strain);
    if (layer > is.layer) is.strain[layer - 1] = strain;
    is.layer = layer;
    for (int k = line;; k += end == 0 ? 1 : -1) {  // all parts of the free line
      const Line& part = run.m.lines[k];
      LineValues& of = v.lines[k];
      if (sags(part, of)) {
        hang_on_new_radius(part, v.bodies, end, radius, of, v.sags[part.sag]);
        of.radius[end] = radius;
        break;
      }
      of.radius[end] = radius;
      const LineValues as_was = of;
      if (place_line(part, v.bodies, as_was, of)) {
        lay_on_rounds(part, as_was, of);
        of.L = path_of(part, of) / (1 + of.e);
      }
      if (!part.at_load[1 - end]) break;
    }
    note(run, v.t, "layer", drum.name, {{"layer", layer}, {"R", radius}});
    any = true;
  }
  return any;
}

Array<double> stops_of(const Run& run, double from, double to) {
  Array<double> stops;
  machine::for_each_signal(run.model, [&](const machine::Signal& signal) {
    for (const double t : machine::breakpoints(signal, from, to)) stops.push_back(t);
  });
  // of a brake too that an event before a restart has set
  for (std::size_t d = 0; d < run.model.drums.size(); ++d) {
    for (const double t : stops_of_brake(run.model.drums[d], run.before.drum_drive[d])) stops.push_back(t);
  }
  for (const machine::Event& event : run.model.events) {
    if (!event.at) continue;
    stops.push_back(*event.at);
    if (event.over > 0) stops.push_back(*event.at + event.over);
  }
  std::sort(stops.begin(), stops.end());
  stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
  stops.erase(std::remove_if(stops.begin(), stops.end(), [&](double t) { return !(t > from && t < to); }), stops.end());
  return stops;
}

Array<double> extremes_of(const machine::Model& model, double from, double to, bool measures) {
  Array<double> all;
  machine::for_each_signal(model, [&](const machine::Signal& signal) {
    for (const double t : machine::extremes(signal, from, to)) all.push_back(t);
  });
  const auto add = [&](double t) {
    if (measures && t > from && t < to) all.push_back(t);
  };
  for (const machine::Observable& what : model.observed) {
    add(what.since);
    if (!what.has_mean || what.mean_of) continue;
    add(what.mean_from);
    add(what.mean_to);
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

bool jumps_at(const Run& run, double t) {
  const double near = 1e-12 * std::max(std::abs(t), run.options.duration);
  const Array<double> stops = stops_of(run, t - near, t + near);
  return !stops.empty();
}

}  // namespace taut::solve::dynamics
