#include <Eigen/Geometry>
#include <cmath>

#include "taut/solve/motion/parts/couple.hpp"
#include "taut/solve/motion/run/ledger.hpp"

/// What a step of implicit Euler takes by itself: its works are done by the forces at its end. Each part is found by
/// itself, so that the books of such a step can fail to close.
namespace taut::solve::dynamics {
namespace {

/// Power of inertia at the end over the step, less what kinetic energy and that of the dead forces have grown: of a
/// body that only shifts M (v - v_before)^2/2.
double taken_by_bodies(const Mechanism& m, const Values& before, const Values& now) {
  const double h = now.t - before.t;
  const Stored a = stored_in_bodies(m, before), b = stored_in_bodies(m, now);
  double power = 0;
  for (std::size_t i = 0; i < m.bodies.size(); ++i) {
    power += inertia_power(m, static_cast<int>(i), now, now.bodies[i].v, now.bodies[i].w);
  }
  for (std::size_t i = 0; i < m.spins.size(); ++i) {
    const Spin& spin = m.spins[i];
    double alpha = now.spins[i].alpha, omega = now.spins[i].omega;
    if (spin.body >= 0) {
      const Vector3 axis = now.bodies[spin.body].R * spin.axis;
      alpha += axis.dot(acceleration(m, spin.body, now).second);
      omega += axis.dot(now.bodies[spin.body].w);
    }
    power += spin.inertia * alpha * omega;
  }
  return h * power - (b.kinetic + b.potential - a.kinetic - a.potential);
}

/// What an end of a line lays on its round in the step, as seen by the free line's length, m.
double laid_on(const Line& line, const Values& before, const Values& now, std::size_t i, std::size_t end) {
  if (line.radius[end] == 0 || line.at_load[end]) return 0;
  const LineValues &a = before.lines[i], &b = now.lines[i];
  const double across = b.t.dot(to_ground(now.bodies, line.body[end], line.axis[end]));
  const double in_plane = std::sqrt(std::max(0.0, 1 - across * across));
  return (end == 0 ? 1 : -1) * in_plane * a.radius[end] * (b.angle[end] - a.angle[end]);
}

/// Of a straight line: its strain energy is convex in length and unstretched length, so the tension of the end takes
/// more than the energy grows by, also on the way from slack to taut; its direction turns over the step; its weight and
/// its height change together.
double taken_by_line(const Mechanism& m, std::size_t i, const Values& before, const Values& now) {
  const Line& line = m.lines[i];
  const LineValues &a = before.lines[i], &b = now.lines[i];
  const double e_a = path_of(line, a) / a.L - 1, e_b = path_of(line, b) / b.L - 1;
  const double taut_a = std::max(0.0, e_a), taut_b = std::max(0.0, e_b), elastic = elastic_tension(line, b);
  const double dl = length_of(line, b.l) - length_of(line, a.l), dL = b.L - a.L;
  const double grown = line.stiffness * b.gone / 2 * (taut_b * taut_b * b.L - taut_a * taut_a * a.L);
  const double damped = line.damping > 0 ? (b.T - elastic) * b.L * (taut_b - taut_a) : 0;  // has its own entry
  const double stretched = b.gone > 0 ? b.T * a.L * (e_b - e_a) + elastic * e_b / 2 * dL - grown - damped : 0;
  double apart = 0;
  for (const std::size_t end : {0U, 1U}) {
    if (line.body[end] < 0) continue;
    const Motion3& body = now.bodies[line.body[end]];
    apart += (end == 1 ? 1 : -1) * b.t.dot(body.v + body.w.cross(b.touch[end] - body.x));
  }
  const double way = line.share * (now.t - before.t) * apart;
  const double turned = b.T * (way - dl - laid_on(line, before, now, i, 0) - laid_on(line, before, now, i, 1));
  const auto height = [&](const LineValues& v) {
    return borne(line, v.l, 0) * v.touch[0].z() + borne(line, v.l, 1) * v.touch[1].z();
  };
  const double lifted = line.weight * (free_rope(b) - free_rope(a)) * (height(b) - height(a));
  return line.copies * (stretched + turned + lifted);
}

}  // namespace

double taken_by_euler(const Mechanism& m, const Values& before, const Values& now) {
  double taken = taken_by_bodies(m, before, now) + taken_by_couples(m, before, now);
  for (std::size_t i = 0; i < m.lines.size(); ++i) {
    if (!sags(m.lines[i], now.lines[i])) taken += taken_by_line(m, i, before, now);
  }
  return taken;
}

}  // namespace taut::solve::dynamics
