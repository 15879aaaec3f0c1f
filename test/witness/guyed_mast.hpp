#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/calc/outcome.hpp"
#include "taut/math/vector.hpp"
#include "taut/rope/span.hpp"
#include "test/witness/rod_shooting.hpp"

/// A guyed mast by shooting, apart from the engine: a geometrically exact beam held by elastic catenaries. All SI, the
/// foot at the origin, z up.
namespace taut_test::witness {

using taut::Array;
using taut::Outcome;
using taut::Vector3;
namespace rope = taut::rope;
namespace structure = taut::structure;

enum class MastBase { clamped, hinged };  ///< hinged: free to lean any way, held against turning about its axis

/// How a guy is set while the mast stands plumb, unloaded and not yet shortened: by its unstretched length, or by the
/// tension at one of its ends. Afterwards the unstretched length stays.
struct GuyLength {
  double length = 0;  ///< m
};
enum class GuyEnd { top, anchor };
struct GuyTension {
  double tension = 0;  ///< N
  GuyEnd at = GuyEnd::top;
};
using GuyInstallation = std::variant<GuyLength, GuyTension>;

struct Guy {
  std::string name;
  double height = 0;                 ///< of its fixing on the mast's axis, m
  Vector3 anchor = Vector3::Zero();  ///< m
  double stiffness = 0;              ///< EA, N, finite
  double weight = 0;                 ///< per unstretched metre, N/m
  GuyInstallation install;
  std::optional<double> breaking_force;  ///< N
};

/// A force on the mast's axis that keeps its direction.
struct MastLoad {
  double height = 0;  ///< m
  Vector3 force = Vector3::Zero();
};

struct GuyedMast {
  double height = 0;  ///< m
  structure::BeamSection section;
  MastBase base = MastBase::clamped;
  Array<Guy> guys;
  Array<MastLoad> loads;
};

struct GuyState {
  double length = 0;             ///< unstretched, m
  double tension_installed = 0;  ///< at the top, mast plumb and unloaded, N
  double tension_top = 0;        ///< N
  double tension_anchor = 0;     ///< N
  Vector3 force_on_mast = Vector3::Zero();
  Vector3 force_on_anchor = Vector3::Zero();
  bool slack = false;  ///< not shorter than its chord: it carries no more than its own weight
  double safety = 0;   ///< breaking force over the largest tension; NaN where none is given
  double closure = 0;  ///< m
};

/// One section of the deflected mast.
struct MastPoint {
  double height = 0;  ///< along the axis, unstrained, m
  BeamState state;
  double stress = 0;  ///< largest |N|/A + M/W, Pa
};

struct GuyedMastResult {
  Vector3 top = Vector3::Zero();          ///< displacement of the top, m
  Vector3 base_force = Vector3::Zero();   ///< of the ground on the mast, N
  Vector3 base_moment = Vector3::Zero();  ///< N m
  Array<GuyState> guys;
  Array<MastPoint> points;    ///< from the foot to the top; two at a height where a force acts
  std::size_t worst = 0;      ///< the point of the largest stress
  std::size_t most_bent = 0;  ///< the point of the largest bending moment
  double force_balance = 0;   ///< |base + loads + guys + own weight|, N
  double moment_balance = 0;  ///< the same about the foot, in the deflected shape, N m
  double closure = 0;         ///< the worst of the guys, m
  double largest_slope = 0;   ///< of the mast's axis against the vertical, rad
  int iterations = 0;
};

/// Bending moment at a point of the mast, whatever its direction, N m.
double bending(const MastPoint& point);

/// Beyond this inclination a mast counts as failed: an elastic strut finds equilibria beyond buckling, a mast does not.
inline constexpr double largest_mast_slope = 0.5;  // rad

/// Unstretched length of a guy as installed, m; empty where the tension is less than the guy's own weight causes at any
/// length.
std::optional<double> installed_length(const Guy& guy);

/// Equilibrium of the mast under its loads and guys, by shooting from the foot (Newton on base force and moment, or
/// base force and inclination), in load steps where needed; and its stability, by the tangent stiffness of the whole
/// system: an equilibrium that is none to stay in is refused. Infeasible: a guy's tension can't be had; the mast
/// buckles, with the share of the loads that it still carries. `out` is filled when ok.
Outcome solve(const GuyedMast& mast, GuyedMastResult& out);

}  // namespace taut_test::witness
