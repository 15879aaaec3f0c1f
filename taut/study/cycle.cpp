#include "taut/study/cycle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/study/deck/bounds.hpp"
#include "taut/study/deck/names.hpp"
#include "taut/study/deck/watch.hpp"

namespace taut::study {
namespace {

/// Rope without tension, at its temperature, between the middle of a drive's arc and the clamped carriage on it; 0
/// where nothing is clamped to it.
double passed(const solve::EquilibriumResult& e, const machine::Model& m, int reeving) {
  const machine::Reeving& rope = m.reevings[reeving];
  const auto on_arc = [&](int node) {
    const auto contact = std::find_if(e.contacts.begin(), e.contacts.end(),
                                      [&](const auto& c) { return c.reeving == reeving && c.node == node; });
    return contact == e.contacts.end() ? 0.0 : contact->unstretched;
  };
  double length = on_arc(0) / 2;
  for (const auto& s : e.branches) {
    if (s.reeving != reeving) continue;
    length += s.unstretched;
    if (rope.nodes[s.to].kind == machine::NodeKind::clamp) return length * (1 + rope.thermal_strain);
    length += on_arc(s.to);
  }
  return 0;
}

WinchPull pull_of(const machine::Model& m, const solve::EquilibriumResult& e, const Winch& w) {
  const machine::Reeving& rope = m.reevings[w.reeving];
  if (w.drive) {
    const auto drive = std::find_if(e.contacts.begin(), e.contacts.end(),
                                    [&](const auto& c) { return c.reeving == w.reeving && c.node == 0; });
    const double mean = (drive->T_in + drive->T_out) / 2;
    return {.tension = rope.copies * (drive->T_in - drive->T_out),
            .paid = passed(e, m, w.reeving) * (1 + mean / rope.stiffness)};
  }
  const auto own = [&](const auto& s) { return s.reeving == w.reeving; };
  const double T = w.at_end ? std::find_if(e.branches.rbegin(), e.branches.rend(), own)->T_to
                            : std::find_if(e.branches.begin(), e.branches.end(), own)->T_from;
  return {.tension = rope.copies * T, .paid = e.ropes[w.reeving].unstretched * (1 + rope.thermal_strain)};
}

/// A part of the way with the carriage in one span, solved; without points where it is on a support.
struct Stretch {
  double x = 0;  ///< where it begins, m
  bool on_support = false;
  machine::Model model;
  std::vector<LoadPathPoint> points;
};

/// The way of the carriage, part by part.
std::vector<Stretch> stretches_of(const machine::Model& model, const CycleRun& run, const Phase& phase, Watch& watch) {
  machine::Model loaded = model;
  loaded.bodies[loaded.carriages[run.carriage].body].mass += phase.load;
  std::vector<Stretch> all;
  for (const WayPart& part : parts_of(loaded, phase.way)) {
    if (watch.ended()) break;
    Stretch& one = all.emplace_back(Stretch{
        .x = phase.way.x(part.first), .on_support = part.support != nullptr, .model = part.model, .points = {}});
    if (part.support != nullptr) continue;
    LoadPathOptions options = path_over(phase.way, part);
    options.equilibrium = phase.motion.options(part.model);
    options.equilibrium.held = run.held;
    options.equilibrium.creep_without_loss = true;
    options.go_on = [&watch](double x) { return watch.go_on_at(x); };
    one.points = load_path(part.model, options).points;
    if (part.last == part.first && one.points.size() > 1) one.points.resize(1);
  }
  return all;
}

std::vector<RopeSense> senses_of(const CycleRun& run, const std::vector<Stretch>& stretches) {
  RopeSenses found(run.winches);
  for (const Stretch& one : stretches) found.take(one.model, one.points);
  return found.all();
}

/// The positions of a phase; one on a support is passed over.
void add_positions(const CycleRun& run, const Phase& phase, const std::vector<Stretch>& stretches,
                   const CycleStates& seen, PhaseAnswer& answer) {
  std::vector<CyclePosition>& all = answer.positions;
  for (const Stretch& part : stretches) {
    if (part.on_support) all.emplace_back().x = part.x;
    for (const auto& point : part.points) {
      CyclePosition& p = all.emplace_back();
      p.x = point.x;
      p.known = point.at.outcome.ok();
      answer.missing.take(point.at.outcome, point.x, run.display);
      if (!p.known) continue;
      p.z = point.z;
      p.place = point.at.state.bodies[part.model.carriages[run.carriage].body].position;
      seen(part.model, point, phase);
      for (const Winch& w : run.winches) p.pulls.push_back(pull_of(part.model, point.at, w));
    }
  }
  const CyclePosition* before = nullptr;
  for (CyclePosition& p : all) {
    if (!p.known) continue;
    if (before != nullptr) answer.way += (p.place - before->place).norm();
    p.way = answer.way;
    before = &p;
  }
}

void take_power(double power, WinchWork& work) {
  if (std::isnan(work.power_max) || std::abs(power) > std::abs(work.power_max)) work.power_max = power;
  if (std::isnan(work.power_given) || power > work.power_given) work.power_given = power;
}

/// Trapezoids from position to position: dW = T (1 + T/EA) dL for a drum, T dL for a drive. `turn`: the last position
/// of the phase before, where this one begins with the same load. Between them the winches change the pulls until
/// friction acts the other way, the carriage at rest; without that work the winches of a closed cycle do not end with
/// the rope that they began with, and friction may seem to give energy.
WinchWork work_of(const machine::Model& m, const CycleRun& run, std::size_t winch, const CyclePosition* turn,
                  const std::vector<CyclePosition>& all, double speed) {
  const Winch& w = run.winches[winch];
  const double EA = m.reevings[w.reeving].copies * m.reevings[w.reeving].stiffness;
  const auto stretch = [&](double T) { return w.drive ? 1.0 : 1 + T / EA; };
  WinchWork work;
  work.powers.assign(all.size(), none);
  const CyclePosition* before = turn;
  double mean = 0;
  for (const CyclePosition& p : all) {
    if (!p.known) continue;
    const double T = p.pulls[winch].tension;
    if (std::isnan(work.at) || std::abs(T) > std::abs(work.pull_max)) {
      work.pull_max = T;
      work.at = p.x;
    }
    if (before != nullptr) {
      const double T0 = before->pulls[winch].tension;
      const double paid = p.pulls[winch].paid - before->pulls[winch].paid;
      const double way = before == turn ? 0 : p.way - before->way;
      const double energy = -(T0 * stretch(T0) + T * stretch(T)) / 2 * paid;
      work.taken -= (stretch(T0) + stretch(T)) / 2 * paid;
      work.energy += energy;
      mean += (T0 + T) / 2 * way;
      if (way > 0 && !std::isnan(speed)) {
        work.powers[static_cast<std::size_t>(&p - all.data())] = energy / way * speed;
        take_power(energy / way * speed, work);
      }
    }
    before = &p;
  }
  const double way = before != nullptr && before != turn ? before->way : 0;
  work.pull_mean = way > 0 ? mean / way : work.pull_max;
  return work;
}

/// The last position of the phase before (of the last phase before the first), where a phase begins there with the same
/// load; null elsewhere. A position on a support is not known: both phases then have the one beside it.
const CyclePosition* turn_before(const CycleRun& run, std::size_t phase) {
  constexpr double same_place = 1e-9;  // of the way: the deck may have written it in another unit
  const std::size_t before = (phase + run.phases.size() - 1) % run.phases.size();
  if (before >= run.answers.size() || run.phases[before].load != run.phases[phase].load) return nullptr;
  const std::vector<CyclePosition>&ends = run.answers[before].positions, &begins = run.answers[phase].positions;
  const auto known = [](const CyclePosition& p) { return p.known; };
  const auto last = std::find_if(ends.rbegin(), ends.rend(), known);
  const auto first = std::find_if(begins.begin(), begins.end(), known);
  if (last == ends.rend() || first == begins.end()) return nullptr;
  const Way& way = run.phases[phase].way;
  return std::abs(last->x - first->x) <= same_place * std::abs(way.to - way.from) ? &*last : nullptr;
}

}  // namespace

const Description& PhaseRequest::describe() {
  static const Description d =
      Describe<PhaseRequest>()
          .field(&PhaseRequest::name, "name", "such as 'inhaul loaded'")
          .required()
          .named_records(&PhaseRequest::motion, "motion", "as for an equilibrium: in, out, ...")
          .shorthand("sense")
          .one_for_all()
          .field(&PhaseRequest::load, "load", "m", si::kg, "load on the carriage, in addition to those of the machine")
          .at_least(0)
          .at_most(heaviest)
          .field(&PhaseRequest::from, "from", "x", si::m, "first place of the carriage, in place of that of the cycle")
          .at_least(-farthest_along)
          .at_most(farthest_along)
          .field(&PhaseRequest::to, "to", "x", si::m, "last place")
          .at_least(-farthest_along)
          .at_most(farthest_along)
          .field(&PhaseRequest::speed, "speed", "v", si::m_per_s,
                 "speed of the carriage, in place of that of the cycle")
          .above(0)
          .at_most(1000);
  return d;
}

namespace {

/// A cycle counts the work of one motor on each endless rope. A deck with a second motor is refused.
void refuse_helpers(Names& names, const std::string& path) {
  for (const machine::Reeving& rope : names.model.reevings) {
    for (const machine::Node& node : rope.nodes) {
      if (node.kind != machine::NodeKind::contact || !node.motor) continue;
      names.complaints.push_back({path, fmt::format("'{}' drives '{}' beside '{}': a cycle counts one motor for each "
                                                    "endless rope; leave out its 'motor'",
                                                    node.name, rope.name, rope.nodes.front().name)});
      return;
    }
  }
}

}  // namespace

const Description& CycleRequest::describe() {
  static const Description d =
      Describe<CycleRequest>()
          .field(&CycleRequest::name, "name", "appended to the names of its tables, when a deck has several")
          .field(&CycleRequest::judge, "judge", "false: its states do not count for the verdict")
          .field(&CycleRequest::carriage, "carriage", "the carriage that is moved")
          .required()
          .field(&CycleRequest::from, "from", "x", si::m, "first place of the carriage in the first phase")
          .at_least(-farthest_along)
          .at_most(farthest_along)
          .required()
          .field(&CycleRequest::to, "to", "x", si::m,
                 "last place in the first phase; phases without places of their own go back and forth")
          .at_least(-farthest_along)
          .at_most(farthest_along)
          .required()
          .field(&CycleRequest::steps, "steps", "n", si::one, "equal steps of each phase")
          .at_least(1)
          .at_most(10000)
          .field(&CycleRequest::along, "along", "", si::one, "as for a load path")
          .field(&CycleRequest::held, "held", "as for an equilibrium, at every position")
          .field(&CycleRequest::speed, "speed", "v", si::m_per_s, "speed of the carriage, for powers and times")
          .above(0)
          .at_most(1000)
          .record(&CycleRequest::phases, "phases", "phases in their order")
          .required();
  return d;
}

CycleRun resolve(const CycleRequest& request, const std::string& path, Names& names) {
  CycleRun run;
  run.ending = ending_of(names, "cycle", request.name, path);
  run.held = request.held;
  const auto carriage = carriage_of(names, request.carriage, path + ".carriage");
  Way way = way_of(carriage, request.along, path, names);
  run.carriage = way.carriage;
  way.from = request.from;
  way.to = request.to;
  way.steps = request.steps;
  for (std::size_t i = 0; i < request.phases.size(); ++i) {
    const std::string at = fmt::format("{}.phases[{}]", path, i);
    const PhaseRequest& one = request.phases[i];
    Phase phase{.name = one.name,
                .motion = rope_motion(one.motion, names.model, at + ".motion", names.complaints),
                .load = one.load,
                .way = way,
                .speed = none};
    phase.way.from = one.from.value_or(way.from);
    phase.way.to = one.to.value_or(way.to);
    if (one.speed || request.speed) phase.speed = one.speed ? *one.speed : *request.speed;
    if (phase.way.from == phase.way.to) names.complaints.push_back({at, "its carriage does not move"});
    // the next one goes back
    way.from = phase.way.to;
    way.to = phase.way.from;
    run.phases.push_back(std::move(phase));
  }
  run.winches = winches_of(names.model, names.machine, carriage);
  if (run.winches.empty()) {
    names.complaints.push_back({path, "nothing pulls: no rope ends on a drum, has a tension given, or is a mainline"});
  }
  refuse_helpers(names, path);
  return run;
}

int states_of(const CycleRun& run) {
  int states = 0;
  for (const Phase& phase : run.phases) states += phase.way.steps + 1;
  return states;
}

void solve(const machine::Model& model, CycleRun& run, Watch& watch, const CycleStates& seen) {
  for (const Phase& phase : run.phases) {
    if (watch.ended()) break;
    PhaseAnswer& answer = run.answers.emplace_back();
    const std::vector<Stretch> stretches = stretches_of(model, run, phase, watch);
    answer.senses = senses_of(run, stretches);
    add_positions(run, phase, stretches, seen, answer);
    if (!std::isnan(phase.speed)) answer.time = answer.way / phase.speed;
  }
  const std::size_t whole = run.answers.size() - (watch.ended() ? 1 : 0);
  for (std::size_t i = 0; i < whole; ++i) {
    const CyclePosition* turn = turn_before(run, i);
    PhaseAnswer& answer = run.answers[i];
    for (std::size_t w = 0; w < run.winches.size(); ++w) {
      answer.works.push_back(work_of(model, run, w, turn, answer.positions, run.phases[i].speed));
    }
  }
}

const Quantities<CycleRow>& cycle_quantities() {
  using Row = CycleRow;
  static const Quantities<Row> all = {
      {"phase", "", si::one, "the phase", [](const Row& r) { return r.phase.name; }},
      {"x", "x", si::m, "place of the carriage along its way", [](const Row& r) { return r.position.x; }},
      {"z", "z", si::m, "its height", [](const Row& r) { return r.position.z; }},
      {"way", "s", si::m, "its way since the phase began",
       [](const Row& r) { return r.position.known ? r.position.way : none; }}};
  return all;
}

const Quantities<WinchRow>& winch_quantities() {
  using Row = WinchRow;
  static const Quantities<Row> all = {
      {"phase", "", si::one, "the phase", [](const Row& r) { return r.phase.name; }},
      {"winch", "", si::one, "the winch", [](const Row& r) { return r.winch.name; }},
      {"pull_max", "F_max", si::N, "largest pull", [](const Row& r) { return r.work.pull_max; }},
      {"x", "x", si::m, "place of the carriage there", [](const Row& r) { return r.work.at; }},
      {"pull_mean", "F_m", si::N, "mean pull over the carriage's way", [](const Row& r) { return r.work.pull_mean; }},
      {"rope_taken_in", "", si::m, "rope taken in; let out: negative", [](const Row& r) { return r.work.taken; }},
      {"energy", "W", si::J, "energy that the winch gives; braked: negative",
       [](const Row& r) { return r.work.energy; }},
      {"power_max", "P_max", si::W, "largest power, given or braked", [](const Row& r) { return r.work.power_max; }},
      {"duration", "t", si::s, "time of the phase", [](const Row& r) { return r.time; }}};
  return all;
}

}  // namespace taut::study
