#include <fmt/format.h>

#include "taut/checks/checked_parts.hpp"
#include "taut/results/analyses/analyses.hpp"
#include "taut/results/motion/transient_figures.hpp"
#include "taut/results/motion/transient_state.hpp"
#include "taut/results/motion/transient_tables.hpp"

namespace taut::results {
namespace {

/// The saved state that the motion goes on from; the outcome says why it can't.
std::optional<solve::DynamicState> saved_state(study::TransientRun& run) {
  if (run.request.state.empty()) return std::nullopt;
  auto from = state_from_json(run.request.state, run.model);
  if (from) return std::move(*from);
  run.result.outcome = infeasible(fmt::format("can't go on from '{}': {}", *run.request.restart, from.error()));
  return std::nullopt;
}

void solve(study::TransientRun& run, MachineRun& machine) {
  const auto from = saved_state(run);
  if (!run.result.outcome.ok()) return;
  checks::CheckedParts& checked = *machine.checked;
  const checks::CheckedParts before = checked;
  const std::string words = words_of(run), name = checks::analysis_name(run.ending, "transient");
  study::TransientWatchers watchers;
  watchers.progress = machine.progress;
  watchers.anew = [&] { checked = before; };
  watchers.so_far = [&](const solve::TransientResult& so_far) { checked.take_moment(run.model, so_far, words, name); };
  watchers.as_whole = [&](const solve::TransientResult& motion) {
    checked.take(run.model, motion, run.record.slips(), words);
  };
  study::solve(run, from, watchers);
}

}  // namespace

void add_answer(const study::TransientRun& asked, MachineRun& machine, Result& r) {
  if (r.interrupted) return;
  study::TransientRun run = asked;
  run.model = machine.model;
  solve(run, machine);
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
  add_transient_tables(run, machine.checked->judge.strength_trusts(), r);
  add_transient_figures(run, r);
  if (run.request.save) r.attachments.push_back({*run.request.save, to_json(result.state, run.model)});
}

}  // namespace taut::results
