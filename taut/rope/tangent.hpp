#pragma once
#include <optional>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>

#include "taut/math/vector.hpp"

namespace taut::rope {

/// What a rope runs over: a sheave, a drum, or a point (radius 0). The rope's centre lies on the circle of `radius`
/// about `axis`. Make it with `sheave` or `point`, which keep its axes at right angles.
struct Round {
  Vector3 centre = Vector3::Zero();  ///< m
  Vector3 axis = Vector3::UnitY();   ///< unit vector
  Vector3 zero =
      Vector3::UnitX();  ///< unit vector across the axis, from which angles are counted, right-handed about the axis
  double radius = 0;     ///< m
  int side = 1;          ///< +1: along its path the rope turns right-handed about the axis; -1: left-handed
};

/// A sheave or a drum. `axis` of any length but 0; `zero` of any direction but the axis's, by default chosen from the
/// axis.
Round sheave(const Vector3& centre, const Vector3& axis, double radius, int side,
             const std::optional<Vector3>& zero = std::nullopt);
Round point(const Vector3& at);

/// The same rope run the other way.
Round reversed(Round round);

/// Place of the rope's centre at the angle about the round, m.
Vector3 place_at(const Round& round, double angle);

/// The straight free rope between two rounds.
struct TangentLine {
  Vector3 from = Vector3::Zero(), to = Vector3::Zero();  ///< where it leaves and where it arrives, m
  Vector3 direction = Vector3::UnitX();                  ///< unit vector
  double length = 0;                                     ///< m
  double angle_from = 0, angle_to = 0;  ///< of its ends about their rounds, rad, in (-pi, pi]; 0 at a point
  double fleet_from = 0,
         fleet_to = 0;  ///< fleet angles: between the line and the round's plane, rad, positive towards the axis
  int iterations = 0;   ///< 0 where there is a closed form
};

/// Why there is no line.
enum class NoLine {
  inside,        ///< a round lies too near to the other, or a point inside a round
  not_converged  ///< skew rounds close to each other
};
std::string_view to_text(NoLine why);

/// The line along which a rope goes from one round to the next. At each end it lies in the plane that touches the
/// round's cylinder there: in the groove's plane it is tangent, and across it there may be a fleet angle (side flange;
/// the small change of the contact point by a groove of finite depth is left out). Closed form for parallel axes (in
/// one plane or not) and for points; else Newton for the two angles. `start`: angles of a nearby line.
tl::expected<TangentLine, NoLine> tangent_line(const Round& from, const Round& to,
                                               const std::optional<std::pair<double, double>>& start = std::nullopt);

/// Derivatives of a line with respect to the motion of its rounds. Columns: translation of `from` (3), rotation vector
/// of `from` with its axis and zero (3), translation of `to` (3), rotation vector of `to` (3).
struct LineRates {
  using Row = Eigen::Matrix<double, 1, 12>;
  using Rows = Eigen::Matrix<double, 3, 12>;
  Row length = Row::Zero();
  Row angle_from = Row::Zero(), angle_to = Row::Zero();
  Rows from = Rows::Zero(), to = Rows::Zero();
};
LineRates line_rates(const Round& from, const Round& to, const TangentLine& line);

/// Angle over which the rope lies on a round, from the angle at which it arrives to that at which it leaves, in path
/// sense: in [0, 2 pi) plus 2 pi for each of `turns`.
double wrap_angle(int side, double arrives, double leaves, int turns = 0);

/// The same, as the value nearest to `previous`: follows a wrap beyond 2 pi, and below 0, where the rope has left the
/// round.
double wrap_angle_near(int side, double arrives, double leaves, double previous);

}  // namespace taut::rope
