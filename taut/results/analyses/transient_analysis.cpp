#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <string_view>

#include "taut/calc/answers.hpp"
#include "taut/checks/checked_parts.hpp"
#include "taut/results/analyses/analyses.hpp"
#include "taut/results/motion/straight_ropes.hpp"
#include "taut/results/motion/transient_figures.hpp"
#include "taut/results/motion/transient_state.hpp"
#include "taut/results/motion/transient_tables.hpp"

namespace taut::results {
namespace {

constexpr double of_extremes = 1e-6;  ///< what is smaller than this share of the extremes of its unit reads 0

/// The saved state that the motion goes on from; the outcome says why it can't.
std::optional<solve::DynamicState> saved_state(study::TransientRun& run) {
  if (!run.request.restart) return std::nullopt;
  auto from = state_from_json(run.request.state, run.model, run.options.damping_ratio);
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
  watchers.moment = [&](const solve::TransientResult& so_far, const solve::TransientFrame& moment) {
    checked.take_moment(run.model, so_far, moment, words, name, run.request.quasi_static);
  };
  watchers.closely = checked.judges_sums(run.model);
  watchers.so_far = [&](const solve::TransientResult& so_far) {
    checked.take_moment(run.model, so_far, so_far.frames.back(), words, name, run.request.quasi_static);
  };
  watchers.as_whole = [&](const solve::TransientResult& motion) {
    checked.take(run.model, motion, words, {.slowly = run.request.quasi_static});
  };
  study::solve(run, from, watchers);
}

/// The state at the end. Tensions that were none of rest are not known as such.
solve::DynamicState to_go_on_from(const study::TransientRun& run) {
  solve::DynamicState state = run.result.state;
  for (std::size_t r = 0; r < state.ropes.size(); ++r) {
    if (!study::begins_at_rest(run, static_cast<int>(r)))
      state.ropes[r].T_static = std::numeric_limits<double>::quiet_NaN();
  }
  return state;
}

/// What a reader looks for first: forces, then places, turns and speeds; energies last.
int importance_of(const Unit& unit) {
  const std::array<const Unit*, 4> first = {&si::N, &si::m, &si::rad, &si::m_per_s};
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (unit.symbol == first[i]->symbol) return static_cast<int>(i);
  }
  constexpr int others = 4, energies = 5;
  return unit.symbol == si::J.symbol ? energies : others;
}

/// The number of one observed quantity when the motion ends.
struct EndValue {
  const machine::Observable* what = nullptr;
  double value = 0;
};

/// The most important first, and of one kind what is 0 last.
std::vector<EndValue> end_values(const study::TransientRun& run) {
  std::map<std::string_view, double> largest;  // of each unit
  const auto each = [&](auto&& use) {
    for (std::size_t i = 0; i < run.result.extremes.size(); ++i) use(run.model.observed[i], run.result.extremes[i]);
  };
  each([&](const machine::Observable& o, const solve::Extreme& e) {
    double& most = largest[o.unit.symbol];
    for (const double x : {e.min, e.max}) {
      if (std::isfinite(x)) most = std::max(most, std::abs(x));
    }
  });
  std::vector<EndValue> all;
  each([&](const machine::Observable& o, const solve::Extreme& e) {
    const bool nothing = std::abs(e.end) < of_extremes * largest[o.unit.symbol];
    if (std::isfinite(e.end)) all.push_back({.what = &o, .value = nothing ? 0 : e.end});
  });
  const auto rank = [](const EndValue& one) {
    return std::pair(importance_of(one.what->unit), one.value == 0 ? 1 : 0);
  };
  std::stable_sort(all.begin(), all.end(), [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  return all;
}

/// The largest tensions with their times, and what is observed at the end.
void add_motion(const study::TransientRun& run, const Display& display, bool judged, Result& r) {
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
                                display.brief(rope.T.max, si::N), rope.T.t_max, still));
  }
  if (!run.ending.empty() && !parts.empty()) parts.front() = fmt::format("{}: {}", run.ending.substr(1), parts.front());
  if (!judged) parts.emplace_back(checks::not_judged_words);
  add_answer_line(r, "Motion", parts);
  std::vector<std::string> end = {fmt::format("t = {:.4g} s", result.t_end)};
  for (const EndValue& one : end_values(run))
    end.push_back(fmt::format("{} {}", one.what->name, display.brief(one.value, one.what->unit)));
  add_answer_line(r, "At the end", end);
}

/// Ropes that a motion takes for straight and that pull harder as they really hang: its checks judge too
/// little. One that goes on is compared where the machine as described begins, straight and with its sag: its static
/// tensions are those of there, also of a rope that has broken since.
void warn_of_sag(const study::TransientRun& run, const checks::CheckedParts& checked, Result& r) {
  solve::TransientOptions o = run.options;
  const bool all_hang = o.branches == solve::Branches::catenary && !any_kept_straight(run.model);
  if (!o.rope_mass || all_hang || run.result.interrupted) return;
  solve::TransientFrame begin = run.result.frames.front();
  bool described = true;
  if (run.request.restart) {
    o.from.reset();
    const auto straight = start_as(run.model, o, o.branches);
    described = straight.has_value();
    if (straight) begin = *straight;
  }
  std::optional<Sagging> hangs;
  if (described) hangs = with_sag(run.model, hanging_start(run.model, o), o.start);
  std::vector<double> peaks;
  peaks.reserve(run.result.ropes.size());
  for (const solve::RopeExtreme& rope : run.result.ropes) peaks.push_back(rope.T.max);
  for (std::string& one : sag_warnings(words_of(run), run.model, begin, hangs, peaks, checked.deck->display)) {
    if (checked.judged && checked.deck->checks) r.unmade.push_back(one);
    r.warnings.push_back(std::move(one));
  }
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
  add_transient_tables(run, machine.display, machine.checked->judged, r);
  warn_of_sag(run, *machine.checked, r);
  add_transient_figures(run, r);
  add_motion(run, machine.display, machine.checked->judged, r);
  machine.key_figure.offer(Pictured::motion, key_figure_of_motion(run, r), machine.checked->judged);
  if (run.request.save)
    r.attachments.push_back({*run.request.save, to_json(to_go_on_from(run), run.model, run.options.damping_ratio)});
}

}  // namespace taut::results
