#include "taut/solve/motion/parts/sag.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "taut/base/array.hpp"
#include "taut/math/index.hpp"
#include "taut/mechanics/branch_force.hpp"
#include "taut/rope/catenary_shape.hpp"
#include "taut/rope/span.hpp"

namespace taut::solve::dynamics {
namespace {

constexpr int most_hanging_steps = 30;
constexpr double hanging_closes = 1e-14;  ///< of the size: tangent points and free length
constexpr double hanging_open = 1e-10;    ///< with more it is no solution

using Ends = std::array<mechanics::BranchEnd, 2>;

Matrix3 sag_turned(const Array<Motion3>& bodies, int body) {
  return body < 0 ? Matrix3(Matrix3::Identity()) : bodies[body].R;
}

Ends sag_ends(const Line& line, const Array<Motion3>& bodies, const LineValues& now) {
  Ends ends;
  for (const std::size_t e : {0U, 1U}) {
    ends[e].centre = now.centre[e];
    ends[e].axis = to_ground(bodies, line.body[e], line.axis[e]);
    ends[e].radius = line.side[e] * now.radius[e];
  }
  return ends;
}

rope::CatenaryRope sag_rope(const Line& line, double length) { return {length, line.weight, line.stiffness}; }

rope::Span sag_span(const Line& line, const LineValues& now, const SagValues& is) {
  rope::Span span;
  span.rope = sag_rope(line, now.hung);
  span.chord = now.l * now.t;
  span.along = is.along;
  span.force = {is.H, is.V};
  return span;
}

/// Derivatives of a hanging rope by chord and length, tangent points apart.
struct HangingRates {
  Matrix3 K;  ///< of both tensions by the chord
  std::array<Vector3, 2> by_L;
  std::array<Matrix3, 2> turn;  ///< of the directions by the tensions
};

HangingRates hanging_rates(const rope::Span& span, const std::array<Vector3, 2>& pull,
                           const std::array<Vector3, 2>& direction) {
  HangingRates r;
  r.K = rope::stiffness(span);
  const rope::EndForceRates by_L = rope::length_rates(span);
  r.by_L = {by_L.start, -by_L.end};
  for (const std::size_t e : {0U, 1U}) {
    const double T = pull[e].norm();
    r.turn[e] = T > 0 ? Matrix3(across(direction[e]) / T) : Matrix3(Matrix3::Zero());
  }
  return r;
}

/// Rope on the rounds at the ends: what stretches there with the line has the tension of its end.
struct OnRounds {
  std::array<double, 2> stretch;  ///< 1 + strain
  std::array<double, 2> by_T;     ///< derivative of the unstretched rope by the tension of the end, m/N
};

OnRounds on_rounds_of(const Line& line, const std::array<double, 2>& winding, const std::array<double, 2>& arc,
                      const SagValues& is) {
  OnRounds on{.stretch = winding, .by_T = {0, 0}};
  for (const std::size_t e : {0U, 1U}) {
    if (!line.arcs[e]) continue;
    on.stretch[e] = 1 + is.pull[e].norm() / line.stiffness;
    on.by_T[e] = -arc[e] / (on.stretch[e] * on.stretch[e] * line.stiffness);
  }
  return on;
}

/// How chord and length follow the vector between the centres and the rope let in: the inverse of this.
Eigen::Matrix4d tangent_matrix(const Ends& ends, const OnRounds& on, const HangingRates& r,
                               const std::array<Vector3, 2>& direction) {
  const Matrix3 N0 = mechanics::tangent_offset_rate(ends[0], direction[0]) * r.turn[0];
  const Matrix3 N1 = mechanics::tangent_offset_rate(ends[1], direction[1]) * r.turn[1];
  const auto lies = [&](std::size_t e) -> Vector3 {
    return r.turn[e].transpose() * mechanics::arc_rate(ends[e], direction[e], e == 0) / on.stretch[e] +
           on.by_T[e] * direction[e];
  };
  const Vector3 arc0 = lies(0), arc1 = lies(1);
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.topLeftCorner<3, 3>() += (N0 - N1) * r.K;
  m.topRightCorner<3, 1>() = N0 * r.by_L[0] - N1 * r.by_L[1];
  m.bottomLeftCorner<1, 3>() = (arc0 + arc1).transpose() * r.K;
  m(3, 3) += arc0.dot(r.by_L[0]) + arc1.dot(r.by_L[1]);
  return m;
}

void take_span(const rope::Span& span, SagValues& is) {
  is.along = span.along;
  is.H = span.force.H;
  is.V = span.force.V;
  is.pull = {rope::force_on_start(span), -rope::force_on_end(span)};
  // no tension at an end: the rope hangs straight down there
  for (const std::size_t e : {0U, 1U}) {
    const double T = is.pull[e].norm();
    is.direction[e] = T > 0 ? Vector3(is.pull[e] / T) : e == 0 ? Vector3(-up()) : Vector3(up());
  }
}

/// What lies on the rounds since the rope had the directions `then`, stretched, m.
std::array<double, 2> arcs_of(const Ends& ends, const std::array<Vector3, 2>& then,
                              const std::array<Vector3, 2>& direction) {
  const mechanics::BranchEnd point;
  const mechanics::BranchDirections before{then[0], then[1]}, now{direction[0], direction[1]};
  return {mechanics::arcs_between(ends[0], point, before, now), mechanics::arcs_between(point, ends[1], before, now)};
}

/// Mean strain, least tension, the stretch's share in the compliance along the chord.
void measure_sag(const Line& line, LineValues& now, SagValues& is) {
  const double half = line.weight * now.hung / 2, T0 = is.pull[0].norm(), T1 = is.pull[1].norm();
  const double stretch = now.hung / line.stiffness;
  const double x = is.along.dot(now.l * now.t), z = now.l * now.t.z();
  const double sum = (is.H * (x - is.H * stretch) + is.V * (z - is.V * stretch)) / 2 + now.hung * (T0 + T1) / 4;
  now.e = std::max(sum / (line.stiffness * now.hung), std::numeric_limits<double>::min());
  is.lowest = std::abs(is.V) < half ? is.H : std::min(T0, T1);
  const rope::EndPosition by = rope::end_position(sag_rope(line, now.hung), {is.H, is.V});
  const double tx = is.along.dot(now.t), tz = now.t.z();
  const double yields = tx * tx * by.dx_dH + 2 * tx * tz * by.dx_dV + tz * tz * by.dz_dV;
  is.stretches = std::isfinite(yields) ? std::min(1.0, stretch / yields) : 0;
}

}  // namespace

namespace {

/// What a hanging rope has to close: the vector between the centres, the rope let in, and the directions as of which
/// it was free.
struct ToHang {
  const Line& line;
  const Ends& ends;
  const std::array<double, 2>& winding;
  std::array<Vector3, 2> then;
  std::array<double, 2> arc;  ///< on the rounds then, what stretches with the line, m
  Vector3 apart;
  double fed = 0;   ///< with that, m
  double free = 0;  ///< without, m: a first guess
  double size = 0;
};

/// Newton from a chord, a length and a force near by.
bool close_hanging(const ToHang& of, std::optional<rope::CatenaryForce> force, Vector3& chord, double& length,
                   std::array<double, 2>& arcs, SagValues& is) {
  const bool round = of.ends[0].radius != 0 || of.ends[1].radius != 0;
  double open_before = std::numeric_limits<double>::infinity();
  for (int step = 0; step < most_hanging_steps; ++step) {
    if (!chord.allFinite() || !(length > 0) || !std::isfinite(length)) return false;
    const auto span = rope::solve_span(sag_rope(of.line, length), chord, force);
    if (!span) return false;
    take_span(*span, is);
    if (!round) return true;
    force = span->force;
    arcs = arcs_of(of.ends, of.then, is.direction);
    const std::array<double, 2> lies{of.arc[0] + arcs[0], of.arc[1] + arcs[1]};
    const OnRounds on = on_rounds_of(of.line, of.winding, lies, is);
    Eigen::Vector4d open;
    open << of.apart + mechanics::tangent_offset(of.ends[1], is.direction[1]) -
                mechanics::tangent_offset(of.ends[0], is.direction[0]) - chord,
        of.fed - lies[0] / on.stretch[0] - lies[1] / on.stretch[1] - length;
    const double gap = open.norm();
    if (!std::isfinite(gap)) return false;
    if (gap <= hanging_closes * of.size || (gap <= hanging_open * of.size && gap >= open_before)) return true;
    open_before = gap;
    const HangingRates r = hanging_rates(*span, is.pull, is.direction);
    const Eigen::Vector4d by = tangent_matrix(of.ends, on, r, is.direction).inverse() * open;
    chord += by.head<3>();
    length += by[3];
  }
  return false;
}

/// From afar: the force as statics finds it.
bool close_from_afar(const ToHang& of, Vector3& chord, double& length, std::array<double, 2>& arcs, SagValues& is) {
  const auto found =
      mechanics::branch_force(sag_rope(of.line, of.free), of.ends[0], of.ends[1], {of.then[0], of.then[1]});
  if (!found) return false;
  const Vector3 half = of.line.weight * found->length / 2 * up();
  const Vector3 leaves = (found->force - half).normalized(), arrives = (found->force + half).normalized();
  chord = of.apart + mechanics::tangent_offset(of.ends[1], arrives) - mechanics::tangent_offset(of.ends[0], leaves);
  length = found->length;
  const rope::CatenaryForce near{std::hypot(found->force.x(), found->force.y()), found->force.z()};
  return close_hanging(of, near, chord, length, arcs, is);
}

}  // namespace

bool hang(const Line& line, const Array<Motion3>& bodies, const std::array<double, 2>& winding, const SagValues& before,
          double fed, const std::array<double, 2>& angle, LineValues& now, SagValues& is) {
  const Ends ends = sag_ends(line, bodies, now);
  const Vector3 X = now.centre[1] - now.centre[0];
  const OnRounds lay = on_rounds_of(line, winding, now.arc, before);
  const double free = fed - now.arc[0] / lay.stretch[0] - now.arc[1] / lay.stretch[1];
  if (!(free > 0) || !std::isfinite(free) || !X.allFinite()) return false;
  const ToHang of{
      .line = line,
      .ends = ends,
      .winding = winding,
      .then = {to_ground(bodies, line.body[0], before.seat[0]), to_ground(bodies, line.body[1], before.seat[1])},
      .arc = now.arc,
      .apart = X,
      .fed = fed,
      .free = free,
      .size = X.norm() + std::abs(ends[0].radius) + std::abs(ends[1].radius)};
  Vector3 chord = X + mechanics::tangent_offset(ends[1], of.then[1]) - mechanics::tangent_offset(ends[0], of.then[0]);
  double length = free;
  std::array<double, 2> arcs{0, 0};
  std::optional<rope::CatenaryForce> force;
  if (before.H > 0) force = rope::CatenaryForce{before.H, before.V};
  if (!close_hanging(of, force, chord, length, arcs, is) && !close_from_afar(of, chord, length, arcs, is)) return false;
  now.L = now.hung = length;
  const OnRounds on = on_rounds_of(line, winding, now.arc, is);
  for (const std::size_t e : {0U, 1U}) {
    if (line.arcs[e]) {
      now.arc[e] += arcs[e];
      now.L += now.arc[e] / on.stretch[e];
    }
    now.touch[e] = now.centre[e] + mechanics::tangent_offset(ends[e], is.direction[e]);
    is.seat[e] = sag_turned(bodies, line.body[e]).transpose() * is.direction[e];
    now.angle[e] = angle[e];
    if (now.radius[e] > 0) now.angle[e] += (e == 0 ? arcs[0] : -arcs[1]) / now.radius[e];
  }
  now.l = chord.norm();
  now.t = now.l > 0 ? Vector3(chord / now.l) : is.along;
  measure_sag(line, now, is);
  return true;
}

namespace {

/// All that the derivatives of a sagging line follow from.
struct SagRates {
  Ends ends;
  HangingRates hanging;
  Eigen::Matrix4d follow;
  std::array<Matrix3, 2> offset;  ///< of the tangent points by the directions
  std::array<Vector3, 2> arc;     ///< of the arcs
  OnRounds on;
  double x_g = 0, z_g = 0;  ///< chord without the stretch that a middle force would give, m
};

SagRates sag_rates(const Line& line, const Array<Motion3>& bodies, const std::array<double, 2>& winding,
                   const LineValues& now, const SagValues& is) {
  SagRates r;
  r.ends = sag_ends(line, bodies, now);
  r.hanging = hanging_rates(sag_span(line, now, is), is.pull, is.direction);
  r.on = on_rounds_of(line, winding, now.arc, is);
  r.follow = tangent_matrix(r.ends, r.on, r.hanging, is.direction).inverse();
  const double stretch = now.hung / line.stiffness;
  r.x_g = is.along.dot(now.l * now.t) - is.H * stretch;
  r.z_g = now.l * now.t.z() - is.V * stretch;
  for (const std::size_t e : {0U, 1U}) {
    r.offset[e] = mechanics::tangent_offset_rate(r.ends[e], is.direction[e]);
    r.arc[e] = mechanics::arc_rate(r.ends[e], is.direction[e], e == 0);
  }
  return r;
}

/// Derivative of SagValues::stretches, where the force in the middle follows with H and V.
double stretch_slope(const Line& line, const LineValues& now, const SagValues& is, double H, double V,
                     const SagColumn& c) {
  if (!(is.stretches > 0) || !(is.H > 0) || !(now.l > 0)) return 0;
  const double w = line.weight, EA = line.stiffness, half = w * now.hung / 2;
  const std::array<double, 2> v{is.V - half, is.V + half}, T{is.pull[0].norm(), is.pull[1].norm()};
  const std::array<double, 2> cube{T[0] * T[0] * T[0], T[1] * T[1] * T[1]};
  // integrals over the rope of derivatives of HH/TTT, -HV/TTT and VV/TTT are differences of these at its ends
  const auto between = [&](auto at_end) { return (at_end(1U) - at_end(0U)) / w; };
  const auto mean = [&](auto at_end) { return (at_end(0U) + at_end(1U)) / 2; };
  const double hh = between([&](std::size_t e) { return is.H * is.H / cube[e]; });
  const double hv = -between([&](std::size_t e) { return is.H * v[e] / cube[e]; });
  const double vv = between([&](std::size_t e) { return v[e] * v[e] / cube[e]; });
  const double S = between([&](std::size_t e) { return v[e] / T[e]; });
  const rope::EndPosition by = rope::end_position(sag_rope(line, now.hung), {is.H, is.V});
  const double xx =
      (-S / is.H - hv) * H + vv * V + (1 / EA + mean([&](std::size_t e) { return v[e] * v[e] / cube[e]; })) * c.hung;
  const double xz = vv * H + hv * V - mean([&](std::size_t e) { return is.H * v[e] / cube[e]; }) * c.hung;
  const double zz = hv * H + hh * V + (1 / EA + mean([&](std::size_t e) { return is.H * is.H / cube[e]; })) * c.hung;
  const double tx = is.along.dot(now.t), tz = now.t.z();
  const Vector3 turns = (c.chord - now.t.dot(c.chord) * now.t) / now.l;
  const double dx = is.along.dot(turns), dz = turns.z();
  const double yields = tx * tx * by.dx_dH + 2 * tx * tz * by.dx_dV + tz * tz * by.dz_dV;
  const double change = tx * tx * xx + 2 * tx * tz * xz + tz * tz * zz + 2 * (tx * by.dx_dH + tz * by.dx_dV) * dx +
                        2 * (tx * by.dx_dV + tz * by.dz_dV) * dz;
  return is.stretches * (c.hung / now.hung - change / yields);
}

/// `apart`: of the tangent points by all but the rope's direction; `let_in`: rope; `seen`: of the directions as seen
/// from the rounds, by their own turning.
void fill_column(const Line& line, const SagRates& r, const LineValues& now, const SagValues& is, const Vector3& apart,
                 double let_in, const std::array<Vector3, 2>& seen, SagColumn& c) {
  Eigen::Vector4d given;
  given << apart, let_in;
  const Eigen::Vector4d by = r.follow * given;
  c.chord = by.head<3>();
  c.L = c.hung = by[3];
  for (const std::size_t e : {0U, 1U}) {
    c.pull[e] = r.hanging.K * c.chord + r.hanging.by_L[e] * c.hung;
    c.T[e] = is.direction[e].dot(c.pull[e]);
    const Vector3 turns = r.hanging.turn[e] * c.pull[e] + seen[e];
    c.touch[e] += r.offset[e] * turns;
    if (now.radius[e] > 0) c.angle[e] = (e == 0 ? 1 : -1) * r.arc[e].dot(turns) / now.radius[e];
    if (line.arcs[e]) c.L += r.arc[e].dot(turns) / r.on.stretch[e] + r.on.by_T[e] * c.T[e];
  }
  const double T0 = is.pull[0].norm(), T1 = is.pull[1].norm();
  const Vector3 middle = (c.pull[0] + c.pull[1]) / 2;
  const double H = is.along.dot(middle);
  const double sum = r.x_g * H + r.z_g * middle.z() + (T0 + T1) / 2 * c.hung;
  c.e = sum / (line.stiffness * now.hung) - now.e * c.hung / now.hung;
  c.lowest = std::abs(is.V) < line.weight * now.hung / 2 ? H : T0 < T1 ? c.T[0] : c.T[1];
  c.stretches = stretch_slope(line, now, is, H, middle.z(), c);
}

}  // namespace

SagColumn sag_let_in(const Line& line, const Array<Motion3>& bodies, const std::array<double, 2>& winding,
                     const LineValues& now, const SagValues& is) {
  SagColumn c;
  const std::array<Vector3, 2> seen{Vector3::Zero(), Vector3::Zero()};
  fill_column(line, sag_rates(line, bodies, winding, now, is), now, is, Vector3::Zero(), 1, seen, c);
  return c;
}

void sag_columns(const Line& line, const Array<Body>& shapes, const Array<Motion3>& bodies,
                 const std::array<double, 2>& winding, const LineValues& now, const SagValues& is,
                 SagColumns& columns) {
  const SagRates r = sag_rates(line, bodies, winding, now, is);
  std::size_t k = 0;
  for (const std::size_t e : {0U, 1U}) {
    if (line.body[e] < 0) continue;
    const Body& shape = shapes[line.body[e]];
    const Vector3& origin = bodies[line.body[e]].x;
    for (std::size_t f = 0; f < as_size(shape.count); ++f, ++k) {
      SagColumn& c = columns[k];
      c = {};
      const Vector3 &along = shape.along[f], &about = shape.about[f];
      c.velocity = along + about.cross(now.touch[e] - origin);
      // the tangent point turns with the body; what the turning does to the direction seen from it comes on top
      std::array<Vector3, 2> seen{Vector3::Zero(), Vector3::Zero()};
      seen[e] = -about.cross(is.direction[e]);
      c.touch[e] = about.cross(now.touch[e] - origin);
      const Vector3 moved = along + c.touch[e] + r.offset[e] * seen[e];
      fill_column(line, r, now, is, e == 0 ? Vector3(-moved) : moved, -r.arc[e].dot(seen[e]) / r.on.stretch[e], seen,
                  c);
    }
  }
  for (const std::size_t e : {0U, 1U}) {
    if (line.flow[e] < 0) continue;
    SagColumn& c = columns[as_size(line.flow[e])];
    c = {};
    fill_column(line, r, now, is, Vector3::Zero(), e == 0 ? 1 : -1, {Vector3::Zero(), Vector3::Zero()}, c);
  }
}

SagEnergy sag_energy(const Line& line, const LineValues& now, const SagValues& is) {
  const double w = line.weight, L = now.hung, EA = line.stiffness, stretch = L / EA;
  const double own = w * w * L * L * L / 12;  // of the integral of T^2
  const double x = is.along.dot(now.l * now.t), z = now.l * now.t.z();
  SagEnergy energy;
  energy.elastic = ((is.H * is.H + is.V * is.V) * L + own) / (2 * EA);
  for (const std::size_t e : {0U, 1U}) {
    const double T = is.pull[e].norm();
    energy.elastic += T * T / (2 * EA) * now.arc[e] / (1 + T / EA);
  }
  energy.below = (is.H * (x - is.H * stretch) + is.V * (z - is.V * stretch)) / 2 -
                 L * (is.pull[0].norm() + is.pull[1].norm()) / 4 - own / EA;
  return energy;
}

Array<Vector3> sag_curve(const Line& line, const LineValues& now, const SagValues& is, int parts) {
  Array<Vector3> points;
  const rope::Span span = sag_span(line, now, is);
  for (int i = 1; i < parts; ++i) points.emplace_back(now.touch[0] + rope::point_at(span, now.hung * i / parts));
  return points;
}

double sag_stretched(const Line& line, const LineValues& now, const SagValues& is) {
  return rope::stretched_length(sag_span(line, now, is));
}

void hang_on_new_radius(const Line& line, const Array<Motion3>& bodies, std::size_t end, double radius, LineValues& of,
                        SagValues& is) {
  LineValues was = of, straight = of;
  if (!place_line(line, bodies, was, straight)) return;
  was.radius[end] = radius;
  LineValues now = of;
  if (!place_line(line, bodies, was, now)) return;
  const double infinite = std::numeric_limits<double>::infinity();
  SagValues shape = is;
  if (!hang(line, bodies, {infinite, infinite}, is, of.L + (now.l - straight.l) / (1 + of.e), of.angle, now, shape))
    return;
  for (const std::size_t e : {0U, 1U}) {
    if (!line.arcs[e]) now.angle[e] = of.angle[e];
  }
  of = now;
  is = shape;
}

}  // namespace taut::solve::dynamics
