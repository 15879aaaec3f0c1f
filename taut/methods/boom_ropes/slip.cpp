#include "taut/methods/boom_ropes/slip.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "taut/math/roots.hpp"

namespace taut::boom_ropes {
namespace {

struct Pads {
  double front = 0;
  double rear = 0;
};

}  // namespace

double free_slip_angle(double section_weight, double suspended_weight, double friction, double tackle_efficiency,
                       int falls) {
  const double lead = suspended_weight * tackle_efficiency / falls;
  const double weight = section_weight + suspended_weight;
  return std::atan(friction) - std::asin(lead / (weight * std::hypot(1, friction)));
}

SlipAngle slip_angle(const Input& in, const Sliding& sliding, const Slip& slip) {
  const double f0 = sliding.static_friction;
  const double travel = (slip.boom_length - sliding.retracted_length) / 2;
  const double overlap = sliding.overlap_23 - travel + slip.overlap_change;
  const double weight = in.section_weight + slip.suspended_weight;
  const double lead = slip.suspended_weight * in.tackle_efficiency / slip.falls;
  SlipAngle out;
  out.free_angle = free_slip_angle(in.section_weight, slip.suspended_weight, f0, in.tackle_efficiency, slip.falls);
  if (travel < 0 || travel > sliding.stroke) {
    out.reason = fmt::format("boom length {:.6g} m is outside {:.6g} ... {:.6g} m", slip.boom_length,
                             sliding.retracted_length, sliding.retracted_length + 2 * sliding.stroke);
    return out;
  }
  if (!(overlap > 0)) {
    out.reason = fmt::format("no overlap is left between sections 2 and 3 ({:.3g} m)", overlap);
    return out;
  }
  const auto pads = [&](double beta) {
    const double moments =
        std::cos(beta) * (in.section_weight * sliding.center_3 + slip.suspended_weight * sliding.head_distance -
                          f0 * sliding.pad_height_3 / 2 * weight) -
        sliding.offset_hoist * slip.suspended_weight * std::sin(beta) - sliding.offset_lead * lead;
    const double front = moments / overlap;
    return Pads{.front = front, .rear = weight * std::cos(beta) - front};
  };
  const auto excess = [&](double beta) {
    const Pads p = pads(beta);
    return lead + weight * std::sin(beta) - f0 * (std::abs(p.front) + std::abs(p.rear));
  };
  // Offsets can bend the curve, so the first change of sign is looked for in small steps.
  constexpr int steps = 900;  // of a right angle
  constexpr double right_angle = std::numbers::pi / 2;
  double from = -right_angle;
  std::optional<double> root = excess(from) >= 0 ? std::optional<double>(from) : std::nullopt;
  for (int i = 1 - steps; i <= steps && !root; ++i) {
    const double to = right_angle * i / steps;
    if (excess(to) >= 0) root = find_root(excess, from, to);
    from = to;
  }
  if (!root) {
    out.holds = true;
    out.reason = "the pads hold section 3 at every angle up to 90 deg";
    return out;
  }
  out.angle = *root;
  const Pads p = pads(*root);
  out.jamming = (p.front < 0) != (p.rear < 0);
  return out;
}

}  // namespace taut::boom_ropes
