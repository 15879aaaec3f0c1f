#include "taut/solve/exact/belt_drive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "taut/base/expects.hpp"
#include "taut/math/roots.hpp"
#include "taut/rope/contact.hpp"

namespace taut::solve {
namespace {

/// The tensions that go with a slack tension: under the load asked for, or at the limit of slip.
struct Tensions {
  double T_1 = 0, T_2 = 0, after_idler = 0, load = 0;
};

Tensions under_load(const BeltDrive& d, double T_2) {
  return {.T_1 = d.idler_loss * T_2 + d.load, .T_2 = T_2, .after_idler = d.idler_loss * T_2, .load = d.load};
}

Tensions at_limit(const BeltDrive& d, double T_2) {
  const double c = d.momentum_flow, T_1 = c + std::exp(d.friction * d.working_arc) * (T_2 - c);
  return {.T_1 = T_1, .T_2 = T_2, .after_idler = d.idler_loss * T_2, .load = T_1 - d.idler_loss * T_2};
}

double idler_tight(const BeltDrive& d, const Tensions& t) {
  return d.place == LoadPlace::at_idler ? t.T_1 : t.after_idler;
}

double pull_on_idler(const BeltDrive& d, const Tensions& t) { return t.T_2 + idler_tight(d, t) - 2 * d.momentum_flow; }

/// Excess of tension over the one at rest, weighed so that it vanishes where the unstretched length is that at rest:
/// the integral of (T - T_0)/(1 + T/EA) ds, N m.
double excess(const BeltDrive& d, const Tensions& t, double T_0) {
  const auto part = [&](double T) { return (T - T_0) / (1 + T / d.stiffness); };
  double sum = d.branch * (part(t.T_2) + (part(idler_tight(d, t)) + part(t.T_1)) / 2);
  if (d.radius == 0) return sum;
  const double c = d.momentum_flow;
  const double slip = std::clamp(std::log((t.T_1 - c) / (t.T_2 - c)) / d.friction, 0.0, d.wrap);
  constexpr int panels = 32;  // Simpson; exact to rounding for so smooth a curve
  double arc = 0;
  for (int i = 0; i <= 2 * panels; ++i) {
    const double weight = i == 0 || i == 2 * panels ? 1 : i % 2 == 1 ? 4 : 2;
    arc += weight * part(c + (t.T_2 - c) * std::exp(d.friction * slip * i / (2 * panels)));
  }
  sum += d.radius * (slip * arc / (6 * panels) + (d.wrap - slip) * part(t.T_1));
  const double idler = std::max(0.0, 2 * std::numbers::pi - d.wrap);
  return sum + d.radius * idler * (part(t.T_2) + part(idler_tight(d, t))) / 2;
}

double loop_length(const BeltDrive& d) { return 2 * d.branch + d.radius * std::max(d.wrap, 2 * std::numbers::pi); }

/// T_2 above c for which the take-up is content; empty where there is none.
template <class Law>
std::optional<double> slack_tension(const BeltDrive& d, const Law& law) {
  const double c = d.momentum_flow;
  const auto f = [&](double above) {
    const Tensions t = law(d, c + above);
    return d.take_up == TakeUp::weight ? pull_on_idler(d, t) - d.pull : excess(d, t, d.pull / 2);
  };
  const double least = 1e-12 * (d.pull + c + d.load);
  const auto above = find_root_above(f, least, d.pull + c + d.load);
  return above ? std::optional(c + *above) : std::nullopt;
}

void fill(const BeltDrive& d, const Tensions& t, BeltDriveState& out) {
  out.T_1 = t.T_1;
  out.T_2 = t.T_2;
  out.load = t.load;
  out.pull = pull_on_idler(d, t);
  rope::Contact contact;
  contact.wrap = d.working_arc;
  contact.friction = d.friction;
  contact.momentum_flow = d.momentum_flow;
  if (const auto creep = rope::belt_creep(contact, t.T_1, t.T_2, d.stiffness)) {
    out.slip_arc = creep->slip_arc;
    out.rest_arc = creep->rest_arc;
    out.creep = creep->creep;
  }
  if (d.take_up == TakeUp::screw) {
    const double scale = std::isfinite(d.stiffness) ? d.stiffness : d.pull;
    out.stretch = std::abs(excess(d, t, d.pull / 2)) / loop_length(d) / scale;
  }
}

}  // namespace

Outcome solve(const BeltDrive& drive, BeltDriveState& out) {
  expects(drive.friction > 0 && drive.working_arc > 0 && drive.working_arc <= drive.wrap * (1 + 1e-12),
          "a friction drive has friction on an arc");
  expects(drive.pull > 0 && drive.branch > 0 && drive.idler_loss >= 1, "a friction drive has a take-up");
  out = {};
  const double c = drive.momentum_flow, e = std::exp(drive.friction * drive.working_arc);
  const auto T_2 = slack_tension(drive, under_load);
  if (T_2) {
    const Tensions t = under_load(drive, *T_2);
    if (t.T_1 - c <= e * (t.T_2 - c) * (1 + 1e-12)) return fill(drive, t, out), Outcome{};
  }
  out.slips = true;
  const auto limit = slack_tension(drive, at_limit);
  if (!limit) {
    return infeasible(
        fmt::format("the rope lifts off its sheaves: against the centrifugal tension of {:.4g} N the take-up leaves no "
                    "tension; pull harder, between fixed centres more than {:.4g} N at rest, or run slower",
                    c, 2 * c));
  }
  const Tensions t = at_limit(drive, *limit);
  if (t.load < 0) {
    return infeasible(
        "the slipping drive can't even turn its idler: raise friction, wrap or the take-up's pull, or run slower");
  }
  fill(drive, t, out);
  return {};
}

}  // namespace taut::solve
