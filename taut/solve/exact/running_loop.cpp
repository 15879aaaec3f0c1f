#include "taut/solve/exact/running_loop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "taut/base/expects.hpp"
#include "taut/solve/exact/loop_system.hpp"

namespace taut::solve {
namespace {

constexpr double first_part_of_loop = 1.0 / 64;  // of sag or distance, where a continuation starts
constexpr double shortest_stride = 1e-4;
constexpr double longest_stride = 1.6;
constexpr double upright = 3;  // fall over reach of the rope between the sections

/// Straight ropes, with half their weights at the ends: closed form at a given slope of the roller's rope.
struct StraightLoop {
  double P_v = 0, H1 = 0, H2 = 0, H3 = 0, H4 = 0;
  double lean = 0;
  bool exists = true;  ///< else no tension of the ropes balances the load: the branches push each other apart
};

StraightLoop straight_loop(const RunningLoop& loop, double x, double f) {
  const double l = loop.span;
  const double y = l - x;
  const double m = loop.rise / l;
  const double stretch = std::hypot(1.0, m);
  const double left = m - f / x;
  const double slope = loop.roller == RollerLaw::free ? m + f / 2 * (1 / y - 1 / x) : 0;
  const double E = x * y / (f * l);
  const double W_u = loop.return_rope.weight * stretch * l / 2;
  const double W_l = stretch * (loop.traction_rope.weight * x + loop.return_rope.weight * y) / 2;
  const double Q = -loop.pull_z + loop.carriage_weight + left * loop.pull_x + W_l;
  const double lever = 1 + slope * left;
  StraightLoop s;
  s.lean = std::atan(slope);
  const LoopNode up = upper_offset(loop);
  // of the roller under the chord of the upper branch
  const double f_u = f + up.z - m * up.x - loop.branch_distance * (std::cos(s.lean) + m * std::sin(s.lean));
  const double resists = f + loop.efficiency * f_u;
  s.exists = resists > 0;
  s.P_v = (loop.efficiency * f_u * Q - f * W_u) / (lever * resists);
  s.H2 = E * (Q - lever * s.P_v);
  s.H4 = loop.efficiency * s.H2;
  s.H3 = s.H4 + s.P_v * slope;
  s.H1 = s.H2 + loop.pull_x - s.P_v * slope;
  return s;
}

/// Starting values from straight ropes. Tensions that come out negative are replaced by small ones.
LoopUnknowns start_of(const RunningLoop& loop, const LoopPlace& place) {
  const double d = loop.second ? loop.second->distance : 0;
  const double m = loop.rise / loop.span;
  const double x1 = loop.second && loop.second->place_is_of_second ? place.x - d : place.x;
  const double y1 = loop.span - x1;
  const StraightLoop s = straight_loop(loop, x1, place.sag);
  const double least = 1e-3 * std::max({std::abs(s.H1), std::abs(s.H2), std::abs(s.H3), std::abs(s.H4)});
  const auto positive = [&](double H) { return std::max(H, least); };
  LoopUnknowns u;
  u.H = {positive(s.H1), positive(s.H2 + loop.pull_x), positive(s.H2), positive(s.H3), positive(s.H4)};
  u.lean = s.lean;
  double f1 = place.sag;
  const double y2 = y1 - d;
  const auto slope_to_B = [&](double f) { return m + f / y1; };
  double delta = d * y2 / y1 * std::max(0.0, -loop.pull_z + slope_to_B(f1) * loop.pull_x) / u.H[2];
  if (loop.second && loop.second->sag_is_of_second) {
    delta = std::min(delta, place.sag / 2);
    f1 = (place.sag - delta) * y1 / y2;
  }
  u.first = {.x = x1, .z = m * x1 - f1};
  u.second = {.x = x1 + d, .z = u.first.z + d * slope_to_B(f1) - delta};
  return u;
}

LoopUnknowns unknowns_of(const LoopState& s) {
  return {.H = {s.lower_A.force.H, s.between.force.H, s.lower_B.force.H, s.upper_A.force.H, s.upper_B.force.H},
          .lean = s.lean,
          .first = s.first,
          .second = s.second};
}

/// A state with its sags taken `times`, and the distance of its sections `apart` times: tensions are about inverse to
/// the sag.
LoopUnknowns deepened(const RunningLoop& loop, const LoopState& s, double times, double apart) {
  LoopUnknowns u = unknowns_of(s);
  const double m = loop.rise / loop.span;
  for (double& H : u.H) H /= times;
  u.first.z = m * u.first.x - (m * u.first.x - u.first.z) * times;
  const double depth = m * u.second.x - u.second.z;
  u.second.x = u.first.x + (u.second.x - u.first.x) * apart;
  u.second.z = m * u.second.x - depth * times;
  return u;
}

/// Deepened until the hung section has the sag of `place`.
LoopUnknowns deepened_to(const RunningLoop& loop, const LoopPlace& place, const LoopState& near) {
  const LoopNode& hung = loop.second && loop.second->sag_is_of_second ? near.second : near.first;
  return deepened(loop, near, place.sag / (loop.rise / loop.span * hung.x - hung.z), 1);
}

std::string kilonewtons(double force) { return fmt::format("{:.3g} kN", force / 1000); }

/// Whether a deeper sag would make the roller press harder. Supports straight above each other on a slope hold the
/// branches closer together than the link is long: at a small sag the link holds the branches apart.
bool wants_depth(const RunningLoop& loop, const LoopPlace& place) {
  const StraightLoop here = straight_loop(loop, place.x, place.sag);
  const StraightLoop deeper = straight_loop(loop, place.x, 1.01 * place.sag);
  return !here.exists || deeper.P_v > here.P_v;
}

Outcome lift_off(const RunningLoop& loop, const LoopPlace& place, double sag, double P_v) {
  if (wants_depth(loop, place)) {
    return infeasible(
        fmt::format("the roller does not reach the upper branch at x = {:.4g} m, sag {:.3g} m (exact catenaries): on "
                    "this slope the branches hang closer together than the branch distance of {:.3g} m; deepen the "
                    "sag, or set the upper supports off across the chord",
                    place.x, place.sag, loop.branch_distance));
  }
  const std::string from = sag < place.sag ? fmt::format(", from a sag of {:.3g} m on", sag) : std::string();
  return infeasible(
      fmt::format("the roller lifts off the upper branch at x = {:.4g} m, sag {:.3g} m{} (exact catenaries: it would "
                  "have to press with {}): steepen the gathering line, lessen the sag, or add carriage weight",
                  place.x, place.sag, from, kilonewtons(P_v)));
}

bool presses(const LoopState& s) { return s.R_z > 0 && s.R_z * std::cos(s.lean) > s.R_x * std::sin(s.lean); }

/// A branch of the return rope whose tension falls where its horizontal tension grows: the deep catenary.
const char* deep_branch(const LoopState& s) {
  const auto is_deep = [](const LoopSpan& span) {
    const LoopSpanRates r = rates_of(span);
    return span.force.H + span.V_start * r.V_start_H < 0 || span.force.H + span.V_end * r.V_end_H < 0;
  };
  return is_deep(s.lower_B)   ? "the lower branch between the carriage and B"
         : is_deep(s.upper_A) ? "the upper branch between A and the roller"
         : is_deep(s.upper_B) ? "the upper branch between the roller and B"
                              : nullptr;
}

/// A converged state is accepted unless the roller would have to pull the upper branch down, or a branch hangs deep.
/// `from`: the sag from which on it is not accepted.
Outcome judge(const RunningLoop& loop, const LoopPlace& place, double from, const LoopState& s) {
  if (!presses(s)) return lift_off(loop, place, from, s.R_z);
  const char* deep = deep_branch(s);
  if (deep == nullptr) return {};
  return infeasible(
      fmt::format("{} hangs so deep at x = {:.4g} m, sag {:.3g} m that its own weight makes its tension (exact "
                  "catenaries): lessen the sag, or keep the carriage farther from the support",
                  deep, place.x, place.sag));
}

/// What stopped a continuation: the last state tells which rope was losing its tension.
Outcome stopped(const RunningLoop& loop, const LoopPlace& place, double part, const LoopState& s) {
  struct Named {
    const LoopSpan* span;
    const char* name;
  };
  const std::array<Named, 4> ropes = {Named{.span = &s.lower_A, .name = "the lower branch between A and the carriage"},
                                      Named{.span = &s.lower_B, .name = "the lower branch between the carriage and B"},
                                      Named{.span = &s.upper_A, .name = "the upper branch between A and the roller"},
                                      Named{.span = &s.upper_B, .name = "the upper branch between the roller and B"}};
  const double load = std::hypot(loop.pull_x, loop.pull_z) + loop.carriage_weight;
  for (const Named& r : ropes) {
    if (r.span->force.H > 1e-3 * load) continue;
    return infeasible(
        fmt::format("{} goes slack at x = {:.4g} m, sag {:.3g} m (exact catenaries): lessen the sag, or "
                    "keep the carriage farther from the support",
                    r.name, place.x, place.sag));
  }
  const double fall = std::abs(s.second.z - s.first.z), reach = std::abs(s.second.x - s.first.x);
  if (loop.second && fall > upright * reach) {
    return infeasible(fmt::format(
        "the rope between the sections stands upright at x = {:.4g} m, sag {:.3g} m (exact catenaries): its horizontal "
        "tension is down to {}, {:.3g} m of fall over {:.3g} m; lessen the sag, or the gathering force along the line",
        place.x, place.sag * part, kilonewtons(s.between.force.H), fall, reach));
  }
  return not_converged(fmt::format(
      "exact catenaries find no equilibrium at x = {:.4g} m, sag {:.3g} m; the last one is at {:.3g} of that sag (and "
      "of the distance of the sections): lessen the sag, or keep the carriage farther from the support",
      place.x, place.sag, part));
}

/// A case on the way from an easy one to the case asked for.
struct Partial {
  RunningLoop loop;
  LoopPlace place;
};

/// The case with its sag and the distance of its sections taken `part` of the way from next to nothing.
Partial part_of(const RunningLoop& loop, const LoopPlace& place, double part) {
  Partial p{.loop = loop, .place = place};
  p.place.sag *= part;
  if (p.loop.second) p.loop.second->distance *= part;
  return p;
}

/// Where a continuation stands: the part of the way that it has gone, the state there, and the sag from which on it is
/// not feasible.
struct Followed {
  double part = first_part_of_loop;
  LoopState last;
  std::optional<double> lost_at;
};

using CaseAt = std::function<Partial(double part)>;
using StartAt = std::function<LoopUnknowns(const LoopState& last, double times)>;

/// Only supports set off along a slope make a case feasible again that was not at a smaller sag.
bool comes_back(const RunningLoop& loop) {
  return loop.offset_is_vertical && loop.branch_distance > 0 && loop.rise != 0;
}

/// Goes on to the whole way, in strides that shorten where Newton does not converge. False: the equilibrium ends.
bool follow_loop(const CaseAt& at, const StartAt& start, bool comes_back, Followed& f) {
  double stride = longest_stride;
  for (;;) {
    if (is_feasible(f.last)) {
      f.lost_at.reset();
    } else if (!f.lost_at) {
      f.lost_at = at(f.part).place.sag;
    }
    if (f.lost_at && !comes_back) return false;
    if (f.part >= 1) return true;
    const double next = std::min(1.0, f.part * stride);
    const Partial p = at(next);
    LoopState tried;
    if (newton(p.loop, p.place, start(f.last, next / f.part), tried)) {
      f.last = tried;
      f.part = next;
      stride = std::min(longest_stride, 1 + 1.5 * (stride - 1));
    } else {
      stride = 1 + (stride - 1) / 3;
      if (stride < 1 + shortest_stride) return false;
    }
  }
}

Outcome ended(const RunningLoop& loop, const LoopPlace& place, const Followed& f) {
  return f.lost_at ? judge(loop, place, *f.lost_at, f.last) : stopped(loop, place, f.part, f.last);
}

/// Follows the equilibrium from a small sag up to the one wanted.
Outcome deepen_to(const RunningLoop& loop, const LoopPlace& place, LoopState& state) {
  Followed f;
  Partial at = part_of(loop, place, f.part);
  for (int i = 0; !newton(at.loop, at.place, start_of(at.loop, at.place), f.last); ++i) {
    const StraightLoop straight = straight_loop(at.loop, at.place.x, at.place.sag);
    if (!straight.exists || straight.P_v <= 0) return lift_off(loop, place, at.place.sag, straight.P_v);
    if (i == 10) return not_converged(fmt::format("exact catenaries find no equilibrium at x = {:.4g} m", place.x));
    at = part_of(loop, place, f.part /= 4);
  }
  const bool whole = follow_loop(
      [&](double part) { return part_of(loop, place, part); },
      [&](const LoopState& last, double times) { return deepened(loop, last, times, times); }, comes_back(loop), f);
  state = f.last;
  return whole && is_feasible(state) ? Outcome{} : ended(loop, place, f);
}

/// With supports straight above each other a small sag on a slope has no equilibrium: this starts from branches with
/// no distance, at the whole sag, and moves them apart.
Outcome part_branches(const RunningLoop& loop, const LoopPlace& place, LoopState& state) {
  RunningLoop together = loop;
  together.branch_distance = 0;
  if (Outcome o = deepen_to(together, place, state); !o.ok()) return o;
  Followed f;
  const CaseAt at = [&](double part) {
    Partial p{.loop = loop, .place = place};
    p.loop.branch_distance *= part;
    return p;
  };
  const Partial first = at(f.part);
  if (!newton(first.loop, first.place, unknowns_of(state), f.last)) {
    return lift_off(loop, place, place.sag, straight_loop(loop, place.x, place.sag).P_v);
  }
  const bool whole = follow_loop(
      at, [&](const LoopState& last, double) { return unknowns_of(last); }, true, f);
  state = f.last;
  return whole && is_feasible(state) ? Outcome{} : ended(loop, place, f);
}

Outcome continue_to(const RunningLoop& loop, const LoopPlace& place, LoopState& state) {
  return comes_back(loop) ? part_branches(loop, place, state) : deepen_to(loop, place, state);
}

}  // namespace

double LoopState::roller_force() const { return std::hypot(R_x, R_z); }

bool is_feasible(const LoopState& s) { return presses(s) && deep_branch(s) == nullptr; }

bool reach_loop(const RunningLoop& loop, const LoopPlace& place, LoopState& state, const LoopState* near) {
  return (near != nullptr && newton(loop, place, deepened_to(loop, place, *near), state)) ||
         newton(loop, place, start_of(loop, place), state);
}

Outcome solve_loop(const RunningLoop& loop, const LoopPlace& place, LoopState& state, const LoopState* near) {
  expects(place.x > 0 && place.x < loop.span && place.sag > 0, "the carriage hangs between the supports");
  expects(loop.efficiency > 0, "a sheave passes tension on");
  const bool reached = reach_loop(loop, place, state, near);
  if (near != nullptr) return reached ? judge(loop, place, place.sag, state) : stopped(loop, place, 1, state);
  if (reached && is_feasible(state)) return {};
  return continue_to(loop, place, state);
}

}  // namespace taut::solve
