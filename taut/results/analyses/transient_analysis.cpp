#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "taut/calc/answers.hpp"
#include "taut/checks/checked_parts.hpp"
#include "taut/results/analyses/analyses.hpp"
#include "taut/results/motion/transient_figures.hpp"
#include "taut/results/motion/transient_state.hpp"
#include "taut/results/motion/transient_tables.hpp"

namespace taut::results {
namespace {

constexpr double of_extremes = 1e-6;  ///< what is smaller than this share of its own extremes reads 0

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

/// The largest tensions with their times, and what is observed at the end.
void add_motion(const study::TransientRun& run, const Display& display, Result& r) {
  const solve::TransientResult& result = run.result;
  std::vector<std::size_t> order(result.ropes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return result.ropes[a].T.max > result.ropes[b].T.max; });
  std::vector<std::string> parts;
  for (const std::size_t i : order) {
    const solve::RopeExtreme& rope = result.ropes[i];
    const double times = rope.T_static > 0 ? rope.T.max / rope.T_static : 1;
    const std::string still = times > 1.005 ? fmt::format(", {:.3g} times that at the start", times) : std::string();
    parts.push_back(fmt::format("{} up to {} at t = {:.4g} s{}", run.model.reevings[i].name,
                                display.quantity(rope.T.max, si::N), rope.T.t_max, still));
  }
  if (!run.ending.empty() && !parts.empty()) parts.front() = fmt::format("{}: {}", run.ending.substr(1), parts.front());
  add_answer_line(r, "Motion", parts);
  std::vector<std::string> end = {fmt::format("t = {:.4g} s", result.t_end)};
  for (std::size_t i = 0; i < result.extremes.size(); ++i) {
    const machine::Observable& o = run.model.observed[i];
    const solve::Extreme& e = result.extremes[i];
    if (!std::isfinite(e.end)) continue;
    const bool nothing = std::abs(e.end) < of_extremes * std::max(std::abs(e.min), std::abs(e.max));
    end.push_back(fmt::format("{} {}", o.name, display.quantity(nothing ? 0 : e.end, o.unit)));
  }
  add_answer_line(r, "At the end", end);
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
  add_motion(run, machine.display, r);
  machine.key_figure.offer(Pictured::motion, key_figure_of_motion(run, r));
  if (run.request.save) r.attachments.push_back({*run.request.save, to_json(result.state, run.model)});
}

}  // namespace taut::results
