#pragma once
#include <limits>
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/study/line/rope_clearance.hpp"

namespace taut::study {

/// The tension at one end of a rope: what a winch there has to pull.
struct EndLimit {
  int reeving = 0;
  bool at_end = false;                                       ///< of the path; else at its start
  double tension = std::numeric_limits<double>::infinity();  ///< N
};

/// What must not be exceeded.
struct PayloadLimits {
  Array<double> tension;  ///< [reeving]: largest tension allowed anywhere in the rope (the band at rest counts),
                          ///< N; infinite: none. Empty: no rope is limited
  Array<EndLimit> ends;
  double clearance = -std::numeric_limits<double>::infinity();  ///< least height of the body above the terrain, m; not
                                                                ///< asked where there is no terrain
  Array<double> rope_clearance;  ///< [reeving]: least height of the rope above the terrain within
                                 ///< rope_between, m; -infinity: none. Empty: no rope
  RopeWindow rope_between;
  /// Angle by which a rope bends over a support on the ground: at most and at least this, rad.
  double break_angle = std::numeric_limits<double>::infinity();
  double least_break_angle = -std::numeric_limits<double>::infinity();
  bool lift_off = false;  ///< no rope may pull a support upwards or leave it
  double most = 1e6;      ///< no payload above this is looked for, kg
};

/// What a limit is about.
enum class LimitKind { none, tension, pull, clearance, rope_clearance, break_angle, least_break_angle, lift_off };

/// One limit and what is there: N, m or rad.
struct LimitState {
  LimitKind kind = LimitKind::none;
  int reeving = -1;  ///< whose tension, clearance or bend it is
  int node = -1;     ///< where: of a pull, a break angle or a lift-off
  double value = 0;  ///< lift-off: the angle by which the rope bends over the support, 0 where it has left it
  double limit = 0;
  double margin = 1;   ///< below 0: broken; of the limit, lengths by the height (at least 1 m), lift-off in rad
  bool fails = false;  ///< no equilibrium
};

/// All limits in one state, in the order of the limits' members. A state without equilibrium: one that fails.
Array<LimitState> limits_at(const machine::Model& model, int body, const PayloadLimits& limits,
                            const solve::EquilibriumResult& result);

/// "tension of 'skyline'", "break angle at 'jack1'".
std::string limit_words(const machine::Model& model, int body, const LimitState& limit);

}  // namespace taut::study
