#include "taut/rope/contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "taut/base/expects.hpp"

namespace taut::rope {
namespace {

void check(const Contact& c) {
  expects(c.wrap >= 0 && c.friction >= 0 && c.momentum_flow >= 0, "wrap, friction and m v^2 are not negative");
  expects(c.efficiency > 0 && c.efficiency <= 1, "an efficiency lies above 0 and is not more than 1");
}

double capstan(const Contact& c) { return c.friction * c.wrap; }

/// ln of the largest ratio, and whether the groove or the bearing sets it.
struct GripLimit {
  double log = 0;
  bool by_groove = true;
};

GripLimit limit_of(const Contact& c) {
  const double groove = capstan(c);
  if (!c.turns) return {.log = groove, .by_groove = true};
  const double bearing = -std::log(c.efficiency);
  return groove < bearing ? GripLimit{.log = groove, .by_groove = true} : GripLimit{.log = bearing, .by_groove = false};
}

double log_ratio(const Contact& c, double T_in, double T_out) {
  const double in = T_in - c.momentum_flow, out = T_out - c.momentum_flow;
  expects(in >= 0 && out >= 0, "a rope on a sheave has at least the tension m v^2");
  if (in == out) return 0;
  if (in == 0) return std::numeric_limits<double>::infinity();
  return out == 0 ? -std::numeric_limits<double>::infinity() : std::log(out / in);
}

}  // namespace

double largest_ratio(const Contact& contact) {
  check(contact);
  const GripLimit limit = limit_of(contact);
  return limit.by_groove ? std::exp(limit.log) : 1 / contact.efficiency;
}

OutTension tension_out(const Contact& contact, double T_in, Flow flow) {
  expects(flow != Flow::at_rest, "at rest there is a band of tensions");
  expects(T_in >= contact.momentum_flow, "a rope on a sheave has at least the tension m v^2");
  const bool grows = flow == Flow::in_to_out;
  const double ratio = grows ? largest_ratio(contact) : 1 / largest_ratio(contact);
  const double pressing = (T_in - contact.momentum_flow) * ratio;
  const double along_arc = limit_of(contact).by_groove ? contact.friction * pressing : 0;
  return {.T = contact.momentum_flow + pressing, .dT_dT_in = ratio, .dT_dwrap = grows ? along_arc : -along_arc};
}

Band band_at_rest(const Contact& contact, double T_in) {
  expects(T_in >= 0, "a rope pulls");
  const double ratio = largest_ratio(contact);
  return {.low = T_in / ratio, .high = T_in * ratio};
}

ContactState state_of(const Contact& contact, double T_in, double T_out, double tolerance) {
  if (flow_of(contact, T_in, T_out, tolerance) == Flow::at_rest) return ContactState::stuck;
  return limit_of(contact).by_groove ? ContactState::slipping : ContactState::turning;
}

Flow flow_of(const Contact& contact, double T_in, double T_out, double tolerance) {
  check(contact);
  const double used = log_ratio(contact, T_in, T_out);
  const double most = limit_of(contact).log - tolerance;
  // without any loss every ratio is at both bounds: equal tensions rest
  if (used > 0 && used >= most) return Flow::in_to_out;
  if (used < 0 && -used >= most) return Flow::out_to_in;
  return Flow::at_rest;
}

double grip_used(const Contact& contact, double T_in, double T_out) {
  check(contact);
  const double used = std::abs(log_ratio(contact, T_in, T_out));
  return used == 0 ? 0 : used / capstan(contact);
}

Vector3 resultant(const Contact& contact, double T_in, const Vector3& arrives, double T_out, const Vector3& leaves) {
  const double c = contact.momentum_flow;
  return (T_out - c) * leaves - (T_in - c) * arrives;
}

double line_pressure(const Contact& contact, double tension, double radius) {
  expects(radius > 0, "a sheave has a radius");
  return std::max(0.0, tension - contact.momentum_flow) / radius;
}

double v_groove_friction(double friction, double half_angle) {
  expects(friction >= 0 && half_angle > 0 && half_angle <= std::numbers::pi / 2,
          "half a groove's angle is at most 90 degrees");
  return friction / std::sin(half_angle);
}

double undercut_groove_friction(double friction, double undercut_angle, double groove_angle) {
  const double b = undercut_angle, g = groove_angle;
  expects(friction >= 0 && b >= 0 && g >= 0 && b + g < std::numbers::pi, "an undercut groove leaves flanks to lie on");
  return 4 * friction * (std::cos(g / 2) - std::sin(b / 2)) / (std::numbers::pi - b - g - std::sin(b) + std::sin(g));
}

std::optional<BeltCreep> belt_creep(const Contact& contact, double T_1, double T_2, double stiffness) {
  check(contact);
  expects(T_1 >= T_2 && stiffness > 0, "the tight side has the larger tension");
  const double c = contact.momentum_flow;
  if (!(T_2 > c)) return std::nullopt;
  const double needed = std::log((T_1 - c) / (T_2 - c));
  BeltCreep b;
  b.slip_arc = needed == 0 ? 0 : needed / contact.friction;
  b.rest_arc = contact.wrap - b.slip_arc;
  b.creep = (T_1 - T_2) / stiffness;
  b.holds = b.rest_arc >= 0;
  return b;
}

}  // namespace taut::rope
