#include "taut/study/transient.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "taut/study/deck/motion_checks.hpp"
#include "taut/units/display.hpp"

namespace taut::study {
namespace {

constexpr double most_lines = 1e6, most_numbers = 1e8;
constexpr double usual_tolerance = 1e-5;  ///< the digits that a report prints are right
constexpr double fewest_moments = 500;    ///< of a motion that are looked at, if it has fewer output steps
constexpr double most_apart = 0.1;        ///< of two of them, s
constexpr double fine_tolerance = 1e-6;   ///< of the reference, and of what a given step solves

double lines_of(const TransientRequest& request) {
  const double step = request.output_step.value_or(request.duration / 1000);
  return std::ceil(request.duration / step * (1 - 1e-9)) + 1;
}

/// t and what is observed.
std::size_t series_columns(const machine::Model& model) { return 1 + model.observed.size(); }

/// It becomes a file's name in the folder of the results.
bool is_plain_name(const std::string& name) {
  return !name.empty() && name.front() != '.' && name.find('/') == std::string::npos &&
         name.find('\\') == std::string::npos;
}

void check_names(const TransientRequest& request, const std::string& path, std::vector<Complaint>& complaints) {
  if (!request.save) return;
  if (!is_plain_name(*request.save)) {
    complaints.push_back({path + ".save", "a file's name is expected; the state goes to the folder of the results"});
  }
  // every table of the results, and every picture of their scenes, is a file
  for (const char* taken : {"result.json", "report.html", "report.md", ".h5", ".csv", ".vtp", ".pvd"}) {
    const bool ending = *taken == '.';
    if (ending ? !request.save->ends_with(taken) : *request.save != taken) continue;
    complaints.push_back(
        {path + ".save",
         ending ? fmt::format("'{}' ends as tables and scenes of the results do: name it as in 'state.json'",
                              *request.save)
                : fmt::format("'{}' is the name of another file of the results", *request.save)});
  }
}

/// Speeds whose signal a deck without signals named.
void check_signals(const machine::Machine& machine, const machine::Model& model, std::vector<Complaint>& complaints) {
  const auto check = [&](const machine::Drive& drive, const std::string& path) {
    if (drive.kind == machine::DriveKind::held || !std::isnan(machine::at(drive.signal, 0).value)) return;
    complaints.push_back({path, fmt::format("there is no signal '{}'", drive.signal.name)});
  };
  for (const machine::Drum& drum : model.drums)
    check(drum.drive, fmt::format("machine.drums.{}.drive.speed", drum.name));
  for (const machine::Motor& motor : model.motors) {
    const bool sheave = std::any_of(machine.sheaves.begin(), machine.sheaves.end(),
                                    [&](const auto& one) { return one.name == motor.name; });
    check(motor.drive, fmt::format("machine.{}.{}.motor.speed", sheave ? "sheaves" : "supports", motor.name));
  }
}

/// A formula without a finite value, rate or acceleration somewhere from `begin` on.
struct FormulaGap {
  const machine::Signal* signal = nullptr;
  std::string words;
};

std::optional<FormulaGap> formula_gap(const machine::Model& model, double begin, double duration) {
  constexpr int places = 2000;
  for (const machine::Signal& signal : model.signals) {
    if (!std::holds_alternative<machine::TimeFormula>(signal.law)) continue;
    for (int i = 0; i <= places; ++i) {
      const double t = begin + duration * i / places;
      const machine::SignalValue is = machine::at(signal, t);
      const bool value = std::isfinite(is.value);
      if (value && std::isfinite(is.rate) && std::isfinite(is.acceleration)) continue;
      return FormulaGap{.signal = &signal,
                        .words = fmt::format("has no finite {} at t = {:.4g} s", value ? "rate" : "value", t)};
    }
  }
  return std::nullopt;
}

/// Of a motion that goes on from a saved state only its start says when it is (solve).
void check_formulas(const machine::Model& model, const TransientRequest& request, std::vector<Complaint>& complaints) {
  if (request.restart) return;
  if (const auto gap = formula_gap(model, 0, request.duration)) {
    complaints.push_back({fmt::format("machine.signals.{}.formula", gap->signal->name), gap->words});
  }
}

/// A cylinder that is ever locked, or moves by a speed, is as stiff as the deck says.
void check_actuators(const machine::Model& model, std::vector<Complaint>& complaints) {
  for (std::size_t i = 0; i < model.actuators.size(); ++i) {
    const machine::Actuator& one = model.actuators[i];
    const bool locks = std::any_of(model.events.begin(), model.events.end(), [&](const machine::Event& e) {
      return e.kind == machine::EventKind::actuator && e.index == static_cast<int>(i) &&
             e.mode == machine::ActuatorMode::lock;
    });
    const bool held = locks || one.mode == machine::ActuatorMode::lock || one.kind == machine::ActuatorKind::speed;
    if (!held || one.lock_stiffness > 0) continue;
    complaints.push_back({fmt::format("machine.actuators.{}", one.name),
                          "is locked or moves by a speed: a motion needs its 'lock_stiffness'"});
  }
}

/// What rope loads and take-up weights need in motion.
void check_rope_loads(const Names& p, std::vector<Complaint>& complaints) {
  const auto& loads = p.machine.rope_loads;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const std::string place = fmt::format("machine.rope_loads[{}]", i);
    if (!loads[i].tangential && !loads[i].rate) {
      complaints.push_back({place, "in motion a force along a rope needs its amount: 'tangential' or 'rate'"});
    }
  }
  for (std::size_t i = 0; i < p.machine.take_up.size(); ++i) {
    const auto& given = p.machine.take_up[i];
    for (const machine::Body& body : p.model.bodies) {
      if (!given.weight || body.name != given.body || body.free.size() <= 1) continue;
      complaints.push_back({fmt::format("machine.take_up[{}].weight", i),
                            "in motion a weight hangs on a body with one way to move ('guide'); else make it a body on "
                            "a rope over a sheave"});
    }
  }
}

/// The place of a name among `things`; a complaint where there is none.
template <class Things>
std::optional<int> slid_index(const Things& things, const char* kind, const std::string& name, const std::string& path,
                              std::vector<Complaint>& complaints) {
  const auto found = std::find_if(things.begin(), things.end(), [&](const auto& one) { return one.name == name; });
  if (found != things.end()) return static_cast<int>(found - things.begin());
  complaints.push_back({path, fmt::format("there is no {} '{}'", kind, name)});
  return std::nullopt;
}

/// What has moved slowly before a sliding start, with all names resolved.
std::vector<solve::Slid> slid_of(const TransientRequest& request, const std::string& path, Names& p) {
  std::vector<solve::Slid> all;
  const bool slides = request.start == TransientRequest::Start::sliding;
  if (slides && request.slid.empty()) {
    p.complaints.push_back({path + ".start", "'sliding' needs 'slid': what has moved slowly, and how far"});
  }
  if (!slides && !request.slid.empty()) {
    p.complaints.push_back({path + ".slid", "belongs to a start 'sliding'"});
  }
  for (std::size_t i = 0; i < request.slid.size(); ++i) {
    const SlidRequest& one = request.slid[i];
    const std::string at = fmt::format("{}.slid[{}]", path, i);
    solve::Slid slid;
    slid.by = one.by;
    slid.drum = one.drum.has_value();
    const auto found = slid.drum
                           ? slid_index(p.model.drums, "drum", *one.drum, at + ".drum", p.complaints)
                           : slid_index(p.model.actuators, "actuator", *one.actuator, at + ".actuator", p.complaints);
    if (!found) continue;
    slid.index = *found;
    if (one.by == 0) p.complaints.push_back({at + ".by", "is no way"});
    const auto index = static_cast<std::size_t>(slid.index);
    if (slid.drum) {
      const machine::Drive& drive = p.model.drums[index].drive;
      if (!drive.brake && drive.kind != machine::DriveKind::held && drive.kind != machine::DriveKind::speed) {
        p.complaints.push_back({at + ".drum", "turns by a force: only rope that is held comes slowly into its place"});
      }
    } else if (!(p.model.actuators[index].lock_stiffness > 0)) {
      p.complaints.push_back({at + ".actuator", "needs its 'lock_stiffness' to hold its length"});
    }
    all.push_back(slid);
  }
  return all;
}

/// A machine without inertia: what would need its mass to have an answer.
void check_quasi_static(const TransientRequest& request, const std::string& path, Names& p) {
  if (!request.quasi_static) return;
  if (request.method != TransientRequest::Method::implicit) {
    p.complaints.push_back({path + ".method", "a quasi-static motion has its own steps"});
  }
  if (request.hoist_factor) {
    p.complaints.push_back(
        {path + ".hoist_factor",
         "without inertia a motion has no peak above the tension at rest: leave out 'quasi_static'"});
  }
  for (std::size_t i = 0; i < p.model.actuators.size(); ++i) {
    const machine::Actuator& one = p.model.actuators[i];
    if (one.kind != machine::ActuatorKind::law || one.lock_stiffness > 0) continue;
    p.complaints.push_back({fmt::format("machine.actuators.{}", one.name),
                            "follows its reference speed in a quasi-static motion: it needs its 'lock_stiffness'"});
  }
}

void check(const TransientRequest& request, const std::string& path, Names& p) {
  std::vector<Complaint>& complaints = p.complaints;
  const double step = request.output_step.value_or(request.duration / 1000);
  if (step > request.duration) complaints.push_back({path + ".output_step", "is longer than the duration"});
  const double lines = lines_of(request), columns = static_cast<double>(series_columns(p.model));
  if (lines > most_lines + 1) {
    complaints.push_back({path + ".output_step", fmt::format("makes {:.6g} lines; up to {:.0f} are written: make it "
                                                             "longer, or the duration shorter",
                                                             lines, most_lines)});
  } else if (lines * columns > most_numbers) {
    complaints.push_back({path + ".output_step",
                          fmt::format("makes {:.0f} lines of {:.0f} columns, {:.3g} numbers; up to {:.3g} are written: "
                                      "make it longer, or name fewer quantities under 'observe'",
                                      lines, columns, lines * columns, most_numbers)});
  }
  if (request.step && *request.step > request.duration) {
    complaints.push_back({path + ".step", "is longer than the duration"});
  }
  if (request.step && request.method == TransientRequest::Method::reference) {
    complaints.push_back({path + ".step", "the reference chooses its steps itself; leave it away"});
  }
  check_names(request, path, complaints);
  check_signals(p.machine, p.model, complaints);
  check_formulas(p.model, request, complaints);
  check_inertia(p.machine, p.model, complaints);
  check_guides(p.machine, complaints);
  check_masses(p.machine, p.model, {.rope_mass = request.rope_mass, .slowly = request.quasi_static}, complaints);
  check_actuators(p.model, complaints);
  check_rope_loads(p, complaints);
  check_quasi_static(request, path, p);
  if (request.hoist_factor) reeving_of(p, request.hoist_factor->rope, path + ".hoist_factor.rope");
}

solve::Start start_of(TransientRequest::Start start) {
  switch (start) {
    case TransientRequest::Start::settled:
      return solve::Start::settled;
    case TransientRequest::Start::sliding:
      return solve::Start::sliding;
    case TransientRequest::Start::assembled:
      break;
  }
  return solve::Start::assembled;
}

}  // namespace

const Description& HoistFactor::describe() {
  using enum Class;
  static const Description d =
      Describe<HoistFactor>()
          .field(&HoistFactor::rope, "rope", "the hoist rope, a reeving")
          .required()
          .choice(&HoistFactor::hoisting_class, "class", {{"HC1", HC1}, {"HC2", HC2}, {"HC3", HC3}, {"HC4", HC4}},
                  "hoisting class of EN 13001-2")
          .field(&HoistFactor::speed, "speed", "v_h", si::m_per_s, "steady hoisting speed of the load")
          .at_least(0)
          .at_most(100)
          .required();
  return d;
}

const Description& SlidRequest::describe() {
  static const Description d =
      Describe<SlidRequest>()
          .field(&SlidRequest::actuator, "actuator", "a cylinder that holds its length")
          .field(&SlidRequest::drum, "drum", "a drum that is held or has a given speed")
          .exactly_one({"actuator", "drum"})
          .field(&SlidRequest::by, "by", "", si::m, "distance extended or rope taken in; below 0 retracted or let out")
          .at_least(-1000)
          .at_most(1000)
          .required();
  return d;
}

const Description& TransientRequest::describe() {
  static const Description d =
      Describe<TransientRequest>()
          .field(&TransientRequest::name, "name",
                 "appended to the names of its tables and files, when a deck has several")
          .field(&TransientRequest::judge, "judge", "false: its states do not count for the verdict")
          .field(&TransientRequest::duration, "duration", "t", si::s, "duration, from the start or the restart")
          .above(0)
          .at_most(3.2e7)
          .required()
          .field(&TransientRequest::output_step, "output_step", "dt", si::s,
                 "time between two recorded lines; default: a thousandth of the duration")
          .above(0)
          .at_most(3.2e7)
          .field(&TransientRequest::tolerance, "tolerance", "", si::one,
                 "largest error of the steps, relative to the largest tension, the size of the machine and the "
                 "energy exchanged; default 1e-5, with the reference 1e-6, with verlet or a given step 1e-3")
          .at_least(1e-12)
          .at_most(0.1)
          .field(&TransientRequest::step, "step", "dt", si::s,
                 "fixed step, without error control; a warning tells an error of the tensions above the tolerance")
          .above(0)
          .choice(&TransientRequest::method, "method",
                  {{"implicit", Method::implicit}, {"verlet", Method::verlet}, {"reference", Method::reference}},
                  "implicit with steps by the tolerance, explicit (verlet) for waves and breaks, or the slow reference "
                  "(IDA of SUNDIALS) to judge both")
          .choice(&TransientRequest::start, "start",
                  {{"settled", Start::settled}, {"assembled", Start::assembled}, {"sliding", Start::sliding}},
                  "settled: from the equilibrium at rest; assembled: places and lengths as described, at rest; "
                  "sliding: settled, with the friction after the slow movement that 'slid' gives")
          .record(&TransientRequest::slid, "slid", "slow movements before a start 'sliding'")
          .field(&TransientRequest::quasi_static, "quasi_static",
                 "true: slow motion without inertia: an equilibrium at the end of every step, with friction")
          .field(&TransientRequest::damping_ratio, "damping_ratio", "zeta", si::one,
                 "damping ratio of ropes without their own, in the lowest mode that stretches the rope")
          .at_least(0)
          .at_most(10)
          .field(&TransientRequest::rope_mass, "rope_mass", "false: ropes without weight and inertia")
          .choice(
              &TransientRequest::branches, "branches",
              {{"straight", Branches::straight}, {"catenary", Branches::catenary}, {"by_weight", Branches::by_weight}},
              "straight: half of the weight of a branch at each end; catenary: the elastic catenary at rest between "
              "its moving ends; by_weight: catenary where a branch weighs more than 5 % of its tension at the start")
          .choice(
              &TransientRequest::arcs, "arcs", {{"stretch", Arcs::stretch}, {"rigid", Arcs::rigid}},
              "stretch: rope on a round stretches with the branches beside it; rigid: it keeps the strain with which "
              "it came there")
          .field(&TransientRequest::save, "save", "file for the final state, in the folder of the results")
          .field(&TransientRequest::restart, "restart",
                 "file with such a state from which to continue, beside the deck")
          .record(&TransientRequest::hoist_factor, "hoist_factor",
                  "checks peak over static tension of a rope against phi2 = phi2_min + beta2 v_h of EN 13001-2");
  return d;
}

solve::Branches branches_of(TransientRequest::Branches branches) {
  switch (branches) {
    case TransientRequest::Branches::catenary:
      return solve::Branches::catenary;
    case TransientRequest::Branches::by_weight:
      return solve::Branches::by_weight;
    case TransientRequest::Branches::straight:
      break;
  }
  return solve::Branches::straight;
}

std::string words_of(const TransientRun& run) {
  return run.request.name ? fmt::format("transient, {}", *run.request.name) : std::string("transient");
}

namespace {

double tolerance_of(const TransientRequest& request) {
  using Method = TransientRequest::Method;
  if (request.tolerance) return *request.tolerance;
  if (request.method == Method::verlet) return coarse_tolerance;
  const bool fine = request.step || request.quasi_static || request.method == Method::reference;
  return fine ? fine_tolerance : usual_tolerance;
}

}  // namespace

double energy_tolerance(const TransientRun& run) {
  const TransientRequest& request = run.request;
  const bool as_given = request.step || request.quasi_static;
  return as_given && !request.tolerance ? coarse_tolerance : tolerance_of(request);
}

TransientRun resolve(const TransientRequest& request, const std::string& path, Names& names) {
  check(request, path, names);
  TransientRun run;
  run.ending = ending_of(names, "transient", request.name, path);
  run.request = request;
  run.slid = slid_of(request, path, names);
  if (names.has_envelope) run.envelope = "envelope_motion";
  return run;
}

void solve(TransientRun& run, const std::optional<solve::DynamicState>& from, const TransientWatchers& watchers) {
  const TransientRequest& request = run.request;
  solve::TransientOptions& o = run.options;
  o.duration = request.duration;
  o.output_step = request.output_step.value_or(0);
  o.step = request.step.value_or(0);
  const bool explicit_steps = request.method == TransientRequest::Method::verlet;
  o.tolerance = tolerance_of(request);
  o.method = explicit_steps ? solve::TimeMethod::verlet : solve::TimeMethod::implicit;
  if (request.method == TransientRequest::Method::reference) o.method = solve::TimeMethod::reference;
  o.start = start_of(request.start);
  o.slid = run.slid;
  o.quasi_static = request.quasi_static;
  o.damping_ratio = request.damping_ratio;
  o.rope_mass = request.rope_mass;
  o.branches = branches_of(request.branches);
  o.arcs = request.arcs == TransientRequest::Arcs::rigid ? solve::Arcs::rigid : solve::Arcs::stretch;
  o.from = from;
  const double begin = from ? from->t : 0;
  if (watchers.progress) {
    o.progress = [&](double t) {
      const double done = (t - begin) / request.duration;
      return watchers.progress(
          {.what = words_of(run),
           .done = done,
           .words = fmt::format("t = {:.4g} s of {:.4g} s, {:.0f} lines of {} columns", t, begin + request.duration,
                                lines_of(request), series_columns(run.model))});
    };
  }
  o.anew = [&] {
    run.record = {};
    if (watchers.anew) watchers.anew();
  };
  o.take = [&](const solve::TransientResult& so_far) {
    run.record.take(so_far);
    if (watchers.so_far) watchers.so_far(so_far);
  };
  o.moment = watchers.moment;
  o.closely = watchers.closely;
  o.moment_step = std::min(request.duration / fewest_moments, most_apart);
  if (const auto gap = formula_gap(run.model, begin, request.duration)) {
    run.result.outcome = infeasible(fmt::format("the formula of the signal '{}' {}", gap->signal->name, gap->words));
  } else {
    run.result = solve::transient(run.model, o);
  }
  o.progress = {};
  o.anew = {};
  o.take = {};
  o.moment = {};
  if (watchers.as_whole) watchers.as_whole(run.result);
  run.record.show(run.result);
}

std::string branch_words(const machine::Reeving& rope, int branch) {
  const auto k = static_cast<std::size_t>(std::max(branch, 0) / std::max(1, rope.segments));
  if (k + 1 > rope.nodes.size()) return {};
  return fmt::format("{} to {}", rope.nodes[k].name, rope.nodes[(k + 1) % rope.nodes.size()].name);
}

namespace {

const Unit& unit_of_event(std::string_view symbol) {
  if (symbol == "T" || symbol == "N") return si::N;
  if (symbol == "v") return si::m_per_s;
  return symbol == "way" || symbol == "L" || symbol == "R" ? si::m : si::one;
}

}  // namespace

std::string values_in_words(const solve::TransientEvent& event, const Display& display) {
  std::string values;
  for (const auto& [symbol, value] : event.values) {
    values += fmt::format("{}{} = {}", values.empty() ? "" : ", ", symbol, display.brief(value, unit_of_event(symbol)));
  }
  return values;
}

const Quantities<solve::TransientEvent>& event_quantities() {
  using Row = solve::TransientEvent;
  static const Quantities<Row> all = {{"t", "t", si::s, "when it happens", &Row::t},
                                      {"what", "", si::one, "what happens", &Row::what},
                                      {"where", "", si::one, "where", &Row::where},
                                      {"values", "", si::one, "numbers that tell more of it, as text",
                                       [](const Row& e) { return values_in_words(e, Display()); }}};
  return all;
}

const Quantities<ObservedRow>& observed_quantities() {
  using Row = ObservedRow;
  const auto extreme = [](double solve::Extreme::*of) {
    return [of](const Row& r) { return r.run.result.extremes[r.observed].*of; };
  };
  static const Quantities<Row> all = {
      {"quantity", "", si::one, "what is observed", [](const Row& r) { return r.run.model.observed[r.observed].name; }},
      {"unit", "", si::one, "its SI unit; empty: a number",
       [](const Row& r) {
         const std::string unit(r.run.model.observed[r.observed].unit.symbol);
         return unit == "1" ? std::string{} : unit;
       }},
      {"min", "", si::one, "least value over all steps of the integrator", extreme(&solve::Extreme::min)},
      {"t_min", "t", si::s, "when that is", extreme(&solve::Extreme::t_min)},
      {"max", "", si::one, "largest value over all steps", extreme(&solve::Extreme::max)},
      {"t_max", "t", si::s, "when that is", extreme(&solve::Extreme::t_max)},
      {"end", "", si::one, "value at the end", extreme(&solve::Extreme::end)}};
  return all;
}

bool begins_at_rest(const TransientRun& run, int reeving) {
  if (run.options.start != solve::Start::assembled || run.options.from || run.result.frames.empty()) return true;
  constexpr double same = 0.01;  // of the tension
  const machine::Reeving& rope = run.model.reevings[reeving];
  const solve::TransientFrame& first = run.result.frames.front();
  const double tension = rope.copies * run.result.ropes[reeving].T_static;
  return std::none_of(rope.nodes.begin(), rope.nodes.end(), [&](const machine::Node& node) {
    if (node.at.body == machine::ground) return false;
    double mass = run.model.bodies[node.at.body].mass;
    for (const machine::Load& load : run.model.loads) {
      if (load.at.body == node.at.body) mass += load.mass;
    }
    return mass * first.bodies[node.at.body].acceleration.norm() > same * tension;
  });
}

bool lifts_from_face(const TransientRun& run, int reeving) {
  const Array<solve::TransientFrame>& frames = run.result.frames;
  const machine::Reeving& rope = run.model.reevings[reeving];
  for (std::size_t i = 0; !frames.empty() && i < run.model.contacts.size(); ++i) {
    const int body = run.model.contacts[i].body;
    const bool held = body != machine::ground && std::any_of(rope.nodes.begin(), rope.nodes.end(),
                                                             [&](const auto& node) { return node.at.body == body; });
    if (!held || !(frames.front().faces[i].closed && frames.front().faces[i].N > 0)) continue;
    if (std::any_of(frames.begin(), frames.end(), [&](const auto& frame) { return !frame.faces[i].closed; }))
      return true;
  }
  return false;
}

const Quantities<DynamicRow>& dynamic_quantities() {
  using Row = DynamicRow;
  const auto of = [](const Row& r) -> const solve::RopeExtreme& { return r.run.result.ropes[r.reeving]; };
  static const Quantities<Row> all = {
      {"rope", "", si::one, "the rope", [](const Row& r) { return r.run.model.reevings[r.reeving].name; }},
      {"T_static", "T_0", si::N, "largest tension at the start", [=](const Row& r) { return of(r).T_static; }},
      {"T_max", "T_max", si::N, "largest tension over the motion", [=](const Row& r) { return of(r).T.max; }},
      {"t_max", "t", si::s, "when that is", [=](const Row& r) { return of(r).T.t_max; }},
      {"where", "", si::one, "branch where that is, by the nodes at its ends",
       [=](const Row& r) { return branch_words(r.run.model.reevings[r.reeving], of(r).branch); }},
      {"T_min", "T_min", si::N, "least tension over the motion; of a rope that breaks up to then",
       [=](const Row& r) { return of(r).T.min; }},
      {"dynamic_factor", "phi", si::one, "peak over static tension", [=](const Row& r) {
         const bool known =
             of(r).T_static > 0 && begins_at_rest(r.run, r.reeving) && !lifts_from_face(r.run, r.reeving);
         return known ? of(r).T.max / of(r).T_static : std::nan("");
       }}};
  return all;
}

}  // namespace taut::study
