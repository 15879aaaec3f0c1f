#include "taut/app/prepare_machine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "taut/app/absurd.hpp"
#include "taut/app/design/design_machine.hpp"
#include "taut/app/machine_deck.hpp"
#include "taut/app/machine_scope.hpp"
#include "taut/app/machine_steps.hpp"
#include "taut/app/terrain.hpp"
#include "taut/checks/checked_parts.hpp"
#include "taut/checks/checks.hpp"
#include "taut/checks/rope/rope_sense.hpp"
#include "taut/io/deck/read.hpp"
#include "taut/io/deck/source.hpp"
#include "taut/io/file.hpp"
#include "taut/machine/compile.hpp"
#include "taut/machine/compile/carriage_span.hpp"
#include "taut/machine/description/names.hpp"
#include "taut/results/analyses/machine_analysis.hpp"
#include "taut/results/machine_beams.hpp"
#include "taut/results/machine_figures.hpp"
#include "taut/results/machine_run.hpp"
#include "taut/results/machine_scene.hpp"
#include "taut/results/machine_tables.hpp"
#include "taut/results/merge.hpp"
#include "taut/results/missing.hpp"
#include "taut/results/motion/transient_run.hpp"
#include "taut/results/put_up.hpp"
#include "taut/results/rope_stiffness.hpp"
#include "taut/study/carriage_way.hpp"
#include "taut/study/watch.hpp"

namespace taut::app {
namespace {

/// Puts the text of the file that each `restart` names, beside the deck that names it, into its request; notes those
/// that can't be read.
void load_restarts(const io::Node& input, MachineDeck& deck, Diagnostics& mistakes) {
  for (std::size_t i = 0; i < deck.analyses.size(); ++i) {
    if (!deck.analyses[i].transient || !deck.analyses[i].transient->restart) continue;
    study::TransientRequest& request = *deck.analyses[i].transient;
    const io::Node& node = *io::follow(input, fmt::format("analyses[{}].transient.restart", i)).node;
    if (auto file = io::read_named(node, *request.restart, mistakes)) request.state = std::move(file->text);
  }
}

void load_terrain(const io::Node& input, machine::Machine& machine, Diagnostics& mistakes) {
  if (!machine.terrain || !machine.terrain->file) return;
  const io::Node& node = *io::follow(input, "machine.terrain.file").node;
  auto& terrain = *machine.terrain;
  if (!terrain.x.empty() || !terrain.y.empty() || !terrain.z.empty()) {
    io::add(mistakes, node.spot, "terrain: either a 'file' or 'x' and 'z'");
    return;
  }
  if (const auto file = io::read_named(node, *terrain.file, mistakes)) {
    Diagnostics wrong;
    read_terrain(file->text, file->path, terrain, wrong);
    for (Diagnostic& d : wrong) io::add(mistakes, io::without_text(std::move(d), file->text));
  }
}

/// What the analyses of a deck ask for, with names resolved.
class Requests {
 public:
  Requests(const MachineDeck& deck, const machine::Model& model)
      : deck_(deck), model_(model), names_{deck.machine, deck.analyses, model, complaints, {}} {}

  results::MachineRun resolve() {
    results::MachineRun run;
    run.model = model_;
    std::vector<study::AnalysisRequest> all = deck_.analyses;
    if (all.empty()) all.emplace_back().equilibrium.emplace();
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::string path = fmt::format("analyses[{}]", i);
      if (all[i].equilibrium) add(run, *all[i].equilibrium, path + ".equilibrium");
      if (all[i].load_path) add(run, *all[i].load_path, path + ".load_path");
      add(run, results::prepare_payload, all[i].payload, path + ".payload");
      add(run, results::prepare_installation, all[i].installation, path + ".installation");
      add(run, results::prepare_cycle, all[i].cycle, path + ".cycle");
      add(run, results::prepare_envelope, all[i].envelope, path + ".envelope");
      add(run, results::prepare_sweep, all[i].sweep, path + ".sweep");
      add(run, results::prepare_transient, all[i].transient, path + ".transient");
      add(run, results::prepare_pretension, all[i].pretension, path + ".pretension");
      add(run, results::prepare_modes, all[i].modes, path + ".modes");
    }
    check_clamps(run);
    return run;
  }

  std::vector<Complaint> complaints;

 private:
  /// Whether the states of an analysis count; a choice of a design must stand in all of them.
  bool judged(bool asked, const std::string& path) {
    if (!asked && deck_.design) {
      complaints.push_back({path + ".judge", "a design is judged in every state: leave 'judge: false' away"});
    }
    return asked;
  }

  template <class Request>
  void add(results::MachineRun& run,
           results::Analysis (*prepare)(const Request&, const std::string&, results::Preparation&),
           const std::optional<Request>& request, const std::string& path) {
    if (!request) return;
    results::Analysis analysis = prepare(*request, path, names_);
    if (judged(request->judge, path)) {
      run.more.push_back(std::move(analysis));
      return;
    }
    const std::string name = request->name.value_or(path.substr(path.rfind('.') + 1));
    run.more.push_back([analysis = std::move(analysis), name](results::MachineRun& machine, Result& r) {
      machine.checked->judged = false;
      analysis(machine, r);
      machine.checked->judged = true;
      r.left_out.push_back(name);
    });
  }

  void add(results::MachineRun& run, const study::EquilibriumRequest& request, const std::string& path) {
    results::EquilibriumRun one;
    one.judged = judged(request.judge, path);
    one.ending = results::ending_of(names_, "equilibrium", request.name, path);
    one.words = study::words_of(request.motion);
    one.motion = request.motion;
    study::options_of(request.motion, model_, path + ".motion", complaints);
    one.held = request.held;
    one.prescribed = results::prescribed_of(request.carriage, request.x, request.along, path, names_);
    if (request.z && !request.x) complaints.push_back({path, "'z' needs 'carriage' and 'x'"});
    if (one.prescribed) one.prescribed->z = request.z;
    if (request.z && request.given) {
      complaints.push_back(
          {path + ".given", "'z' is in place of what the rope has given already; give one of the two"});
    }
    const int placed = one.prescribed ? one.prescribed->carriage : -1;
    if (request.given) one.given = results::condition_of(*request.given, placed, path + ".given", names_);
    run.equilibria.push_back(std::move(one));
  }

  void add(results::MachineRun& run, const study::LoadPathRequest& request, const std::string& path) {
    results::LoadPathRun one;
    one.judged = judged(request.judge, path);
    one.ending = results::ending_of(names_, "load_path", request.name, path);
    one.words = study::words_of(request.motion);
    one.motion = request.motion;
    study::options_of(request.motion, model_, path + ".motion", complaints);
    one.carriage = results::carriage_of(names_, request.carriage, path + ".carriage");
    study::check_hold(model_, one.carriage, complaints);
    one.along = study::direction_of(request.along, path + ".along", complaints);
    one.from = request.from;
    one.to = request.to;
    one.steps = request.steps;
    one.held = request.held;
    if (request.given) one.given = results::condition_of(*request.given, one.carriage, path + ".given", names_);
    if (request.from == request.to) complaints.push_back({path + ".to", "is the same place as 'from'"});
    run.paths.push_back(std::move(one));
  }

  /// A carriage that is clamped or fixed needs to know where.
  void check_clamps(const results::MachineRun& run) {
    for (std::size_t i = 0; i < deck_.machine.carriages.size(); ++i) {
      const auto& given = deck_.machine.carriages[i];
      const bool clamped = given.hold == machine::description::Hold::clamped;
      if ((!clamped && !given.fixed_to) || given.length_before) continue;
      const bool placed =
          std::all_of(run.equilibria.begin(), run.equilibria.end(), [&](const results::EquilibriumRun& one) {
            return one.prescribed && one.prescribed->carriage == static_cast<int>(i);
          });
      if (placed) continue;
      complaints.push_back(
          {fmt::format("machine.carriages.{}", given.name),
           fmt::format("is {} somewhere: give 'length_before', or 'carriage' and 'x' in the equilibrium",
                       clamped ? "clamped" : "fixed to '" + *given.fixed_to + "'")});
    }
  }

  const MachineDeck& deck_;
  const machine::Model& model_;
  results::Preparation names_;
};

void solve(const machine::Model& model, results::EquilibriumRun& one) {
  one.model = one.prescribed
                  ? machine::with_carriage_at(model, one.prescribed->carriage, one.prescribed->x, one.prescribed->along)
                  : model;
  std::vector<Complaint> reported_before;
  solve::EquilibriumOptions options = study::options_of(one.motion, one.model, {}, reported_before);
  options.prescribed = one.prescribed;
  options.held = one.held;
  if (one.given) {
    auto found = solve::equilibrium_under(one.model, *one.given, options);
    one.model = std::move(found.model);
    one.result = std::move(found.result);
  } else {
    one.result = solve::equilibrium(one.model, options);
  }
}

/// The load path span by span; positions on a support stay without an answer.
void solve(const machine::Model& model, results::LoadPathRun& one, study::Watch& watch) {
  const study::Way way{one.carriage, one.from, one.to, one.steps, one.along};
  for (study::WayPart& place : study::parts_of(model, way)) {
    if (watch.ended()) return;
    results::LoadPathPart part;
    part.model = std::move(place.model);
    if (place.support != nullptr) {
      study::LoadPathPoint point;
      point.x = way.x(place.first);
      point.at.outcome = infeasible(fmt::format("the carriage is on '{}'", place.support->name));
      part.result.points.push_back(std::move(point));
      one.parts.push_back(std::move(part));
      continue;
    }
    std::vector<Complaint> reported_before;
    study::LoadPathOptions options;
    options.carriage = one.carriage;
    options.from = way.x(place.first);
    options.to = way.x(place.last);
    options.steps = std::max(1, place.last - place.first);
    options.along = one.along;
    options.equilibrium = study::options_of(one.motion, part.model, {}, reported_before);
    options.equilibrium.band = false;
    options.equilibrium.held = one.held;
    options.condition = one.given;
    options.go_on = [&](double x) { return watch.go_on_at(x); };
    part.result = study::load_path(part.model, options);
    if (part.result.points.empty()) return;
    if (place.last == place.first) part.result.points.resize(1);
    one.parts.push_back(std::move(part));
  }
}

void note_missing(const results::LoadPathRun& one, Result& r) {
  results::Missing missing;
  for (const results::LoadPathPart& part : one.parts) {
    const auto& first = part.result.points.front();
    if (part.result.outcome.ok() && !first.at.outcome.ok()) {
      r.warnings.push_back(fmt::format("load path, x = {:.6g} m: {}: left out", first.x, first.at.outcome.message));
      continue;
    }
    for (const auto& point : part.result.points) missing.take(point.at.outcome, point.x);
  }
  missing.note(r, fmt::format("load path{}, {}", one.ending, one.words), one.judged);
}

/// Ropes that can't all run as they are declared to.
void warn_of_senses(const machine::Machine& machine, const machine::Model& model, const results::LoadPathRun& one,
                    Result& r) {
  checks::RopeSenses senses(checks::winches_of(model, machine, one.carriage));
  for (const results::LoadPathPart& part : one.parts) senses.take(part.model, part.result.points);
  if (const auto contrary = checks::contrary_senses(senses.all())) {
    warn_unsafe(r, fmt::format("load path, {}: {}", one.words, *contrary));
  }
}

/// Equilibria and load paths.
void solve_states(const MachineDeck& deck, results::MachineRun& run, Result& r) {
  for (results::EquilibriumRun& one : run.equilibria) {
    solve(run.model, one);
    results::note_failure(r, one.result.outcome, fmt::format("equilibrium, {}", one.words));
  }
  for (results::LoadPathRun& one : run.paths) {
    if (r.interrupted) break;
    study::Watch watch(run.progress, "load path" + one.ending, one.steps + 1);
    solve(run.model, one, watch);
    note_missing(one, r);
    warn_of_senses(deck.machine, run.model, one, r);
    watch.note(r);
  }
  for (const results::EquilibriumRun& one : run.equilibria) {
    if (!one.judged) r.left_out.push_back(checks::analysis_words(one.ending, "equilibrium"));
  }
  for (const results::LoadPathRun& one : run.paths) {
    if (!one.judged) r.left_out.push_back(checks::analysis_words(one.ending, "load path"));
  }
}

/// All other analyses. What they find comes behind the tables and values of the states that they leave.
Result solve_more(results::MachineRun& run, Result& r) {
  Result more;
  for (const results::Analysis& one : run.more) {
    if (r.interrupted || more.interrupted) break;
    one(run, more);
  }
  if (r.status == Status::ok) {
    r.status = more.status;
    r.message = more.message;
  }
  r.interrupted = r.interrupted || more.interrupted;
  return more;
}

/// `checks_only`: without what nothing but a report needs.
Result compute(const MachineDeck& deck, results::MachineRun run, const std::function<bool(const Progress&)>& progress,
               bool checks_only = false) {
  run.progress = progress;
  Result r;
  r.method_title = "Machine";
  if (!checks_only) r.given = given_of(MachineDeck::describe(), &deck);
  if (!checks_only) r.assumptions = results::assumptions_of(deck.machine);
  if (!checks_only) r.warnings = absurd_machine(deck, run.model);
  results::add_rope_stiffness(deck.machine, r);
  if (auto warning = terrain_warning(run.model)) r.warnings.push_back(std::move(*warning));
  results::note_failure(r, results::install_guys(deck.machine, run.model), "installation");
  if (r.status != Status::ok) return r;
  std::vector<study::PutUpLine> lines;
  results::note_failure(r, results::put_up_lines(run.model, lines), "installation");
  if (r.status != Status::ok) return r;
  for (std::string& text : results::held_tension_warnings(deck.machine, run.model))
    r.warnings.push_back(std::move(text));
  solve_states(deck, run, r);
  run.checked = std::make_shared<checks::CheckedParts>(deck, run.model);
  results::show_put_up(run.model, lines, *run.checked);
  results::show_answers(run, *run.checked);
  Result more = solve_more(run, r);
  results::add_tables(run, r);
  results::add_beam_tables(run, r);
  run.checked->judge.add_values(r);
  results::add_values(run, r);
  run.checked->drives.add_checks(r);
  results::warn_of_friction(run.model, r);
  results::add_put_up(run.model, lines, r);
  results::add_beam_values(deck.machine, run, r);
  if (!checks_only) {
    add_steps(deck, run, r);
    results::add_figures(run, r);
    results::add_beam_plots(run, r);
    results::add_scenes(run, r);
  }
  results::append(more, r);
  if (!checks_only) {
    for (std::string& words : absurd_answers(results::answers_of(run))) r.warnings.push_back(std::move(words));
  }
  checks::add_checks(deck, run.model, *run.checked, r);
  return r;
}

/// A deck whose mistakes are reported already, with other numbers than it was read with. One of which a state is
/// missing can't be judged: it is no choice.
Result compute_again(const MachineDeck& deck, bool checks_only, const std::function<bool(const Progress&)>& progress) {
  auto model = machine::compile(deck.machine);
  if (!model) {
    Result r;
    r.status = Status::infeasible;
    r.message = model.error().front().message;
    return r;
  }
  Requests requests(deck, *model);
  Result r = compute(deck, requests.resolve(), progress, checks_only);
  if (r.status == Status::ok && !r.missing.empty()) {
    r.status = Status::infeasible;
    r.message =
        fmt::format("{}, {}: {}", r.missing.front().analysis, r.missing.front().first, r.missing.front().reason);
  }
  return r;
}

/// Whether every part of the machine could be looked up: where a list is called by a wrong name, all its names would be
/// missed too.
bool all_parts_known(const io::Node& input) {
  const io::Node* machine = input.find("machine");
  if (machine == nullptr) return false;
  const Description& known = machine::Machine::describe();
  return std::all_of(machine->entries.begin(), machine->entries.end(),
                     [&](const io::Entry& e) { return known.find(e.key) != nullptr; });
}

void place_in_machine(const io::Node& input, std::vector<Complaint> complaints, Diagnostics& mistakes) {
  for (Complaint& c : complaints) c.path = c.path.empty() ? "machine" : "machine." + c.path;
  io::place(input, complaints, mistakes);
}

}  // namespace

std::function<Result()> prepare_machine(const io::Node& input, Diagnostics& mistakes,
                                        std::function<bool(const Progress&)> progress) {
  const auto deck = std::make_shared<MachineDeck>();
  const bool readable = io::read(input, MachineDeck::describe(), deck.get(), "the deck", mistakes);
  const std::size_t before = mistakes.size();
  load_terrain(input, deck->machine, mistakes);
  load_restarts(input, *deck, mistakes);
  if (!readable || mistakes.size() > before) {
    if (all_parts_known(input)) place_in_machine(input, machine::unknown_names(deck->machine), mistakes);
    return {};
  }
  design::DesignSpace space;
  if (deck->design) {
    space = machine_space(input, *deck, mistakes);
    if (mistakes.size() > before) return {};
  }
  // what is free is read as the first of its candidates
  const auto first =
      deck->design ? std::make_shared<MachineDeck>(with_design(*deck, space, design::first_place(space))) : deck;
  auto model = machine::compile(first->machine);
  if (!model) {
    place_in_machine(input, model.error(), mistakes);
    return {};
  }
  if (const auto missing = not_computed(*first); !missing.empty()) {
    io::place(input, missing, mistakes);
    return {};
  }
  if (const auto wrong = checks::check_complaints(*first, *model); !wrong.empty()) {
    io::place(input, wrong, mistakes);
    return {};
  }
  Requests requests(*first, *model);
  const auto run = std::make_shared<results::MachineRun>(requests.resolve());
  if (!requests.complaints.empty()) {
    io::place(input, requests.complaints, mistakes);
    return {};
  }
  if (deck->design) {
    const design::DesignTask task = machine_task(deck, std::move(space), compute_again, std::move(progress));
    return [task] { return design::run_design(task); };
  }
  return [first, run, progress = std::move(progress)] { return compute(*first, *run, progress); };
}

}  // namespace taut::app
