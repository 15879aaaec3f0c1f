#pragma once
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/study/line/rope_clearance.hpp"

namespace taut::study {

/// Limit of the pull of the winch at one end of a rope: of all its copies together, and of the other ropes on its drum
/// that are wound the same way.
struct EndLimit {
  int reeving = 0;
  bool at_end = false;                                    ///< true: at the end of the path; false: at its start
  double pull = std::numeric_limits<double>::infinity();  ///< N
};

/// Limits of a payload.
struct PayloadLimits {
  Array<double> tension;  ///< [reeving]: largest tension allowed anywhere in the rope (at rest the band counts), N;
                          ///< infinite: none. Empty: no limits
  Array<EndLimit> ends;
  double clearance = -std::numeric_limits<double>::infinity();  ///< least height of the body above the terrain, m; not
                                                                ///< used without terrain
  Array<double> rope_clearance;  ///< [reeving]: least height of the rope above the terrain within rope_between, m;
                                 ///< -infinity: none. Empty: no limits
  RopeWindow rope_between;
  /// Largest and least angle by which a rope may bend over a support on the ground, rad. The largest counts all of its
  /// bend, the least what holds it there (line/bend_onto.hpp). On one that holds it down it may bend as little as it
  /// will.
  double break_angle = std::numeric_limits<double>::infinity();
  double least_break_angle = -std::numeric_limits<double>::infinity();
  bool lift_off = false;                               ///< true: no rope may pull a support upwards or lift off it
  std::optional<double> rated_payload = std::nullopt;  ///< largest load on the carriage whose body it is, kg
  double most = 1e6;                                   ///< upper bound of the search, kg
};

/// What a carriage carries besides its own mass: hanging masses and downward forces on its body, and a payload in the
/// mass of its body, kg. `t`: the time in a motion, in which a signal gives the size of a force, s; none: at rest.
double load_on(const machine::Model& model, const machine::Carriage& carriage, std::optional<double> t = std::nullopt);

/// The free rope between a carriage and a body that hangs on it, a load on a dropline: which body, none for any other
/// rope. The ground, another carriage, a section of a beam and a point of a rope where a force acts do not hang, nor
/// does what is at the other end of the rope on which it rides, of its mainline, its haulback or the rope to which it
/// is fixed: a shackle, a block on a strap. But a mainline that runs on over a sheave of the carriage has a hook there.
std::optional<int> hung_on(const machine::Model& model, const machine::Carriage& carriage, int reeving, int from,
                           int to);

/// Whether the free rope pulls a carriage to what stands: the ground, a fixed body or a beam. Not the rope on which the
/// carriage rides, nor its mainline, its haulback and the rope to which it is fixed: these draw it along its line.
bool holds_down(const machine::Model& model, const machine::Carriage& carriage, int reeving, int from, int to);

/// Kind of a limit.
enum class LimitKind {
  none,
  tension,
  pull,
  clearance,
  rope_clearance,
  break_angle,
  least_break_angle,
  lift_off,
  rated_payload
};

/// One limit and the value compared with it, N, m, rad or kg.
struct LimitState {
  LimitKind kind = LimitKind::none;
  std::optional<int> reeving = std::nullopt;  ///< the rope to which it refers
  std::optional<int> node = std::nullopt;     ///< the node of a pull, break angle or lift-off
  double value = 0;  ///< of lift_off: the angle by which the rope is bent onto the support, 0 where it has lifted off
  double limit = 0;
  double margin = 1;   ///< < 0: exceeded. Relative to the limit; lengths relative to the height of the body (at least 1
                       ///< m); angles and lift-off in rad
  bool fails = false;  ///< true: there is no equilibrium
};

/// All limits in one state, in the order of the members of PayloadLimits, each where it is nearest of the answer and
/// its bounds: friction may hold the machine in any of them. A state without equilibrium gives one entry with `fails`.
/// `payload`: a mass on the body that the state has and the model has not, kg.
Array<LimitState> limits_at(const machine::Model& model, int body, const PayloadLimits& limits,
                            const solve::EquilibriumResult& result, double payload = 0);

/// "tension of 'skyline'", "break angle at 'jack1'".
std::string limit_words(const machine::Model& model, int body, const LimitState& limit);

}  // namespace taut::study
