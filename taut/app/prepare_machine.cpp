#include "taut/app/prepare_machine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "taut/app/absurd.hpp"
#include "taut/app/design/design_machine.hpp"
#include "taut/app/library/library.hpp"
#include "taut/app/machine_deck.hpp"
#include "taut/app/machine_scope.hpp"
#include "taut/app/machine_steps.hpp"
#include "taut/app/swept_verdict.hpp"
#include "taut/app/terrain.hpp"
#include "taut/base/number.hpp"
#include "taut/checks/checked_parts.hpp"
#include "taut/checks/checks.hpp"
#include "taut/checks/described.hpp"
#include "taut/io/deck/read.hpp"
#include "taut/io/deck/source.hpp"
#include "taut/io/file.hpp"
#include "taut/machine/compile.hpp"
#include "taut/machine/compile/carriage_span.hpp"
#include "taut/machine/description/names.hpp"
#include "taut/results/analyses/analyses.hpp"
#include "taut/results/answers/machine_answers.hpp"
#include "taut/results/described.hpp"
#include "taut/results/fixed_loads.hpp"
#include "taut/results/machine_beams.hpp"
#include "taut/results/machine_figures.hpp"
#include "taut/results/machine_run.hpp"
#include "taut/results/machine_scene.hpp"
#include "taut/results/machine_tables.hpp"
#include "taut/results/merge.hpp"
#include "taut/results/put_up.hpp"
#include "taut/results/rope_stiffness.hpp"
#include "taut/rope/rope_check.hpp"
#include "taut/study/deck/missing.hpp"
#include "taut/study/deck/temperature.hpp"
#include "taut/study/deck/watch.hpp"
#include "taut/study/line/carriage_way.hpp"

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

void note_missing(const study::LoadPathRun& one, const Display& display, Result& r) {
  study::Missing missing;
  for (const study::LoadPathPart& part : one.parts) {
    const auto& first = part.result.points.front();
    if (part.result.outcome.ok() && !first.at.outcome.ok()) {
      r.warnings.push_back(
          fmt::format("load path, x = {}: {}: left out", display.brief(first.x, si::m), first.at.outcome.message));
      continue;
    }
    for (const auto& point : part.result.points) missing.take(point.at.outcome, point.x, display);
  }
  missing.note(r, fmt::format("load path{}, {}", one.ending, one.words), one.judged);
}

/// Ropes that can't all run as they are declared to.
void warn_of_senses(const machine::Machine& machine, const machine::Model& model, const study::LoadPathRun& one,
                    Result& r) {
  study::RopeSenses senses(study::winches_of(model, machine, one.way.carriage));
  for (const study::LoadPathPart& part : one.parts) senses.take(part.model, part.result.points);
  if (const auto contrary = study::contrary_senses(senses.all())) {
    std::string words = fmt::format("load path, {}: {}", one.words, *contrary);
    one.judged ? warn_unsafe(r, std::move(words)) : r.warnings.push_back(std::move(words));
  }
}

/// Equilibria and load paths.
void solve_states(const MachineDeck& deck, results::MachineRun& run, Result& r) {
  for (study::EquilibriumRun& one : run.equilibria) {
    study::solve(run.model, one);
    if (!one.result.outcome.ok()) study::note_failure(r, one.result.outcome, "equilibrium, " + one.words);
  }
  for (study::LoadPathRun& one : run.paths) {
    if (r.interrupted) break;
    study::Watch watch(run.progress, "load path" + one.ending, one.way.steps + 1, run.display);
    study::solve(run.model, one, watch);
    if (const auto words = study::left_out_words(run.model, one.way, run.display)) {
      r.warnings.push_back(fmt::format("load path{}, {}: {}", one.ending, one.words, *words));
    }
    note_missing(one, run.display, r);
    warn_of_senses(deck.machine, run.model, one, r);
    watch.note(r);
  }
  for (const study::EquilibriumRun& one : run.equilibria) {
    if (!one.judged) r.left_out.push_back(checks::analysis_words(one.ending, "equilibrium"));
  }
  for (const study::LoadPathRun& one : run.paths) {
    if (!one.judged) r.left_out.push_back(checks::analysis_words(one.ending, "load path"));
  }
}

/// The values and tables from these on belong to the analysis of that name.
void put_under(const std::string& heading, std::size_t values, std::size_t tables, Result& r) {
  for (std::size_t i = values; i < r.values.size(); ++i) r.values[i].heading = heading;
  for (std::size_t i = tables; i < r.tables.size(); ++i) r.tables[i].heading = heading;
}

/// All other analyses. What they find comes behind the tables and values of the states that they leave.
Result solve_more(const std::vector<study::Asked>& asked, results::MachineRun& run, Result& r) {
  Result more;
  for (const study::Asked& one : asked) {
    if (r.interrupted || more.interrupted) break;
    run.checked->judged = one.judged;
    const std::size_t values = more.values.size(), tables = more.tables.size(), states = run.others.size();
    std::visit([&](const auto& question) { results::add_answer(question, run, more); }, one.question);
    if (run.several) put_under(one.heading, values, tables, more);
    run.checked->judged = true;
    for (std::size_t i = states; i < run.others.size(); ++i) run.others[i].judged = one.judged;
    if (!one.judged) more.left_out.push_back(one.name);
  }
  if (r.status == Status::ok) {
    r.status = more.status;
    r.message = more.message;
  }
  r.interrupted = r.interrupted || more.interrupted;
  return more;
}

/// How a machine was put up.
struct PutUpStates {
  std::vector<study::PutUpLine> lines;
  std::vector<study::PutUpMoment> moments;           ///< of guys and screws
  std::optional<study::PutUpMoment> stands_on_guys;  ///< of guys that have a tension
};

/// Guys, lines and screws. In a load case guys and lines are as on the machine that they were put up on.
Outcome put_up(const MachineDeck& deck, machine::Model& model, PutUpStates& states) {
  const machine::Machine& machine = deck.put_up_on ? *deck.put_up_on : deck.machine;
  machine::Model other;
  if (deck.put_up_on) {
    auto compiled = machine::compile(machine, machine::ModelFor::rest);
    if (!compiled) return infeasible(compiled.error().front().message);
    other = std::move(*compiled);
  }
  machine::Model& built = deck.put_up_on ? other : model;
  if (Outcome outcome = study::install_guys(built, &states.moments); !outcome.ok()) return outcome;
  if (!states.moments.empty()) states.stands_on_guys = study::stand_on_guys(built, machine.reevings.size());
  if (Outcome outcome = study::put_up_lines(built, states.lines); !outcome.ok()) return outcome;
  if (deck.put_up_on) {
    study::keep_guys(machine, built, model);
    study::keep_lines(built, model);
  }
  return study::set_screws_as_on(machine, deck.machine, model, &states.moments);
}

void add_payload_limits(const std::vector<study::Asked>& asked, results::MachineRun& run) {
  for (const study::Asked& one : asked) {
    const auto* payload = std::get_if<study::PayloadRun>(&one.question);
    if (payload != nullptr && one.judged) run.checked->payloads.add(*payload, *run.checked->deck, run.model);
  }
}

/// Infeasible, with the first of these as its reason.
Result refused(const std::vector<Complaint>& complaints) {
  Result r;
  r.status = Status::infeasible;
  r.message = complaints.front().message;
  return r;
}

/// Ropes that a pretension has pulled keep their lengths in it alone: where it counts for the verdict, the other
/// analyses judge another machine.
void add_pulls(const MachineDeck& deck, Result& r) {
  const auto pulls = [](const study::AnalysisRequest& one) {
    return one.pretension && one.pretension->judge && !one.pretension->pull.empty();
  };
  const auto pulled = std::find_if(deck.analyses.begin(), deck.analyses.end(), pulls);
  const bool alone = std::all_of(deck.analyses.begin(), deck.analyses.end(),
                                 [](const study::AnalysisRequest& one) { return one.pretension.has_value(); });
  if (pulled == deck.analyses.end() || alone) return;
  r.unmade.push_back(
      fmt::format("'{}' is pulled in the pretension alone: the other analyses have it as the deck "
                  "describes it. Give the tension that it ends with as its 'install', or its length; or "
                  "give the pretension 'judge: false'",
                  pulled->pretension->pull.front().rope));
  r.warnings.push_back(r.unmade.back());
}

/// Between fixed centres a running rope loses grip that a constant force keeps: what a screw keeps has to be said.
void add_screws(const machine::Machine& machine, Result& r) {
  for (const auto& one : machine.take_up) {
    if (!one.screw || one.keeps != machine::description::ScrewKeeps::unsaid) continue;
    r.unmade.push_back(
        fmt::format("the screw of '{}' is taken as a force that stays the same in every state. Give its take_up "
                    "'keeps: place' (it stays where it was set) or 'keeps: force' (a ram)",
                    one.body));
    r.warnings.push_back(r.unmade.back());
  }
}

/// What a deck gives, with warnings of it.
Result described(const MachineDeck& deck, const machine::Model& model, bool report) {
  Result r;
  r.method_title = "Machine";
  if (report) {
    r.given = given_of(MachineDeck::describe(), &deck);
    r.assumptions = results::assumptions_of(deck.machine, deck.display);
    r.warnings = absurd_machine(deck, model);
    for (std::string& text : dragged_astray(deck.machine, model)) warn_unsafe(r, std::move(text));
  }
  for (const auto& car : deck.machine.carriages) {
    if (!car.from_library.empty()) r.assumptions.push_back(car.from_library);
  }
  results::add_rope_stiffness(deck.machine, r);
  results::warn_of_rope_values(deck.machine, deck.chosen, r);
  if (auto text = survey_warning(model, deck.display)) warn_unsafe(r, *std::move(text));
  return r;
}

/// What holds its ropes and bears its loads otherwise than one may think.
void warn_of_machine(const MachineDeck& deck, const results::MachineRun& run, const PutUpStates& states, Result& r) {
  for (std::string& text : results::held_tension_warnings(deck.machine, run.model, run.display))
    r.warnings.push_back(std::move(text));
  for (std::string& text : results::fixed_load_warnings(run.model, run.display)) warn_unsafe(r, std::move(text));
  for (results::LoadAcross& one : results::load_across_warnings(run.model))
    one.unsafe ? warn_unsafe(r, std::move(one.text)) : r.warnings.push_back(std::move(one.text));
  for (std::string& text : results::fixed_guy_warnings(run.model, deck.machine.reevings.size()))
    warn_unsafe(r, std::move(text));
  for (std::string& text : results::rope_beside_beam_warnings(run.model)) warn_unsafe(r, std::move(text));
  if (!run.judges) return;
  if (states.stands_on_guys) {
    results::note_fallen(run.model, deck.machine.reevings.size(), *states.stands_on_guys, r);
    if (auto text = results::unbalanced_guys(deck.machine, *states.stands_on_guys, run.display))
      r.warnings.push_back(*text);
  }
  if (!run.tells) return;
  add_pulls(deck, r);
  add_screws(deck.machine, r);
}

SweptVerdict judge_apart(const MachineDeck& deck, const results::MachineRun& run, Result& r);

/// Behind the last question whether to go on: an interrupt that nobody has heard yet counts, a later one is not asked
/// for.
void ask_no_more(const std::function<bool(const Progress&)>& progress, Result& r) {
  if (!progress || r.interrupted) return;
  if (progress({.what = "checks", .done = 1, .words = "all analyses done", .last = true})) return;
  r.interrupted = true;
  if (r.status != Status::ok) return;
  r.status = Status::not_converged;
  r.message = "interrupted behind the last analysis";
}

/// All that was asked, as deep as wanted. `run`: what it rests on, for whoever goes on from there.
Result compute(const MachineDeck& deck, machine::Model model, study::AskedAll asked, RunDepth depth,
               const std::function<bool(const Progress&)>& progress, results::MachineRun& run) {
  const bool report = depth == RunDepth::report;
  run.several = asked.equilibria.size() + asked.paths.size() + asked.more.size() > 1;
  run.model = std::move(model);
  run.equilibria = std::move(asked.equilibria);
  run.paths = std::move(asked.paths);
  for (study::Asked& one : asked.more) {
    if (auto* sweep = std::get_if<study::SweepRun>(&one.question)) sweep->put_up_on = deck.put_up_on;
  }
  run.progress = progress;
  run.display = deck.display;
  Result r = described(deck, run.model, report);
  PutUpStates built;
  study::note_failure(r, put_up(deck, run.model, built), "installation");
  if (r.status != Status::ok) {
    if (report) results::add_described_figures(run, "no equilibrium was found", r);
    return r;
  }
  warn_of_machine(deck, run, built, r);
  solve_states(deck, run, r);
  if (run.judges || !asked.more.empty()) run.checked = std::make_shared<checks::CheckedParts>(deck, run.model);
  add_payload_limits(asked.more, run);
  if (run.judges) {
    results::show_put_up(run.model, built.lines, *run.checked);
    for (const study::PutUpMoment& one : built.moments) run.checked->take_put_up(one.model, one.state, one.words);
    if (built.stands_on_guys) results::show_stand_on_guys(deck.machine, *built.stands_on_guys, *run.checked);
    results::show_answers(run, *run.checked);
  }
  Result more = solve_more(asked.more, run, r);
  ask_no_more(progress, r);
  if (depth != RunDepth::values) {
    results::add_tables(run, r);
    results::add_beam_tables(run, r);
  }
  if (run.judges) run.tells ? run.checked->judge.add_values(r) : run.checked->judge.add_tensions(r);
  results::add_values(run, r);
  results::warn_of_strain(deck.machine, deck.chosen, run.model, run.display, r);
  if (run.judges) run.checked->drives.add_checks(r);
  results::warn_of_friction(run.model, r);
  results::add_put_up(run.model, built.lines, r);
  results::add_beam_values(deck.machine, run, r);
  if (report) {
    add_steps(deck, run, r);
    results::add_figures(run, r);
    results::add_beam_plots(run, r);
    results::add_scenes(run, r);
    results::add_answers(deck, run, r);
    r.key_figure = run.key_figure.name;
  }
  results::append(more, r);
  if (run.checked) run.checked->payloads.add_checks(r);
  if (report) {
    for (std::string& words : absurd_answers(results::answers_of(run), run.display))
      r.warnings.push_back(std::move(words));
  }
  SweptVerdict swept = judge_apart(deck, run, r);
  if (run.judges) checks::add_checks(deck, run.model, *run.checked, r);
  std::move(swept).put_numbers_into(r);
  return r;
}

/// One state of a sweep as that of a deck with the swept value.
Result at_value(const MachineDeck& deck, study::EquilibriumRun state) {
  auto model = machine::compile(deck.machine, machine::ModelFor::rest);
  if (!model) return refused(model.error());
  study::AskedAll asked;
  asked.equilibria.push_back(std::move(state));
  results::MachineRun run;
  run.tells = false;
  return compute(deck, std::move(*model), std::move(asked), RunDepth::values, {}, run);
}

/// Whether what a result leaves unjudged is a part that has no limit, by its name.
bool is_part(const machine::Model& model, const std::string& name) {
  const auto named = [&](const auto& one) { return one.name == name; };
  return std::any_of(model.reevings.begin(), model.reevings.end(), named) ||
         std::any_of(model.beams.begin(), model.beams.end(), named);
}

/// Checks that read the machine itself see it at each value of a sweep.
SweptVerdict judge_apart(const MachineDeck& deck, const results::MachineRun& run, Result& r) {
  SweptVerdict verdict;
  for (const study::SweepRun& sweep : run.judged_apart) {
    const auto points = static_cast<int>(sweep.answer.points.size());
    study::Watch watch(run.progress, "checks of the sweep" + sweep.ending, points);
    for (const solve::SweepPoint& point : sweep.answer.points) {
      study::EquilibriumRun state = study::state_at(sweep, point);
      const std::string words = results::state_words(state);
      if (!watch.go_on(words)) break;
      auto machine = study::machine_at(sweep, point.value);
      if (!machine) {
        verdict.take(refused({{.path = "", .message = machine.error().message}}), words);
        continue;
      }
      auto put_up_on = study::put_up_on_at(sweep, point.value);
      if (!put_up_on) {
        verdict.take(refused({{.path = "", .message = put_up_on.error().message}}), words);
        continue;
      }
      MachineDeck there = deck;
      there.machine = *std::move(machine);
      there.put_up_on = *std::move(put_up_on);
      std::vector<Complaint> complaints;
      auto model = machine::compile(there.machine, machine::ModelFor::rest);
      if (model) there.asked = checks::resolve(there, *model, complaints);
      Result at = complaints.empty() ? at_value(there, std::move(state)) : refused(complaints);
      // whether a part has a limit at all is a question to the deck with all its analyses
      std::erase_if(at.unjudged, [&](const std::string& one) { return is_part(run.model, one); });
      verdict.take(std::move(at), words);
    }
    watch.note(r);
  }
  if (!run.judged_apart.empty()) ask_no_more(run.progress, r);
  verdict.put_into(r);
  return verdict;
}

/// The names of what a result has only where its states are shown to the verdict: of other analyses and beams all.
std::set<std::string> judged_names(const results::MachineRun& run, bool more, const Result& whole) {
  Result r;
  if (more || !run.model.beams.empty()) {
    r = whole;
  } else {
    run.checked->judge.add_values(r);
    run.checked->drives.add_checks(r);
  }
  std::set<std::string> names;
  for (const Value& one : r.values) names.insert(one.name);
  for (const Check& one : r.checks) names.insert(one.name);
  return names;
}

/// Ropes whose tension at rest says nothing of their motions, each with why, and with what helps.
std::map<std::string, std::string> ropes_beyond_rest(const results::MachineRun& run) {
  std::map<std::string, std::string> found;
  for (std::size_t i = 0; i < run.model.reevings.size(); ++i) {
    const rope::RopeUse& use = run.checked->ropes.of(i);
    if (rope::rest_is_known(use)) continue;
    found.emplace(use.name, fmt::format("{}; {}", rope::why_rest_is_unknown(use), rope::how_to_know_rest(use)));
  }
  return found;
}

/// What a deck that names nothing to observe has observed is for motions, pulls in turn and vibrations.
machine::ModelFor use_of(const MachineDeck& deck) {
  const bool moves = std::any_of(deck.analyses.begin(), deck.analyses.end(), [](const study::AnalysisRequest& one) {
    return one.transient || one.pretension || one.modes;
  });
  return moves ? machine::ModelFor::motion : machine::ModelFor::rest;
}

/// The machine of a deck with the choice that comes nearest, where no design was found.
void picture_described(const MachineDeck& deck, Result& r) {
  const auto model = machine::compile(deck.machine, use_of(deck));
  if (!model) return;
  std::vector<Complaint> complaints;
  results::MachineRun run;
  run.model = *model;
  run.paths = study::resolve(deck.analyses, deck.design.has_value(), deck.machine, *model, complaints).paths;
  results::add_described_figures(run, "no design was found", r);
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

/// Values stand in the result by their names.
void complain_of_measures(const machine::Machine& machine, std::vector<Complaint>& complaints) {
  std::vector<ValueKind> kinds = results::value_kinds();
  const std::vector<ValueKind>& of_checks = checks::value_kinds();
  kinds.insert(kinds.end(), of_checks.begin(), of_checks.end());
  for (const auto& measure : machine.measures) {
    const auto same = [&](const ValueKind& kind) { return kind.about.name == measure.name; };
    if (std::none_of(kinds.begin(), kinds.end(), same)) continue;
    complaints.push_back(
        {"machine.measures." + measure.name, "is the name of another value of the results: choose one of its own"});
  }
}

void place_in_machine(const io::Node& input, std::vector<Complaint> complaints, Diagnostics& mistakes) {
  for (Complaint& c : complaints) c.path = c.path.empty() ? "machine" : "machine." + c.path;
  io::place(input, complaints, mistakes);
}

/// The files and tables that a deck names, put into it.
bool load_named(const io::Node& input, MachineDeck& deck, bool readable, Diagnostics& mistakes) {
  const std::size_t before = mistakes.size();
  load_terrain(input, deck.machine, mistakes);
  load_restarts(input, deck, mistakes);
  if (readable) take_from_library(input, deck, mistakes);
  return readable && mistakes.size() == before;
}

}  // namespace

std::optional<ReadMachine> read_machine(const io::Node& input, const Display& display, Diagnostics& mistakes) {
  const auto deck = std::make_shared<MachineDeck>();
  deck->display = display;
  const bool read_whole = io::read(input, MachineDeck::describe(), deck.get(), "the deck", mistakes);
  const bool readable = read_whole && !io::has_expression(input);
  if (!load_named(input, *deck, readable, mistakes)) {
    if (all_parts_known(input)) place_in_machine(input, machine::unknown_names(deck->machine), mistakes);
    return std::nullopt;
  }
  ReadMachine read;
  read.study = std::exchange(deck->study, std::nullopt);
  read.calibrate = std::exchange(deck->calibrate, std::nullopt);
  const std::size_t before = mistakes.size();
  if (deck->design) read.space = machine_space(input, *deck, mistakes);
  if (mistakes.size() > before) return std::nullopt;
  // what is free is read as the first of its candidates
  const auto first =
      deck->design ? std::make_shared<MachineDeck>(with_design(*deck, read.space, design::first_place(read.space)))
                   : deck;
  auto model = machine::compile(first->machine, use_of(*first));
  if (!model) {
    place_in_machine(input, model.error(), mistakes);
    return std::nullopt;
  }
  std::vector<Complaint> complaints = not_computed(*first);
  complain_of_measures(first->machine, complaints);
  if (complaints.empty()) first->asked = deck->asked = checks::resolve(*first, *model, complaints);
  if (complaints.empty()) {
    read.asked = study::resolve(first->analyses, first->design.has_value(), first->machine, *model, complaints);
  }
  io::place(input, complaints, mistakes);
  if (!complaints.empty()) return std::nullopt;
  read.deck = deck;
  read.first = first;
  read.model = std::move(*model);
  return read;
}

Outcome renew_checks(const design::DesignSpace& space, MachineDeck& deck) {
  // what is free is read as the first of its candidates
  const MachineDeck first = deck.design ? with_design(deck, space, design::first_place(space)) : deck;
  const auto model = machine::compile(first.machine, use_of(first));
  if (!model) return infeasible(model.error().front().message);
  std::vector<Complaint> complaints;
  deck.asked = checks::resolve(first, *model, complaints);
  if (complaints.empty()) return {};
  return infeasible(fmt::format("{}: {}", complaints.front().path, complaints.front().message));
}

Result run_machine(const MachineDeck& deck, RunDepth depth, const std::function<bool(const Progress&)>& progress,
                   const OneOfMany& many) {
  auto model = machine::compile(deck.machine, use_of(deck));
  if (!model) return refused(model.error());
  std::vector<Complaint> complaints;
  study::AskedAll asked = study::resolve(deck.analyses, deck.design.has_value(), deck.machine, *model, complaints);
  if (!complaints.empty()) return refused(complaints);
  for (std::size_t i = 0; many.near != nullptr && i < std::min(many.near->size(), asked.equilibria.size()); ++i) {
    asked.equilibria[i].near = (*many.near)[i];
  }
  results::MachineRun run;
  run.wants = many.wants;
  run.judges = many.judges;
  const bool more = !asked.more.empty();
  Result r = compute(deck, std::move(*model), std::move(asked), depth, progress, run);
  const bool whole = study::outcome_of_case(r).ok();
  if (many.found != nullptr && whole) {
    for (const study::EquilibriumRun& one : run.equilibria) many.found->push_back(one.result.state);
  }
  if (many.judged != nullptr && whole) *many.judged = judged_names(run, more, r);
  if (many.beyond_rest != nullptr && run.checked) *many.beyond_rest = ropes_beyond_rest(run);
  return r;
}

Result run_near(const MachineDeck& deck, RunDepth depth, const std::function<bool(const Progress&)>& progress,
                States& states) {
  States found;
  Result r = run_machine(deck, depth, progress, {.near = &states, .found = &found});
  if (!found.empty()) states = std::move(found);
  return r;
}

std::function<Result()> prepare_machine(const io::Node& input, Diagnostics& mistakes,
                                        std::function<bool(const Progress&)> progress, const Display& display) {
  auto read = read_machine(input, display, mistakes);
  if (!read) return {};
  if (read->deck->design) {
    const design::DesignTask task = machine_task(read->deck, std::move(read->space),
                                                 {.run = run_near, .picture = picture_described}, std::move(progress));
    return [task] { return design::run_design(task); };
  }
  return [read = std::make_shared<const ReadMachine>(std::move(*read)), progress = std::move(progress)] {
    results::MachineRun run;
    return compute(*read->first, read->model, read->asked, RunDepth::report, progress, run);
  };
}

}  // namespace taut::app
