#include "test/witness/guyed_mast.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "taut/base/array.hpp"
#include "taut/base/expects.hpp"
#include "taut/math/roots.hpp"

namespace taut_test::witness {
namespace {

using Unknowns = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr int steps_per_piece = 24, steps = 96;

rope::CatenaryRope guy_rope(const Guy& guy, double length) {
  return {.length = length, .weight = guy.weight, .stiffness = guy.stiffness};
}

double tension(const Guy& guy, double length, GuyEnd end) {
  const auto span = rope::solve_span(guy_rope(guy, length), Vector3(0, 0, guy.height) - guy.anchor);
  if (!span) return std::numeric_limits<double>::infinity();
  return end == GuyEnd::top ? rope::tension_at_end(*span) : rope::tension_at_start(*span);
}

/// The mast with the unstretched lengths of its guys, and the heights between which nothing acts.
struct GuyedMastProblem {
  const GuyedMast& mast;
  Array<rope::CatenaryRope> ropes;
  Array<double> heights;  ///< ascending, the foot first, the top last
  double force = 1;       ///< scale, N
  double share = 1;       ///< of the loads
};

/// The mast as it stands for given unknowns.
struct Shape {
  Unknowns residual;  ///< force and moment left at the top, over their scales
  Array<MastPoint> points;
  Array<rope::Span> spans;
  bool valid = false;
};

/// Unknowns: base force and moment over their scales; on a hinge the inclination takes the place of two moments.
BeamState foot(const GuyedMastProblem& p, const Unknowns& u) {
  BeamState s;
  s.force = p.force * u.head<3>();
  const double moment = p.force * p.mast.height;
  if (p.mast.base == MastBase::clamped) {
    s.moment = moment * u.tail<3>();
    return s;
  }
  const Vector3 turn(u[3], u[4], 0);
  if (turn.norm() > 0) s.axes = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
  s.moment = Vector3(0, 0, moment * u[5]);
  return s;
}

/// Takes the forces at this height off the internal force; false where a guy finds no shape.
bool pass_forces(const GuyedMastProblem& p, double height, BeamState& s, Shape& shape) {
  for (const MastLoad& load : p.mast.loads) {
    if (load.height == height) s.force -= p.share * load.force;
  }
  for (std::size_t i = 0; i < p.ropes.size(); ++i) {
    if (p.mast.guys[i].height != height) continue;
    auto span = rope::solve_span(p.ropes[i], s.place - p.mast.guys[i].anchor);
    if (!span) return false;
    s.force -= rope::force_on_end(*span);
    shape.spans[i] = *span;
  }
  return true;
}

MastPoint point_of(const GuyedMastProblem& p, double height, const BeamState& s) {
  const auto f = section_forces(s);
  return {.height = height, .state = s, .stress = structure::largest_stress(p.mast.section, f)};
}

Shape shoot(const GuyedMastProblem& p, const Unknowns& u, bool keep_points) {
  Shape shape;
  shape.spans.resize(p.ropes.size());
  BeamState s = foot(p, u);
  if (keep_points) shape.points.push_back(point_of(p, 0, s));
  for (std::size_t k = 1; k < p.heights.size(); ++k) {
    const double length = p.heights[k] - p.heights[k - 1];
    Array<BeamState> way;
    s = carry(p.mast.section, s, length, steps, keep_points ? &way : nullptr);
    for (std::size_t i = 0; i < way.size(); ++i) {
      const double z = p.heights[k - 1] + length * static_cast<double>(i + 1) / static_cast<double>(way.size());
      shape.points.push_back(point_of(p, i + 1 == way.size() ? p.heights[k] : z, way[i]));
    }
    if (!s.place.allFinite() || !pass_forces(p, p.heights[k], s, shape)) return shape;
    if (keep_points && k + 1 < p.heights.size()) shape.points.push_back(point_of(p, p.heights[k], s));
  }
  shape.residual << s.force / p.force, s.moment / (p.force * p.mast.height);
  shape.valid = shape.residual.allFinite();
  return shape;
}

std::optional<Matrix6> jacobian(const GuyedMastProblem& p, const Unknowns& u) {
  Matrix6 J;
  for (int i = 0; i < 6; ++i) {
    const bool angle = p.mast.base == MastBase::hinged && (i == 3 || i == 4);
    const double step = (angle ? 1e-6 : 1e-5) * std::max(1.0, angle ? 0.0 : std::abs(u[i]));
    Unknowns plus = u, minus = u;
    plus[i] += step, minus[i] -= step;
    const Shape a = shoot(p, plus, false), b = shoot(p, minus, false);
    if (!a.valid || !b.valid) return std::nullopt;
    J.col(i) = (a.residual - b.residual) / (2 * step);
  }
  return J;
}

/// Newton with halved steps; true when the forces at the top vanish to rounding.
bool find_equilibrium(const GuyedMastProblem& p, Unknowns& u, int& iterations) {
  constexpr double tolerance = 1e-10;
  Unknowns x = u;
  Shape shape = shoot(p, x, false);
  for (int i = 0; i < 40 && shape.valid; ++i, ++iterations) {
    const double norm = shape.residual.norm();
    const auto J = jacobian(p, x);
    if (!J) return false;
    const Unknowns d = J->fullPivLu().solve(shape.residual);
    if (!d.allFinite()) return false;
    double t = 1;
    Shape next = shoot(p, x - d, false);
    while ((!next.valid || !(next.residual.norm() < (1 - 0.1 * t) * norm)) && norm > tolerance && t > 1e-4) {
      t /= 2;
      next = shoot(p, x - t * d, false);
    }
    if (norm <= tolerance) {  // one step more costs little and takes what rounding leaves
      u = next.valid && next.residual.norm() < norm ? Unknowns(x - t * d) : x;
      return true;
    }
    if (!next.valid || next.residual.norm() >= norm) return false;
    x -= t * d;
    shape = std::move(next);
  }
  return false;
}

double slope(const MastPoint& point) { return std::acos(std::clamp(point.state.axes(2, 2), -1.0, 1.0)); }

double largest_slope(const Array<MastPoint>& points) {
  double largest = 0;
  for (const MastPoint& point : points) largest = std::max(largest, slope(point));
  return largest;
}

/// Carries a state from one height to another, past the forces between them. Not a number where a guy finds no shape.
BeamState climb(const GuyedMastProblem& p, BeamState s, double low, double high, Shape& shape) {
  double z = low;
  for (const double height : p.heights) {
    if (height <= low || height >= high) continue;
    s = carry(p.mast.section, s, height - z, steps_per_piece);
    z = height;
    if (!pass_forces(p, height, s, shape)) s.place.setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  return carry(p.mast.section, s, high - z, steps_per_piece);
}

/// Heights that cut the mast into pieces of a tenth at most and a fiftieth at least: foot, top, guys where there is
/// room.
Array<double> nodes_of(const GuyedMast& mast) {
  Array<double> held = {0, mast.height};
  for (const Guy& guy : mast.guys) {
    const bool room =
        std::none_of(held.begin(), held.end(), [&](double z) { return std::abs(z - guy.height) < 0.02 * mast.height; });
    if (room) held.push_back(guy.height);
  }
  std::sort(held.begin(), held.end());
  Array<double> nodes = {0};
  for (std::size_t i = 1; i < held.size(); ++i) {
    const double length = held[i] - held[i - 1];
    const int parts = static_cast<int>(std::ceil(10 * length / mast.height - 1e-9));
    for (int k = 1; k < parts; ++k) nodes.push_back(held[i - 1] + length * k / parts);
    nodes.push_back(held[i]);
  }
  return nodes;
}

/// Stable: the tangent stiffness of mast and guys resists every movement. The pieces are short enough that none of them
/// can buckle between its held ends before the whole does; guys between two nodes belong to their piece.
bool stable(const GuyedMastProblem& p, const Unknowns& u) {
  const Array<double> nodes = nodes_of(p.mast);
  const auto count = static_cast<Eigen::Index>(nodes.size() - 1);
  const double height = p.mast.height, EI = std::max(p.mast.section.EI_x, p.mast.section.EI_y);
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(6 * (count + 1), 6 * (count + 1));
  Shape shape;
  shape.spans.resize(p.ropes.size());
  BeamState s = foot(p, u);
  for (Eigen::Index n = 0; n < count; ++n) {
    const double low = nodes[n], high = nodes[n + 1];
    const auto carry_on = [&](const BeamState& from) { return climb(p, from, low, high, shape); };
    K.block<12, 12>(6 * n, 6 * n) += piece_stiffness(carry_on, s, high - low, EI);
    s = carry_on(s);
    if (!pass_forces(p, high, s, shape)) return false;
    for (std::size_t i = 0; i < p.ropes.size(); ++i) {
      if (p.mast.guys[i].height == high) K.block<3, 3>(6 * n + 6, 6 * n + 6) += rope::stiffness(shape.spans[i]);
    }
  }
  for (Eigen::Index n = 0; n <= count; ++n) {  // turns in units of 1/height, so that all entries are of one kind
    K.middleRows<3>(6 * n + 3) /= height;
    K.middleCols<3>(6 * n + 3) /= height;
  }
  Array<Eigen::Index> free;
  for (Eigen::Index i = p.mast.base == MastBase::hinged ? 3 : 6; i < K.rows(); ++i) {
    if (i != 5) free.push_back(i);
  }
  const Eigen::MatrixXd reduced = K(free, free);
  if (!reduced.allFinite()) return false;
  const Eigen::LLT<Eigen::MatrixXd> factor(Eigen::MatrixXd((reduced + reduced.transpose()) / 2));
  return factor.info() == Eigen::Success;
}

bool holds(const GuyedMastProblem& p, Unknowns& u, int& iterations) {
  return find_equilibrium(p, u, iterations) && largest_slope(shoot(p, u, true).points) <= largest_mast_slope &&
         stable(p, u);
}

/// The whole load, in steps where one is too large; the share of the loads that is held, empty where the mast does not
/// stand even without them.
std::optional<double> load_up(GuyedMastProblem& p, Unknowns& u, int& iterations) {
  Unknowns at = u;
  p.share = 1;
  if (holds(p, at, iterations)) return u = at, 1.0;
  p.share = 0;
  if (!holds(p, u, iterations)) return std::nullopt;
  double held = 0, step = 0.5;
  while (held < 1 && step > 1e-3) {
    p.share = std::min(1.0, held + step);
    at = u;
    if (holds(p, at, iterations)) {
      held = p.share, u = at;
    } else {
      step /= 2;
    }
  }
  return held;
}

std::optional<Outcome> install(const GuyedMast& mast, GuyedMastProblem& p) {
  for (const Guy& guy : mast.guys) {
    const auto length = installed_length(guy);
    if (!length) {
      return taut::infeasible(fmt::format(
          "guy {}: no length gives {:.4g} N, its own weight alone pulls harder: install it with more tension, or take "
          "a lighter rope",
          guy.name, std::get<GuyTension>(guy.install).tension));
    }
    p.ropes.push_back(guy_rope(guy, *length));
  }
  return std::nullopt;
}

void set_up(const GuyedMast& mast, GuyedMastProblem& p) {
  p.heights = {0, mast.height};
  double force = mast.section.weight * mast.height;
  for (const Guy& guy : mast.guys) p.heights.push_back(guy.height);
  for (const MastLoad& load : mast.loads) p.heights.push_back(load.height), force += load.force.norm();
  std::sort(p.heights.begin(), p.heights.end());
  p.heights.erase(std::unique(p.heights.begin(), p.heights.end()), p.heights.end());
  for (std::size_t i = 0; i < p.ropes.size(); ++i) {
    const double T = tension(mast.guys[i], p.ropes[i].length, GuyEnd::top);
    if (std::isfinite(T)) force += T;
  }
  p.force = force > 0 ? force : 1;
}

std::string buckles(const GuyedMastProblem& p, const std::optional<double>& held) {
  if (!held) {
    return p.mast.guys.empty()
               ? "the mast does not stand up to its own weight: give it a stiffer section"
               : "the mast buckles under the tension of its guys alone: install them with less tension, "
                 "balance them around the mast, or give it a stiffer section";
  }
  return fmt::format(
      "the mast finds no stable equilibrium above {:.3g} % of its loads: it buckles; give it a stiffer section, {}",
      100 * *held,
      p.mast.guys.empty() ? "or guys" : "stiffer or tighter guys on the side away from the load, or lower rope forces");
}

GuyState guy_state(const Guy& guy, const rope::Span& span) {
  GuyState g;
  g.length = span.rope.length;
  g.tension_installed = tension(guy, g.length, GuyEnd::top);
  g.tension_top = rope::tension_at_end(span);
  g.tension_anchor = rope::tension_at_start(span);
  g.force_on_mast = rope::force_on_end(span);
  g.force_on_anchor = rope::force_on_start(span);
  g.slack = span.rope.length >= span.chord.norm();
  const double largest = rope::largest_tension(span);
  g.safety =
      guy.breaking_force && largest > 0 ? *guy.breaking_force / largest : std::numeric_limits<double>::quiet_NaN();
  g.closure = span.closure;
  return g;
}

const BeamState& at_height(const Array<MastPoint>& points, double height) {
  return std::find_if(points.begin(), points.end(), [&](const MastPoint& m) { return m.height == height; })->state;
}

/// The mast's own weight as a force and its moment about the foot, by the trapezoidal rule over the points.
void add_own_weight(const GuyedMast& mast, const Array<MastPoint>& points, Vector3& force, Vector3& moment) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vector3 W = -mast.section.weight * (points[i].height - points[i - 1].height) * taut::up();
    force += W;
    moment += (points[i].state.place + points[i - 1].state.place).cross(W) / 2;
  }
}

void fill(const GuyedMastProblem& p, const Unknowns& u, GuyedMastResult& out) {
  Shape shape = shoot(p, u, true);
  out.points = std::move(shape.points);
  const auto& points = out.points;
  out.top = points.back().state.place - Vector3(0, 0, p.mast.height);
  out.base_force = -points.front().state.force;
  out.base_moment = -points.front().state.moment;
  Vector3 force = out.base_force, moment = out.base_moment;
  const auto add = [&](double height, const Vector3& F) {
    force += F;
    moment += at_height(points, height).place.cross(F);
  };
  for (const MastLoad& load : p.mast.loads) add(load.height, load.force);
  for (std::size_t i = 0; i < p.ropes.size(); ++i) {
    out.guys.push_back(guy_state(p.mast.guys[i], shape.spans[i]));
    out.closure = std::max(out.closure, shape.spans[i].closure);
    add(p.mast.guys[i].height, out.guys.back().force_on_mast);
  }
  if (p.mast.section.weight > 0) add_own_weight(p.mast, points, force, moment);
  out.force_balance = force.norm();
  out.moment_balance = moment.norm();
  out.largest_slope = largest_slope(points);
  const auto less = [](const MastPoint& a, const MastPoint& b) { return a.stress < b.stress; };
  const auto straighter = [](const MastPoint& a, const MastPoint& b) { return bending(a) < bending(b); };
  out.worst = static_cast<std::size_t>(std::max_element(points.begin(), points.end(), less) - points.begin());
  out.most_bent = static_cast<std::size_t>(std::max_element(points.begin(), points.end(), straighter) - points.begin());
}

}  // namespace

double bending(const MastPoint& point) {
  const auto f = section_forces(point.state);
  return std::hypot(f.bends_to_x, f.bends_to_y);
}

std::optional<double> installed_length(const Guy& guy) {
  if (const auto* given = std::get_if<GuyLength>(&guy.install)) return given->length;
  const auto& wanted = std::get<GuyTension>(guy.install);
  const double chord = (Vector3(0, 0, guy.height) - guy.anchor).norm();
  if (wanted.tension <= 0) return guy.weight > 0 ? std::nullopt : std::optional(chord);
  const auto T = [&](double length) { return tension(guy, length, wanted.at); };
  const double shortest = chord / (1 + 2 * (wanted.tension + guy.weight * chord) / guy.stiffness);
  if (guy.weight == 0) return chord / (1 + wanted.tension / guy.stiffness);
  // The tension falls with the length, until the rope hangs so deep that its own weight makes it grow again.
  std::uintmax_t iterations = 200;
  const double longest = boost::math::tools::brent_find_minima(T, shortest, 3 * chord, 40, iterations).first;
  return taut::find_root([&](double length) { return T(length) - wanted.tension; }, shortest, longest);
}

Outcome solve(const GuyedMast& mast, GuyedMastResult& out) {
  taut::expects(mast.height > 0, "a mast has a height");
  for (const Guy& guy : mast.guys) {
    taut::expects(guy.height > 0 && guy.height <= mast.height, "a guy is fixed to its mast");
    taut::expects(std::isfinite(guy.stiffness) && guy.stiffness > 0, "a guy is elastic");
  }
  for (const MastLoad& load : mast.loads) {
    taut::expects(load.height > 0 && load.height <= mast.height, "a load acts on its mast");
  }
  GuyedMastProblem p{.mast = mast, .ropes = {}, .heights = {}, .force = 1, .share = 1};
  if (const auto no = install(mast, p)) return *no;
  set_up(mast, p);
  Unknowns u = Unknowns::Zero();
  int iterations = 0;
  const auto held = load_up(p, u, iterations);
  if (!held || *held < 1) return taut::infeasible(buckles(p, held));
  out = {};
  p.share = 1;
  fill(p, u, out);
  out.iterations = iterations;
  return {};
}

}  // namespace taut_test::witness
