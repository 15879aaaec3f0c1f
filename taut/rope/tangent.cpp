#include "taut/rope/tangent.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "taut/base/expects.hpp"

namespace taut::rope {
namespace {

constexpr int most_tangent_iterations = 60;
constexpr int start_passes = 4;
constexpr double full_turn = 2 * std::numbers::pi;

struct Frame {
  Vector3 r, tangent;  ///< outwards and right-handed about the axis, at the rope's contact
};

Frame frame_at(const Round& round, double angle) {
  const Vector3 other = round.axis.cross(round.zero);
  const double c = std::cos(angle), s = std::sin(angle);
  return {.r = c * round.zero + s * other, .tangent = c * other - s * round.zero};
}

double angle_of(const Round& round, const Vector3& r) {
  return std::atan2(r.dot(round.axis.cross(round.zero)), r.dot(round.zero));
}

bool is_point(const Round& round) { return round.radius == 0; }

/// Direction, in the plane across `axis`, of the line that leaves the circle of signed radius R1 (side times radius)
/// and arrives at that of R2, `d` between their centres: d = l t + (R2 - R1) axis x t.
std::optional<Vector3> direction_across(const Vector3& axis, const Vector3& d, double R1, double R2) {
  const Vector3 flat = d - d.dot(axis) * axis;
  const double rho = R2 - R1;
  const double square = flat.squaredNorm();
  const double free = square - rho * rho;
  if (!(free > 0)) return std::nullopt;
  return Vector3((std::sqrt(free) * flat - rho * axis.cross(flat)) / square);
}

/// Angle of the contact on `round` where the path has the direction t in its plane: r = -side axis x t.
double contact_angle(const Round& round, const Vector3& t) {
  return is_point(round) ? 0 : angle_of(round, -round.side * round.axis.cross(t));
}

struct Angles {
  double from = 0, to = 0;
};

/// Closed form for parallel axes, or where at least one of the rounds is a point.
std::optional<Angles> parallel_angles(const Round& from, const Round& to) {
  const Round& main = is_point(from) ? to : from;
  const bool opposite = from.axis.dot(to.axis) < 0 && !is_point(from) && !is_point(to);
  const double R1 = from.side * from.radius;
  const double R2 = to.side * to.radius * (opposite ? -1 : 1);
  const auto t = direction_across(main.axis, to.centre - from.centre, R1, R2);
  if (!t) return std::nullopt;
  return Angles{.from = contact_angle(from, *t), .to = contact_angle(to, *t)};
}

/// A few passes of "the other end is a point": a start for Newton that is on the right side of both rounds.
std::optional<Angles> skew_start(const Round& from, const Round& to) {
  Angles a;
  Vector3 end = to.centre;
  for (int i = 0; i < start_passes; ++i) {
    const auto leaves = parallel_angles(from, point(end));
    if (!leaves) return std::nullopt;
    a.from = leaves->from;
    const auto arrives = parallel_angles(point(place_at(from, a.from)), to);
    if (!arrives) return std::nullopt;
    a.to = arrives->to;
    end = place_at(to, a.to);
  }
  return a;
}

/// Both ends, their frames, and the Jacobian of the conditions d.r1 = 0, d.r2 = 0 in the two angles.
struct TangentEnds {
  Frame f1, f2;
  Vector3 d;
  Eigen::Vector2d g;
  Eigen::Matrix2d J;
};

TangentEnds ends_at(const Round& from, const Round& to, const Angles& a) {
  TangentEnds e{.f1 = frame_at(from, a.from), .f2 = frame_at(to, a.to), .d = {}, .g = {}, .J = {}};
  e.d = to.centre + to.radius * e.f2.r - from.centre - from.radius * e.f1.r;
  e.g << e.d.dot(e.f1.r), e.d.dot(e.f2.r);
  e.J << e.d.dot(e.f1.tangent), to.radius * e.f2.tangent.dot(e.f1.r), -from.radius * e.f1.tangent.dot(e.f2.r),
      e.d.dot(e.f2.tangent);
  if (is_point(from)) {  // its angle means nothing
    e.g(0) = 0;
    e.J.row(0) << 1, 0;
  }
  if (is_point(to)) {
    e.g(1) = 0;
    e.J.row(1) << 0, 1;
  }
  return e;
}

/// The line runs with both rounds, not against them.
bool right_way(const Round& from, const Round& to, const TangentEnds& e) {
  return (is_point(from) || from.side * e.d.dot(e.f1.tangent) > 0) &&
         (is_point(to) || to.side * e.d.dot(e.f2.tangent) > 0);
}

/// Newton for the two angles; the number of its steps, none if it does not arrive.
std::optional<int> close(const Round& from, const Round& to, Angles& a) {
  const double scale = (to.centre - from.centre).norm() + from.radius + to.radius;
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < most_tangent_iterations; ++i) {
    const TangentEnds e = ends_at(from, to, a);
    const double error = e.g.norm();
    if (error <= 1e-15 * scale || (error >= best && error <= 1e-13 * scale)) {
      return right_way(from, to, e) ? std::optional(i) : std::nullopt;
    }
    best = std::min(best, error);
    Eigen::Vector2d step = -e.J.inverse() * e.g;
    if (!step.allFinite()) return std::nullopt;
    const double largest = step.cwiseAbs().maxCoeff();
    if (largest > 0.5) step *= 0.5 / largest;
    a.from += step(0);
    a.to += step(1);
  }
  return std::nullopt;
}

TangentLine line_at(const Round& from, const Round& to, const Angles& a, int iterations) {
  TangentLine line;
  line.from = place_at(from, a.from);
  line.to = place_at(to, a.to);
  const Vector3 d = line.to - line.from;
  line.length = d.norm();
  line.direction = d / line.length;
  line.angle_from = std::remainder(a.from, full_turn);
  line.angle_to = std::remainder(a.to, full_turn);
  if (!is_point(from)) line.fleet_from = std::asin(line.direction.dot(from.axis));
  if (!is_point(to)) line.fleet_to = std::asin(line.direction.dot(to.axis));
  line.iterations = iterations;
  return line;
}

/// The matrix of `v x`.
Matrix3 cross_matrix(const Vector3& v) {
  Matrix3 m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

}  // namespace

std::string_view to_text(NoLine why) {
  switch (why) {
    case NoLine::inside:
      return "the two are so near to each other that no straight rope goes between them on these sides";
    case NoLine::not_converged:
      return "no straight rope found between two sheaves in skew planes";
  }
  return {};
}

Round sheave(const Vector3& centre, const Vector3& axis, double radius, int side, const std::optional<Vector3>& zero) {
  expects(centre.allFinite() && axis.allFinite() && axis.norm() > 0, "a sheave has a centre and an axis");
  expects(radius >= 0 && std::isfinite(radius), "a sheave has a radius");
  expects(side == 1 || side == -1, "a rope runs right-handed or left-handed over a sheave");
  Round round{.centre = centre, .axis = axis.normalized(), .zero = Vector3::Zero(), .radius = radius, .side = side};
  // by default the coordinate direction that is farthest from the axis
  Eigen::Index least = 0;
  round.axis.cwiseAbs().minCoeff(&least);
  const Vector3 direction = zero.value_or(Vector3::Unit(least));
  const Vector3 across = direction - direction.dot(round.axis) * round.axis;
  expects(across.norm() > 1e-9 * direction.norm(), "angles are not counted from the axis");
  round.zero = across.normalized();
  return round;
}

Round point(const Vector3& at) {
  return {.centre = at, .axis = Vector3::UnitY(), .zero = Vector3::UnitX(), .radius = 0, .side = 1};
}

Round reversed(Round round) {
  round.side = -round.side;
  return round;
}

Vector3 place_at(const Round& round, double angle) { return round.centre + round.radius * frame_at(round, angle).r; }

tl::expected<TangentLine, NoLine> tangent_line(const Round& from, const Round& to,
                                               const std::optional<std::pair<double, double>>& start) {
  const bool closed_form = is_point(from) || is_point(to) || from.axis.cross(to.axis).norm() < 1e-15;
  if (closed_form) {
    const auto a = parallel_angles(from, to);
    if (!a || (is_point(from) && is_point(to) && from.centre == to.centre)) return tl::unexpected(NoLine::inside);
    return line_at(from, to, *a, 0);
  }
  if (start) {
    Angles a{.from = start->first, .to = start->second};
    if (const auto steps = close(from, to, a)) return line_at(from, to, a, *steps);
  }
  // nearly parallel axes: the closed form of their projection is the better start, and right for crossed ropes
  for (const auto& guess : {parallel_angles(from, to), skew_start(from, to)}) {
    if (!guess) continue;
    Angles a = *guess;
    if (const auto steps = close(from, to, a)) return line_at(from, to, a, *steps);
  }
  return tl::unexpected(skew_start(from, to) ? NoLine::not_converged : NoLine::inside);
}

LineRates line_rates(const Round& from, const Round& to, const TangentLine& line) {
  const TangentEnds e = ends_at(from, to, {.from = line.angle_from, .to = line.angle_to});
  const Vector3 &r1 = e.f1.r, &r2 = e.f2.r;
  Eigen::Matrix<double, 2, 12> g;  // of the two conditions, at constant angles
  g.row(0) << -r1.transpose(), r1.cross(e.d).transpose(), r1.transpose(), to.radius * r2.cross(r1).transpose();
  g.row(1) << -r2.transpose(), -from.radius * r1.cross(r2).transpose(), r2.transpose(), r2.cross(e.d).transpose();
  if (is_point(from)) g.row(0).setZero();
  if (is_point(to)) g.row(1).setZero();
  const Eigen::Matrix<double, 2, 12> angles = -e.J.inverse() * g;
  LineRates rates;
  rates.angle_from = angles.row(0);
  rates.angle_to = angles.row(1);
  rates.from = from.radius * e.f1.tangent * rates.angle_from;
  rates.from.middleCols<3>(0) += Matrix3::Identity();
  rates.from.middleCols<3>(3) -= from.radius * cross_matrix(r1);
  rates.to = to.radius * e.f2.tangent * rates.angle_to;
  rates.to.middleCols<3>(6) += Matrix3::Identity();
  rates.to.middleCols<3>(9) -= to.radius * cross_matrix(r2);
  rates.length = line.direction.transpose() * (rates.to - rates.from);
  return rates;
}

double wrap_angle(int side, double arrives, double leaves, int turns) {
  double wrap = std::fmod(side * (leaves - arrives), full_turn);
  if (wrap < 0) wrap += full_turn;
  if (wrap >= full_turn) wrap = 0;  // a negative number that vanished beside 2 pi
  return wrap + turns * full_turn;
}

double wrap_angle_near(int side, double arrives, double leaves, double previous) {
  return previous + std::remainder(side * (leaves - arrives) - previous, full_turn);
}

}  // namespace taut::rope
