#pragma once
#include <algorithm>
#include <cmath>
#include <optional>

#include "taut/base/array.hpp"
#include "taut/solve/motion/parts/mechanism.hpp"

namespace taut::solve::dynamics {

/// A line as it is at one time.
struct LineValues {
  std::array<Vector3, 2> centre;      ///< of its rounds, ground frame, m
  std::array<Vector3, 2> touch;       ///< where the free rope begins and ends, m
  Vector3 t = Vector3::UnitX();       ///< direction
  double l = 1;                       ///< length, m
  std::array<double, 2> angle{0, 0};  ///< of the touching points against the bodies, path sense, from the start on, rad
  Vector3 axis = Vector3::UnitY();    ///< planar: the common axis
  Vector3 flat = Vector3::UnitX();    ///< planar: direction in the plane across it
  double flat_l = 1;                  ///< planar: length there, m
  std::array<double, 2> skew_angle{0, 0};  ///< skew: about the rounds' zeros, rad
  std::array<double, 2> radius{0, 0};      ///< of its rounds: a drum's layer counts, m
  Vector3 apart = Vector3::Zero();     ///< velocity of the rope's touching points, fixed to their bodies, apart, m/s
  std::array<double, 2> arc{0, 0};     ///< on the rounds at its ends, what stretches with it, m
  double L = 1;                        ///< unstretched, with what lies on those, m
  double hung = 0;                     ///< of a sagging line: of that between its rounds, m; of another one 0
  double e = 0, e_rate = 0;            ///< strain, 1/s
  double T = 0;                        ///< in the middle, N
  double T_e = 0, T_rate = 0;          ///< derivatives of T by strain and by its rate
  std::array<double, 2> end_T{0, 0};   ///< at its ends: with half its weight's component, N
  std::array<double, 2> thrust{0, 0};  ///< G: what the rope's momentum takes of it there, N
  /// What accelerates the rope at a rim along its path: end_T is less by it where the rope leaves the rim, more where
  /// it arrives, N. And the share that counts of the rope's inertia along itself there: 0 where it has none.
  std::array<double, 2> surge{0, 0}, surge_share{0, 0};
  double gone = 1;  ///< share that is left of a breaking rope
};

/// Rope on the rounds at its ends that stretches with a line, m; what of the line's length is none such.
inline double on_rounds(const LineValues& line) { return line.arc[0] + line.arc[1]; }
/// Its way from end to end, with that, m.
inline double path_of(const Line& line, const LineValues& now) { return length_of(line, now.l) + on_rounds(now); }
/// Tension of the branch at an end, with what hangs there, without what accelerates the rope at a rim, N.
inline double tension_of_branch(const LineValues& line, std::size_t end) {
  return line.end_T[end] + (end == 0 ? line.surge[0] : -line.surge[1]);
}
/// Unstretched rope between the rounds, m: the strain is the same all along. A dead end may lie on a round altogether,
/// and may be overdrawn while a step is looked for (left_in).
inline double free_rope(const LineValues& line) {
  if (line.hung > 0 && line.gone > 0) return line.hung;
  const double on = on_rounds(line);
  if (on == 0) return line.L;
  if (line.gone == 0) return std::min(std::max(line.L - on, 0.0), line.L);
  return line.L - on / (1 + std::max(0.0, line.e));
}
/// Unstretched rope on the round at an end, m: less than none where the rope passes the round without touching it
/// (wrap below 0). A dead end may be shorter than the arc between the places where a rope leaves and arrives.
inline double lies_on_round(const LineValues& line, std::size_t end) {
  if (line.gone > 0) return line.arc[end] / (1 + std::max(0.0, line.e));
  const double on = on_rounds(line);
  return on > 0 ? line.arc[end] / on * (line.L - free_rope(line)) : 0;
}
/// Whether the turning of a line takes rope from it, or gives it some, at an end: on a drum it leaves the line. On
/// other rounds it stays the line's own.
inline bool winds(const Line& line, const LineValues& now, std::size_t end) {
  return now.radius[end] > 0 && !line.at_load[end] && !line.arcs[end];
}

/// Unstretched length, of a dead end that is about to run off not less than a little, m.
inline double some_length(const LineValues& line) { return std::max(line.L, 1e-3 * line.l); }

constexpr double run_off_share = 1e-6;  ///< of its branch's length: with no more rope a dead end runs off its round
constexpr double run_off_rest = 1e-15;  ///< the same: what is written down of it then
/// Whether it has: nothing is wound on or off by its turning any more.
inline bool has_run_off(const LineValues& line) { return line.gone == 0 && line.L <= 1e3 * run_off_rest * line.l; }

/// Rope that contacts may still take out of a line while a step is looked for, m. A dead end may be overdrawn there,
/// with no tension: the step is shortened then until it ends where the rope has run off.
inline double left_in(const LineValues& line) {
  constexpr double overdraft = 0.1;  // of its branch's length
  return line.gone > 0 ? line.L : line.L + overdraft * line.l;
}

/// A direction in the frame of a body (the ground: -1), in the ground's.
inline Vector3 to_ground(const Array<Motion3>& bodies, int body, const Vector3& direction) {
  return body < 0 ? direction : Vector3(bodies[body].R * direction);
}

/// Geometry from the poses; `before`: the same line at the start of the step, for angles. False: there is no line.
bool place_line(const Line& line, const Array<Motion3>& bodies, const LineValues& before, LineValues& now);

/// Rope on its rounds as its ends have turned since `before`.
inline void lay_on_rounds(const Line& line, const LineValues& before, LineValues& now) {
  for (const std::size_t end : {0U, 1U}) {
    if (!line.arcs[end]) continue;
    now.arc[end] = before.arc[end] + (end == 0 ? 1 : -1) * now.radius[end] * (now.angle[end] - before.angle[end]);
  }
}

/// How a line follows one local freedom of a body at one of its ends.
struct LineColumn {
  double l = 0;
  std::array<double, 2> angle{0, 0};
  Vector3 t = Vector3::Zero();
  std::array<Vector3, 2> touch{Vector3::Zero(), Vector3::Zero()};  ///< seen from the origin of its own body
  Vector3 velocity = Vector3::Zero();                              ///< of the touching point, fixed to the body
};
/// For all freedoms: columns 0 .. freedoms[0] + freedoms[1] - 1.
void line_columns(const Line& line, const Array<Body>& shapes, const Array<Motion3>& bodies, const LineValues& now,
                  std::array<LineColumn, 14>& columns);

/// Their velocities alone.
void line_velocities(const Line& line, const Array<Body>& shapes, const Array<Motion3>& bodies, const LineValues& now,
                     std::array<LineColumn, 14>& columns);

/// 1 - cos of the angle at which a line leaves the plane of its round at each end where the round lays it on and off.
std::array<double, 2> askew_of(const Line& line, const Array<Motion3>& bodies, const LineValues& now);
/// What the turning of such a line adds to L e', m/s: the rope on a round grows by R phi', the free rope falls short by
/// cos d of that.
double askew_rate(const Line& line, const Array<Motion3>& bodies, const LineValues& now);

/// a b, summed in one order whatever the compiler makes of it: in the inner loops of chains and tackles.
inline double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// What a line pulls the body at its end with, N: its tension less the thrust of the rope that runs there. Where that
/// is more, the rope lifts off: it can't push.
inline double body_pull(const LineValues& now, std::size_t end) {
  return now.T > now.thrust[end] ? now.T - now.thrust[end] : 0;
}

constexpr double most_hung = 0.9;  ///< of its tension, that an end of a line bears of its weight

/// What of `hangs`, half a line's weight along it, its tension T carries at its ends, N: a line that goes slack has no
/// tension there; and as both ends stay tighter the tighter it is, a drum or a round that gives an end its tension
/// always gives the line one.
inline double hung_at_ends(double hangs, double T) {
  const double most = most_hung * std::max(0.0, T);  // dampers without bounds may push within an iteration
  return std::clamp(hangs, -most, most);
}

/// Of a line with weight: how what its ends bear of half of it, `hangs`, follows the tension; nothing: it follows
/// length and direction alone. The end that bears more than the tension has a kink where all of `hangs` hangs there:
/// beyond it the tangent leads to a tension below 0, and an iteration that passes slack rope on by it goes in circles.
/// `steady`: by the chord from no tension there, which leads to a positive one.
using HungByTension = std::array<std::optional<double>, 2>;
inline HungByTension hung_by_tension(double hangs, double T, bool steady) {
  const double most = std::copysign(most_hung, hangs);
  if (T <= 0 || std::abs(hangs) >= most_hung * T) return {most, most};
  HungByTension share;
  if (steady) share[hangs > 0 ? 1 : 0] = hangs / T;
  return share;
}
/// The slope of what an end bears, of the slopes of `hangs` and T.
inline double hung_slope(const std::optional<double>& by_tension, double hangs, double T) {
  return by_tension ? *by_tension * T : hangs;
}

/// T of the strain and its rate, and its derivatives: 0 for e <= 0, else EA max(0, min(e + beta e', 2 e)).
inline void pull(const Line& line, double damping, LineValues& now) {
  const double EA = line.stiffness * now.gone;
  now.T = now.T_e = now.T_rate = 0;
  if (now.e <= 0 || EA == 0) return;
  const double damped = now.e + damping * now.e_rate;
  if (damped <= 0) return;
  if (damped > 2 * now.e) {
    now.T = 2 * EA * now.e;
    now.T_e = 2 * EA;
    return;
  }
  now.T = EA * damped;
  now.T_e = EA;
  now.T_rate = EA * damping;
}
/// The same without its bounds: where it is asked for, dampers hold whatever they have to.
inline void pull_without_bounds(const Line& line, double damping, LineValues& now) {
  pull(line, 0, now);
  if (now.e <= 0) return;
  now.T_rate = now.T_e * damping;
  now.T += now.T_rate * now.e_rate;
}
inline void pull(const Line& line, LineValues& now) { pull(line, line.damping, now); }

}  // namespace taut::solve::dynamics
