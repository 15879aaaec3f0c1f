#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/solve/motion/run/run.hpp"

namespace taut::solve::dynamics {
namespace {

constexpr double no_rope = 1e-3;          ///< of a line's first length, of one that is whole
constexpr double nearly_no_rope = 0.1;    ///< the same, where a step finds no place for a line
constexpr double hardly_any_rope = 0.02;  ///< the same, where no answer is found
constexpr double near = 1.1;              ///< of the distance at which what a rope goes round would touch
constexpr double nearly_along = 0.99;     ///< cosine between a rope and the axle of a round

}  // namespace

void mark_run_off(Run& run, std::size_t i) {
  run.L_first[i] = 0;
  run.before.lines[i].L = run_off_rest * run.before.lines[i].l;
}

bool used_up(Run& run, std::size_t i) {
  const LineValues& line = run.before.lines[i];
  if (line.gone > 0) return !(free_rope(line) > no_rope * run.L_first[i]);
  if (line.L > run_off_share * line.l) return false;
  const bool once_more = run.L_first[i] == 0;
  if (once_more) mark_run_off(run, i);  // its drum goes to and fro
  return !once_more;
}

namespace {

/// The line with the least rope left, by its first length, and that share.
std::pair<std::size_t, double> shortest(const Run& run) {
  std::pair<std::size_t, double> found{0, 1};
  for (std::size_t i = 0; i < run.m.lines.size(); ++i) {
    const LineValues& line = run.before.lines[i];
    const double rope = std::min(free_rope(line), line.L);  // less than free where it passes a round without touching
    const double left = line.e > 0 ? std::min(rope, line.l) : rope;
    const double share = line.gone > 0 ? left / run.L_first[i] : 1;
    if (share < found.second) found = {i, share};
  }
  return found;
}

/// Whether two rounds of a rope nearly touch.
bool rounds_touch(const Run& run) {
  return std::any_of(run.before.lines.begin(), run.before.lines.end(), [](const LineValues& line) {
    const double between = (line.centre[1] - line.centre[0]).norm();
    return line.radius[0] > 0 && line.radius[1] > 0 && between < near * (line.radius[0] + line.radius[1]);
  });
}

/// A joint of a rope in segments next to the round at the end of its branch, its line; -1: none is.
int joint_at_round(const Run& run) {
  for (std::size_t i = 0; i < run.m.lines.size(); ++i) {
    const LineValues& line = run.before.lines[i];
    if (run.m.lines[i].segment < 0) continue;
    const double radius = std::max(line.radius[0], line.radius[1]);
    if (radius > 0 && (line.centre[1] - line.centre[0]).norm() < near * radius) return static_cast<int>(i);
  }
  return -1;
}

/// Words for a rope that comes along the axle of its round, where no tangent touches it; empty: none does.
std::string along_axle(const Run& run) {
  for (std::size_t i = 0; i < run.m.lines.size(); ++i) {
    const LineValues& line = run.before.lines[i];
    const Line& of = run.m.lines[i];
    for (const std::size_t end : {0U, 1U}) {
      if (line.radius[end] == 0) continue;
      const Vector3 axle = to_ground(run.before.bodies, of.body[end], of.axis[end]);
      if (std::abs(line.t.dot(axle)) < nearly_along) continue;
      const machine::Reeving& rope = run.model.reevings[of.reeving];
      return fmt::format("'{}' runs along the axle of '{}'", rope.name, rope.nodes[end == 0 ? of.from : of.to].name);
    }
  }
  return {};
}

}  // namespace

Outcome failure(Run& run, StepEnd end, double t) {
  const auto [line, share] = shortest(run);
  const double left = end == StepEnd::no_place ? nearly_no_rope : hardly_any_rope;
  if (!run.m.lines.empty() && share <= left) {
    const Line& of = run.m.lines[line];
    const machine::Reeving& rope = run.model.reevings[of.reeving];
    note(run, t, "length_zero", rope.name, {{"L", free_rope(run.before.lines[line])}});
    return infeasible(
        fmt::format("at t = {:.6g} s no rope is left between '{}' and '{}' of '{}': stop the motion before", t,
                    rope.nodes[of.from].name, rope.nodes[of.to].name, rope.name));
  }
  if (end == StepEnd::no_place && rounds_touch(run)) {
    return infeasible(fmt::format(
        "at t = {:.6g} s two rounds of a rope come so near to each other that no rope goes between them", t));
  }
  if (end == StepEnd::no_place && run.m.sagging > 0) {
    return infeasible(fmt::format(
        "at t = {:.6g} s a rope hangs so loose that it would fall off its sheaves: keep it taut, or take 'branches: "
        "by_weight', where it stays straight while it weighs little beside its tension at the start",
        t));
  }
  if (const int joint = joint_at_round(run); end == StepEnd::no_place && joint >= 0) {
    const Line& of = run.m.lines[joint];
    const machine::Reeving& rope = run.model.reevings[of.reeving];
    return infeasible(fmt::format(
        "at t = {:.6g} s a joint between the segments of '{}' comes onto the round '{}': give it fewer 'segments', or "
        "stop the motion before",
        t, rope.name, rope.nodes[run.before.lines[joint].radius[0] > 0 ? of.from : of.to].name));
  }
  if (const std::string rope = along_axle(run); end == StepEnd::no_place && !rope.empty()) {
    return infeasible(fmt::format(
        "at t = {:.6g} s {}: it has left its groove long before. Guide the rope, or hold the turning of what carries "
        "the round",
        t, rope));
  }
  if (run.options.quasi_static && end == StepEnd::singular) {
    return infeasible(
        fmt::format("at t = {:.6g} s there is no equilibrium any more: what is no longer held goes on without end; "
                    "give it a stop, or "
                    "end the motion by an event before",
                    t));
  }
  if (end == StepEnd::to_and_fro) {
    return not_converged(fmt::format(
        "at t = {:.6g} s what slips, sticks or goes slack changes back and forth without end: the reference "
        "does not get past it; take 'method: implicit'",
        t));
  }
  // bodies have masses: what has no answer now is a fault of the search, not of the machine
  const std::string steps = run.h > 0 ? fmt::format(", down to steps of {:.3g} s", run.h) : std::string();
  return not_converged(fmt::format("at t = {:.6g} s no common answer of all ropes and contacts was found{}", t, steps));
}

}  // namespace taut::solve::dynamics
