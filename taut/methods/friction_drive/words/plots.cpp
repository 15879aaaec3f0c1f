#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/methods/friction_drive/figures.hpp"
#include "taut/methods/friction_drive/grip.hpp"

namespace taut::friction_drive {
namespace {

constexpr int points = 121;

double between(double low, double high, int i) { return low + (high - low) * i / (points - 1); }

/// Tension along the arc that grows from `slack` as Euler has it, up to `most`: dP/d(angle) = mu (P - c).
Curve euler_curve(const char* label, const Input& in, const Output& out, double slack, double most) {
  Curve c{.label = label, .x = {}, .y = {}, .dashed = false, .points_only = false};
  for (int i = 0; i < points; ++i) {
    const double angle = between(0, out.phi, i);
    c.x.push_back(angle);
    c.y.push_back(std::min(most, out.c + (slack - out.c) * std::exp(in.friction * angle)));
  }
  return c;
}

/// Where the curves over friction begin: below it there is no grip worth drawing.
double least_friction(const Input& in) {
  return std::clamp(friction_for(in, in.idler_loss * 1.02).value_or(in.friction / 4), 1e-4, in.friction);
}

}  // namespace

Plot arc_plot(const Input& in, const Output& out) {
  Plot p{.name = "arc",
         .title = "Tension along the driving sheave",
         .caption =
             "From the slack to the tight side of the working arc. Without slip the rope creeps on the part where the "
             "tension "
             "rises and rests on the other. From the paper's T_2 the grip can't reach the paper's T_1.",
         .x = {.label = "angle on the working arc", .unit = si::rad},
         .y = {.label = "tension", .unit = si::N},
         .curves = {},
         .marks = {}};
  const double no_limit = std::numeric_limits<double>::infinity();
  p.curves = {euler_curve("no slip, with the reserve m", in, out, out.T_2_no_slip, out.T_1_no_slip),
              euler_curve("(15), (16): at the limit", in, out, out.P_slack, no_limit),
              euler_curve("Euler's bound from the paper's T_2", in, out, out.T_2, no_limit)};
  p.curves[1].dashed = true;
  p.curves[2].dashed = true;
  p.marks = {{.x = 0, .y = out.T_1, .label = "paper's T_1", .whole_line = true}};
  return p;
}

Plot friction_plot(const Input& in, const Output& out, const Display& display) {
  const double top = std::clamp(2 * in.friction, 0.5, 1.5);
  Curve reserve{.label = fmt::format("with the reserve m = {:.3g}", in.grip_reserve),
                .x = {},
                .y = {},
                .dashed = false,
                .points_only = false};
  Curve limit{.label = "at the limit of slip", .x = {}, .y = {}, .dashed = true, .points_only = false};
  Input at = in;
  for (int i = 0; i < points; ++i) {
    const double mu = between(top / (points - 1), top, i);
    at.friction = mu;
    const double e = grip_ratio(at);
    reserve.x.push_back(mu);
    limit.x.push_back(mu);
    reserve.y.push_back(transmissible_force(out.takeup_no_slip, e, in.grip_reserve));
    limit.y.push_back(transmissible_force(out.takeup_no_slip, e, 1));
  }
  return {.name = "grip_over_friction",
          .title = "Cutting force passed on over friction",
          .caption = fmt::format("Idler pulled by takeup_no_slip = {}, idler loss left out.",
                                 display.brief(out.takeup_no_slip, si::N)),
          .x = {.label = "friction mu", .unit = si::one},
          .y = {.label = "cutting force", .unit = si::N},
          .curves = {std::move(reserve), std::move(limit)},
          .marks = {{.x = in.friction, .y = in.cutting_force, .label = "working point", .whole_line = false}}};
}

Plot pull_plot(const Input& in, const Output& out) {
  Curve no_slip{.label = "without slip", .x = {}, .y = {}, .dashed = false, .points_only = false},
      with_loss{.label = "with the idler loss", .x = {}, .y = {}, .dashed = false, .points_only = false};
  Curve paper{.label = "by (18)", .x = {}, .y = {}, .dashed = true, .points_only = false};
  const double low = least_friction(in), top = std::clamp(2 * in.friction, 0.5, 1.5);
  const double roof = 6 * out.takeup_no_slip;  // the curves go to infinity where the grip ends
  const auto below_roof = [&](double y) { return y >= 0 && y <= roof ? y : not_computed; };
  Input at = in;
  for (int i = 0; i < points; ++i) {
    const double mu = between(low, top, i);
    at.friction = mu;
    Output there;
    const bool grips = solve(at, there).ok();
    for (Curve* c : {&no_slip, &with_loss, &paper}) c->x.push_back(mu);
    no_slip.y.push_back(grips ? below_roof(there.takeup_no_slip) : not_computed);
    with_loss.y.push_back(grips ? below_roof(there.takeup_with_idler_loss) : not_computed);
    paper.y.push_back(grips ? below_roof(there.P_M) : not_computed);
  }
  return {.name = "pull_over_friction",
          .title = "Pull on the idler over friction",
          .caption = "What the cutting force asks of the take-up. A rope that gets wet or oily moves to the left.",
          .x = {.label = "friction mu", .unit = si::one},
          .y = {.label = "pull on the idler", .unit = si::N},
          .curves = {std::move(no_slip), std::move(with_loss), std::move(paper)},
          .marks = {{.x = in.friction, .y = out.takeup_no_slip, .label = "here", .whole_line = false}}};
}

Plot speed_plot(const Input& in, const Output& out) {
  const double lost = std::isfinite(out.speed_of_lost_grip) ? out.speed_of_lost_grip : 0;
  const double top = std::max({1.15 * lost, 1.3 * in.speed, 1.0});
  Curve weight{.label = "constant pull (weight)", .x = {}, .y = {}, .dashed = false, .points_only = false};
  Curve screw{.label = "screw, set to the same pull at rest", .x = {}, .y = {}, .dashed = false, .points_only = false};
  for (int i = 0; i < points; ++i) {
    const double U = between(0, top, i);
    const double pull = out.takeup_no_slip - 2 * in.rope_mass * square(U);
    weight.x.push_back(U);
    screw.x.push_back(U);
    weight.y.push_back(transmissible_force(out.takeup_no_slip, out.e, in.grip_reserve));
    screw.y.push_back(transmissible_force(pull, out.e, in.grip_reserve));
  }
  Plot p{
      .name = "grip_over_speed",
      .title = "Cutting force passed on over speed",
      .caption =
          "With the reserve m, idler loss left out. A weight follows the centrifugal tension; between fixed sheaves it "
          "takes "
          "the grip away.",
      .x = {.label = "rope speed", .unit = si::m_per_s},
      .y = {.label = "cutting force", .unit = si::N},
      .curves = {std::move(weight), std::move(screw)},
      .marks = {{.x = in.speed, .y = in.cutting_force, .label = "working point", .whole_line = false}}};
  if (lost > 0) p.marks.push_back({lost, 0, "grip lost", false});
  return p;
}

}  // namespace taut::friction_drive
