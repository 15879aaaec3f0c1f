#include "taut/results/motion/transient_run.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>

#include "taut/checks/checked_parts.hpp"
#include "taut/checks/motion_checks.hpp"
#include "taut/results/analyses/machine_analysis.hpp"
#include "taut/results/motion/transient_figures.hpp"
#include "taut/results/motion/transient_state.hpp"
#include "taut/results/motion/transient_tables.hpp"

namespace taut::results {
namespace {

constexpr double most_lines = 1e6, most_numbers = 1e8;
constexpr double usual_tolerance = 1e-6, coarse_tolerance = 1e-3;

double lines_of(const study::TransientRequest& request) {
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

void check_names(const study::TransientRequest& request, const std::string& path, std::vector<Complaint>& complaints) {
  if (!request.save) return;
  if (!is_plain_name(*request.save)) {
    complaints.push_back({path + ".save", "a file's name is expected; the state goes to the folder of the results"});
  }
  for (const char* taken : {"result.json", "report.html", "report.md", "series.h5"}) {
    if (*request.save == taken) complaints.push_back({path + ".save", "is the name of another file of the results"});
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
void check_rope_loads(const Preparation& p, std::vector<Complaint>& complaints) {
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

/// The place of a name among `things`; -1 with a complaint.
template <class Things>
int slid_index(const Things& things, const char* kind, const std::string& name, const std::string& path,
               std::vector<Complaint>& complaints) {
  const auto found = std::find_if(things.begin(), things.end(), [&](const auto& one) { return one.name == name; });
  if (found != things.end()) return static_cast<int>(found - things.begin());
  complaints.push_back({path, fmt::format("there is no {} '{}'", kind, name)});
  return -1;
}

/// What has moved slowly before a sliding start, with all names resolved.
std::vector<solve::Slid> slid_of(const study::TransientRequest& request, const std::string& path, Preparation& p) {
  std::vector<solve::Slid> all;
  const bool slides = request.start == study::TransientRequest::Start::sliding;
  if (slides && request.slid.empty()) {
    p.complaints.push_back({path + ".start", "'sliding' needs 'slid': what has moved slowly, and how far"});
  }
  if (!slides && !request.slid.empty()) {
    p.complaints.push_back({path + ".slid", "belongs to a start 'sliding'"});
  }
  for (std::size_t i = 0; i < request.slid.size(); ++i) {
    const study::SlidRequest& one = request.slid[i];
    const std::string at = fmt::format("{}.slid[{}]", path, i);
    solve::Slid slid;
    slid.by = one.by;
    slid.drum = one.drum.has_value();
    slid.index = slid.drum ? slid_index(p.model.drums, "drum", *one.drum, at + ".drum", p.complaints)
                           : slid_index(p.model.actuators, "actuator", *one.actuator, at + ".actuator", p.complaints);
    if (slid.index < 0) continue;
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
void check_quasi_static(const study::TransientRequest& request, const std::string& path, Preparation& p) {
  if (!request.quasi_static) return;
  if (request.method != study::TransientRequest::Method::implicit) {
    p.complaints.push_back({path + ".method", "a quasi-static motion has its own steps"});
  }
  for (std::size_t i = 0; i < p.model.actuators.size(); ++i) {
    const machine::Actuator& one = p.model.actuators[i];
    if (one.kind != machine::ActuatorKind::law || one.lock_stiffness > 0) continue;
    p.complaints.push_back({fmt::format("machine.actuators.{}", one.name),
                            "follows its reference speed in a quasi-static motion: it needs its 'lock_stiffness'"});
  }
}

void check(const study::TransientRequest& request, const std::string& path, Preparation& p) {
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
  if (request.step && request.method == study::TransientRequest::Method::reference) {
    complaints.push_back({path + ".step", "the reference chooses its steps itself; leave it away"});
  }
  check_names(request, path, complaints);
  check_signals(p.machine, p.model, complaints);
  checks::check_inertia(p.machine, p.model, complaints);
  checks::check_masses(p.machine, p.model, request.rope_mass, complaints);
  check_actuators(p.model, complaints);
  check_rope_loads(p, complaints);
  check_quasi_static(request, path, p);
  if (request.hoist_factor) reeving_of(p, request.hoist_factor->rope, path + ".hoist_factor.rope");
}

}  // namespace

solve::Start start_of(study::TransientRequest::Start start) {
  switch (start) {
    case study::TransientRequest::Start::settled:
      return solve::Start::settled;
    case study::TransientRequest::Start::sliding:
      return solve::Start::sliding;
    case study::TransientRequest::Start::assembled:
      break;
  }
  return solve::Start::assembled;
}

solve::Branches branches_of(study::TransientRequest::Branches branches) {
  switch (branches) {
    case study::TransientRequest::Branches::catenary:
      return solve::Branches::catenary;
    case study::TransientRequest::Branches::by_weight:
      return solve::Branches::by_weight;
    case study::TransientRequest::Branches::straight:
      break;
  }
  return solve::Branches::straight;
}

std::string words_of(const TransientRun& run) {
  return run.request.name ? fmt::format("transient, {}", *run.request.name) : std::string("transient");
}

double energy_tolerance(const TransientRun& run) {
  const study::TransientRequest& request = run.request;
  const bool as_given =
      request.step || request.quasi_static || request.method == study::TransientRequest::Method::verlet;
  return request.tolerance.value_or(as_given ? coarse_tolerance : usual_tolerance);
}

void solve(TransientRun& run, const std::function<bool(const Progress&)>& progress, checks::CheckedParts* checked) {
  const study::TransientRequest& request = run.request;
  solve::TransientOptions& o = run.options;
  o.duration = request.duration;
  o.output_step = request.output_step.value_or(0);
  o.step = request.step.value_or(0);
  const bool explicit_steps = request.method == study::TransientRequest::Method::verlet;
  o.tolerance = request.tolerance.value_or(explicit_steps ? coarse_tolerance : usual_tolerance);
  o.method = explicit_steps ? solve::TimeMethod::verlet : solve::TimeMethod::implicit;
  if (request.method == study::TransientRequest::Method::reference) o.method = solve::TimeMethod::reference;
  o.start = start_of(request.start);
  o.slid = run.slid;
  o.quasi_static = request.quasi_static;
  o.damping_ratio = request.damping_ratio;
  o.rope_mass = request.rope_mass;
  o.branches = branches_of(request.branches);
  if (!request.state.empty()) {
    auto from = state_from_json(request.state, run.model);
    if (!from) {
      run.result.outcome = infeasible(fmt::format("can't go on from '{}': {}", *request.restart, from.error()));
      return;
    }
    o.from = std::move(*from);
  }
  const double begin = o.from ? o.from->t : 0;
  if (progress) {
    o.progress = [&run, &progress, begin](double t) {
      const double done = (t - begin) / run.request.duration;
      return progress({words_of(run), done,
                       fmt::format("t = {:.4g} s of {:.4g} s, {:.0f} lines of {} columns", t,
                                   begin + run.request.duration, lines_of(run.request), series_columns(run.model))});
    };
  }
  const std::string words = words_of(run), name = checks::analysis_name(run.ending, "transient");
  const auto before = checked == nullptr ? nullptr : std::make_shared<const checks::CheckedParts>(*checked);
  o.anew = [&] {
    run.record = {};
    if (checked != nullptr) *checked = *before;
  };
  o.take = [&](const solve::TransientResult& so_far) {
    run.record.take(run.model, so_far);
    if (checked != nullptr) checked->take_moment(run.model, so_far, words, name);
  };
  run.result = solve::transient(run.model, o);
  o.anew = {};
  o.take = {};
  if (checked != nullptr) checked->take(run.model, run.result, run.record.slips(), words);
  run.record.show(run.result);
}

void add_transient(const TransientRun& run, Result& r) {
  const solve::TransientResult& result = run.result;
  if (result.interrupted && !r.interrupted) {
    r.interrupted = true;
    r.status = Status::not_converged;
    r.message = fmt::format("{}: interrupted at t = {:.6g} s; everything here ends there", words_of(run), result.t_end);
  } else if (!result.outcome.ok() && r.status == Status::ok) {
    r.status = result.outcome.status;
    r.message = result.frames.empty() || result.outcome.message.starts_with("at t =")
                    ? fmt::format("{}: {}", words_of(run), result.outcome.message)
                    : fmt::format("{}: at t = {:.6g} s {}", words_of(run), result.t_end, result.outcome.message);
  }
  if (result.frames.empty()) return;
  add_transient_tables(run, r);
  add_transient_figures(run, r);
  if (run.request.save) r.attachments.push_back({*run.request.save, to_json(result.state, run.model)});
}

Analysis prepare_transient(const study::TransientRequest& request, const std::string& path, Preparation& p) {
  check(request, path, p);
  TransientRun run;
  run.ending = ending_of(p, "transient", request.name, path);
  run.request = request;
  run.slid = slid_of(request, path, p);
  const auto& all = p.analyses;
  if (std::any_of(all.begin(), all.end(), [](const auto& one) { return one.envelope.has_value(); })) {
    run.envelope = "envelope_motion";
  }
  return [run](MachineRun& machine, Result& r) {
    if (r.interrupted) return;
    TransientRun one = run;
    one.model = machine.model;
    one.strength_trust = machine.checked->judge.strength_trusts();
    solve(one, machine.progress, machine.checked.get());
    add_transient(one, r);
  };
}

}  // namespace taut::results
