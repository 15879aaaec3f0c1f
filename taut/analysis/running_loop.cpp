#include "taut/analysis/running_loop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/analysis/loop_system.hpp"
#include "taut/base/expects.hpp"

namespace taut::analysis {
namespace {

constexpr double first_part_of_loop = 1.0 / 64;  // of sag or distance, where a continuation starts
constexpr double shortest_stride = 1e-4;
constexpr double longest_stride = 1.6;
constexpr double upright = 3;  // fall over reach of the rope between the sections

/// Straight ropes, with half their weights at the ends: closed form at a given slope of the roller's rope.
struct StraightLoop {
  double P_v = 0, H1 = 0, H2 = 0, H3 = 0, H4 = 0;
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
  s.P_v = (loop.efficiency * Q - W_u) / (lever * (1 + loop.efficiency));
  s.H4 = E * (lever * s.P_v + W_u);
  s.H2 = E * (Q - lever * s.P_v);
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
  u.lean = loop.roller == RollerLaw::free ? std::atan((s.H3 - s.H4) / std::max(s.P_v, least)) : 0;
  double f1 = place.sag;
  const double y2 = y1 - d;
  const auto slope_to_B = [&](double f) { return m + f / y1; };
  double delta = d * y2 / y1 * std::max(0.0, -loop.pull_z + slope_to_B(f1) * loop.pull_x) / u.H[2];
  if (loop.second && loop.second->sag_is_of_second) {
    delta = std::min(delta, place.sag / 2);
    f1 = (place.sag - delta) * y1 / y2;
  }
  u.first = {x1, m * x1 - f1};
  u.second = {x1 + d, u.first.z + d * slope_to_B(f1) - delta};
  return u;
}

LoopUnknowns unknowns_of(const LoopState& s) {
  return {{s.lower_A.force.H, s.between.force.H, s.lower_B.force.H, s.upper_A.force.H, s.upper_B.force.H},
          s.lean,
          s.first,
          s.second};
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

Outcome lift_off(const LoopPlace& place, double sag, double P_v) {
  const std::string from = sag < place.sag ? fmt::format(", from a sag of {:.3g} m on", sag) : std::string();
  return infeasible(
      fmt::format("the roller lifts off the upper branch at x = {:.4g} m, sag {:.3g} m{} (exact catenaries: it would "
                  "have to press with {}): steepen the gathering line, lessen the sag, or add carriage weight",
                  place.x, place.sag, from, kilonewtons(P_v)));
}

/// A converged state is accepted unless the roller would have to pull the upper branch down.
Outcome judge(const LoopPlace& place, double sag, const LoopState& s) {
  return s.R_z > 0 ? Outcome{} : lift_off(place, sag, s.R_z);
}

/// What stopped a continuation: the last state tells which rope was losing its tension.
Outcome stopped(const RunningLoop& loop, const LoopPlace& place, double part, const LoopState& s) {
  struct Named {
    const LoopSpan* span;
    const char* name;
  };
  const std::array<Named, 4> ropes = {Named{&s.lower_A, "the lower branch between A and the carriage"},
                                      Named{&s.lower_B, "the lower branch between the carriage and B"},
                                      Named{&s.upper_A, "the upper branch between A and the roller"},
                                      Named{&s.upper_B, "the upper branch between the roller and B"}};
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

/// The same case with its sag and the distance of its sections taken `part` of the way from next to nothing.
struct Partial {
  RunningLoop loop;
  LoopPlace place;
};

Partial part_of(const RunningLoop& loop, const LoopPlace& place, double part) {
  Partial p{loop, place};
  p.place.sag *= part;
  if (p.loop.second) p.loop.second->distance *= part;
  return p;
}

/// Follows the equilibrium from a small sag up to the one wanted, in strides that shorten where it does not converge.
Outcome continue_to(const RunningLoop& loop, const LoopPlace& place, LoopState& state) {
  double part = first_part_of_loop;
  Partial at = part_of(loop, place, part);
  LoopState last;
  for (int i = 0; !newton(at.loop, at.place, start_of(at.loop, at.place), last); ++i) {
    const double P_v = straight_loop(at.loop, at.place.x, at.place.sag).P_v;
    if (P_v <= 0) return lift_off(place, at.place.sag, P_v);
    if (i == 10) return not_converged(fmt::format("exact catenaries find no equilibrium at x = {:.4g} m", place.x));
    at = part_of(loop, place, part /= 4);
  }
  double stride = longest_stride;
  while (part < 1) {
    if (Outcome o = judge(place, at.place.sag, last); !o.ok()) return state = last, o;
    const double next = std::min(1.0, part * stride);
    at = part_of(loop, place, next);
    LoopState tried;
    if (newton(at.loop, at.place, deepened(loop, last, next / part, next / part), tried)) {
      last = tried;
      part = next;
      stride = std::min(longest_stride, 1 + 1.5 * (stride - 1));
    } else {
      stride = 1 + (stride - 1) / 3;
      if (stride < 1 + shortest_stride) return state = last, stopped(loop, place, part, last);
    }
  }
  state = last;
  return judge(place, place.sag, state);
}

}  // namespace

double LoopState::roller_force() const { return std::hypot(R_x, R_z); }

Outcome solve_loop(const RunningLoop& loop, const LoopPlace& place, LoopState& state, const LoopState* near) {
  expects(place.x > 0 && place.x < loop.span && place.sag > 0, "the carriage hangs between the supports");
  expects(loop.efficiency > 0, "a sheave passes tension on");
  if (near != nullptr) {
    const bool reached = newton(loop, place, deepened_to(loop, place, *near), state) ||
                         newton(loop, place, start_of(loop, place), state);
    return reached ? judge(place, place.sag, state) : stopped(loop, place, 1, state);
  }
  if (newton(loop, place, start_of(loop, place), state) && state.R_z > 0) return {};
  return continue_to(loop, place, state);
}

}  // namespace taut::analysis
