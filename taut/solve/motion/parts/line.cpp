#include "taut/solve/motion/parts/line.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "taut/base/array.hpp"
#include "taut/math/index.hpp"
#include "taut/rope/tangent.hpp"

namespace taut::solve::dynamics {
namespace {

Vector3 place_of(const Array<Motion3>& bodies, int body, const Vector3& place) {
  return body < 0 ? place : Vector3(bodies[body].x + bodies[body].R * place);
}

/// Sense of the round at an end about the line's common axis, times its radius.
double signed_radius(const Line& line, const LineValues& now, int end, const Array<Motion3>& bodies) {
  const std::size_t e = as_size(end);
  if (now.radius[e] == 0) return 0;
  const double same = to_ground(bodies, line.body[e], line.axis[e]).dot(now.axis);
  return (same < 0 ? -1 : 1) * line.side[e] * now.radius[e];
}

bool place_planar(const Line& line, const Array<Motion3>& bodies, const LineValues& before, LineValues& now) {
  const int main = now.radius[0] > 0 ? 0 : 1;
  now.axis = to_ground(bodies, line.body[as_size(main)], line.axis[as_size(main)]);
  const double S0 = signed_radius(line, now, 0, bodies), S1 = signed_radius(line, now, 1, bodies);
  const Vector3 d = now.centre[1] - now.centre[0];
  const double out = d.dot(now.axis), rho = S1 - S0;
  const Vector3 flat = d - out * now.axis;
  const double square = flat.squaredNorm(), free = square - rho * rho;
  if (!(free > 0)) return false;
  now.flat_l = std::sqrt(free);
  const Vector3 across = now.axis.cross(flat);
  now.flat = (now.flat_l * flat - rho * across) / square;
  now.l = std::sqrt(free + out * out);
  now.t = (now.flat_l * now.flat + out * now.axis) / now.l;
  const Vector3 n = now.axis.cross(now.flat);
  now.touch[0] = now.centre[0] - S0 * n;
  now.touch[1] = now.centre[1] - S1 * n;
  const double turn = std::atan2(before.flat.cross(now.flat).dot(now.axis), before.flat.dot(now.flat));
  for (const int end : {0, 1}) {
    if (now.radius[as_size(end)] == 0) continue;
    const double S = end == 0 ? S0 : S1;
    const int body = line.body[as_size(end)];
    const double carried = body < 0 ? 0 : bodies[body].turned.dot(now.axis);
    now.angle[as_size(end)] = before.angle[as_size(end)] + (S < 0 ? -1 : 1) * (turn - carried);
  }
  return true;
}

rope::Round round_of(const Line& line, const Array<Motion3>& bodies, const LineValues& now, std::size_t e) {
  if (now.radius[e] == 0) return rope::point(now.centre[e]);
  rope::Round round;
  round.centre = now.centre[e];
  round.axis = to_ground(bodies, line.body[e], line.axis[e]);
  round.zero = to_ground(bodies, line.body[e], line.zero[e]);
  round.radius = now.radius[e];
  round.side = line.side[e];
  return round;
}

rope::TangentLine tangent_of(const LineValues& now) {
  rope::TangentLine line;
  line.from = now.touch[0];
  line.to = now.touch[1];
  line.direction = now.t;
  line.length = now.l;
  line.angle_from = now.skew_angle[0];
  line.angle_to = now.skew_angle[1];
  return line;
}

bool place_skew(const Line& line, const Array<Motion3>& bodies, const LineValues& before, LineValues& now) {
  const auto found = rope::tangent_line(round_of(line, bodies, now, 0), round_of(line, bodies, now, 1),
                                        std::pair{before.skew_angle[0], before.skew_angle[1]});
  if (!found) return false;
  now.l = found->length;
  now.t = found->direction;
  now.touch = {found->from, found->to};
  now.skew_angle = {found->angle_from, found->angle_to};
  for (std::size_t e = 0; e < 2; ++e) {
    now.angle[e] =
        before.angle[e] + line.side[e] * std::remainder(now.skew_angle[e] - before.skew_angle[e], 2 * std::numbers::pi);
  }
  return true;
}

/// d(touch) is seen from the origin of the body that carries that end: what the origin itself does is left out.
void planar_column(const LineValues& now, std::array<double, 2> S, std::size_t end, const Vector3& velocity,
                   const Vector3& about, const Vector3& arm_velocity, LineColumn& c) {
  const Vector3 dd = end == 1 ? velocity : Vector3(-velocity);
  const Vector3 n = now.axis.cross(now.flat);
  const double turn = n.dot(dd) / now.flat_l, out = now.axis.dot(now.centre[1] - now.centre[0]);
  const double flat_l = now.flat.dot(dd) + (S[1] - S[0]) * turn, dout = now.axis.dot(dd);
  c.l = (now.flat_l * flat_l + out * dout) / now.l;
  c.t = (flat_l * now.flat + now.flat_l * turn * n + dout * now.axis - c.l * now.t) / now.l;
  for (std::size_t e = 0; e < 2; ++e) {
    c.touch[e] = S[e] * turn * now.flat;
    if (now.radius[e] > 0) {
      const double carried = e == end ? about.dot(now.axis) : 0;
      c.angle[e] = (S[e] < 0 ? -1 : 1) * (turn - carried);
    }
  }
  c.touch[end] += arm_velocity;
}

}  // namespace

bool place_line(const Line& line, const Array<Motion3>& bodies, const LineValues& before, LineValues& now) {
  now.radius = before.radius;
  for (std::size_t e = 0; e < 2; ++e) now.centre[e] = place_of(bodies, line.body[e], line.place[e]);
  if (line.kind == LineKind::planar) return place_planar(line, bodies, before, now);
  if (line.kind == LineKind::skew) return place_skew(line, bodies, before, now);
  const Vector3 d = now.centre[1] - now.centre[0];
  now.l = d.norm();
  if (!(now.l > 0)) return false;
  now.t = d / now.l;
  now.touch = now.centre;
  return true;
}

std::array<double, 2> askew_of(const Line& line, const Array<Motion3>& bodies, const LineValues& now) {
  constexpr double hardly = 1e-6;
  std::array<double, 2> askew{0, 0};
  for (std::size_t e = 0; e < 2 && line.kind != LineKind::points && !line.part; ++e) {
    if (now.radius[e] == 0 || line.contact[e] < 0) continue;
    const double s = now.t.dot(to_ground(bodies, line.body[e], line.axis[e]));
    if (std::abs(s) > hardly) askew[e] = s * s / (1 + std::sqrt(std::max(0.0, 1 - s * s)));
  }
  return askew;
}

double askew_rate(const Line& line, const Array<Motion3>& bodies, const LineValues& now) {
  const std::array<double, 2> askew = askew_of(line, bodies, now);
  if (askew[0] == 0 && askew[1] == 0) return 0;
  Eigen::Matrix<double, 12, 1> move = Eigen::Matrix<double, 12, 1>::Zero();
  for (const std::size_t e : {0U, 1U}) {
    if (line.body[e] < 0) continue;
    const Motion3& body = bodies[line.body[e]];
    const auto first = static_cast<Eigen::Index>(6 * e);
    move.segment<3>(first) = body.v + body.w.cross(now.centre[e] - body.x);
    move.segment<3>(first + 3) = body.w;
  }
  std::array<double, 2> turns{0, 0};
  if (line.kind == LineKind::skew) {
    const rope::LineRates rates =
        rope::line_rates(round_of(line, bodies, now, 0), round_of(line, bodies, now, 1), tangent_of(now));
    turns = {line.side[0] * rates.angle_from.dot(move), line.side[1] * rates.angle_to.dot(move)};
  } else {
    const Vector3 apart = move.segment<3>(6) - move.segment<3>(0);
    const double turn = now.axis.cross(now.flat).dot(apart) / now.flat_l;
    for (const int e : {0, 1}) {
      const double sign = signed_radius(line, now, e, bodies) < 0 ? -1 : 1;
      turns[as_size(e)] = sign * (turn - move.segment<3>(6 * e + 3).dot(now.axis));
    }
  }
  return askew[0] * now.radius[0] * turns[0] - askew[1] * now.radius[1] * turns[1];
}

void line_velocities(const Line& line, const Array<Body>& shapes, const Array<Motion3>& bodies, const LineValues& now,
                     std::array<LineColumn, 14>& columns) {
  std::size_t k = 0;
  for (std::size_t end = 0; end < 2; ++end) {
    if (line.body[end] < 0) continue;
    const Body& shape = shapes[line.body[end]];
    const Vector3 arm = now.touch[end] - bodies[line.body[end]].x;
    for (std::size_t f = 0; f < as_size(shape.count); ++f, ++k) {
      columns[k].velocity = shape.turns ? Vector3(shape.along[f] + shape.about[f].cross(arm)) : shape.along[f];
    }
  }
}

void line_columns(const Line& line, const Array<Body>& shapes, const Array<Motion3>& bodies, const LineValues& now,
                  std::array<LineColumn, 14>& columns) {
  std::array<double, 2> S{0, 0};
  rope::LineRates rates;
  if (line.kind == LineKind::planar) S = {signed_radius(line, now, 0, bodies), signed_radius(line, now, 1, bodies)};
  if (line.kind == LineKind::skew) {
    rates = rope::line_rates(round_of(line, bodies, now, 0), round_of(line, bodies, now, 1), tangent_of(now));
  }
  std::size_t k = 0;
  for (std::size_t end = 0; end < 2; ++end) {
    if (line.body[end] < 0) continue;
    const Body& shape = shapes[line.body[end]];
    const Vector3& origin = bodies[line.body[end]].x;
    for (std::size_t f = 0; f < as_size(shape.count); ++f, ++k) {
      LineColumn& c = columns[k];
      const Vector3 &along = shape.along[f], &about = shape.about[f];
      const Vector3 arm = about.cross(now.centre[end] - origin);
      const Vector3 velocity = along + arm;
      c.velocity = along + about.cross(now.touch[end] - origin);
      switch (line.kind) {
        case LineKind::points:
          c.l = (end == 1 ? 1 : -1) * now.t.dot(velocity);
          c.t = ((end == 1 ? velocity : Vector3(-velocity)) - c.l * now.t) / now.l;
          c.touch[end] = arm;
          c.touch[1 - end].setZero();
          break;
        case LineKind::planar:
          planar_column(now, S, end, velocity, about, arm, c);
          break;
        case LineKind::skew: {
          Eigen::Matrix<double, 12, 1> move = Eigen::Matrix<double, 12, 1>::Zero();
          move.segment<3>(end == 0 ? 0 : 6) = velocity;
          move.segment<3>(end == 0 ? 3 : 9) = about;
          c.l = rates.length.dot(move);
          c.angle = {line.side[0] * rates.angle_from.dot(move), line.side[1] * rates.angle_to.dot(move)};
          c.touch = {rates.from * move, rates.to * move};
          c.t = (c.touch[1] - c.touch[0] - c.l * now.t) / now.l;
          c.touch[end] -= along;
          break;
        }
      }
    }
  }
}

}  // namespace taut::solve::dynamics
