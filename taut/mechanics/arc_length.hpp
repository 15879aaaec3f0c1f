#pragma once

namespace taut::mechanics {

/// Rope on a round, as it runs. `friction` of the rope on it; infinite: it does not slip. `flow`: +1 along the path, -1
/// against it, 0: at rest.
struct Arc {
  double radius = 0, wrap = 0;  ///< m, rad
  double T_in = 0, T_out = 0;   ///< by the order of the path, N
  double stiffness = 0;         ///< EA, N
  double friction = 0;
  int flow = 0;
};

/// The unstretched length on an arc, m, and its derivatives. A rope that runs comes on with its tension T_e and rests
/// on the round; on the last part of its way, phi = |ln(T_x/T_e)|/mu (the whole wrap where it slips as a whole), it
/// slips and its tension changes to T_x by the capstan law (Reynolds 1875, Grashof):
///   L = R (theta - phi)/(1 + T_e/EA) + R phi [1 - ln((EA + T_x)/(EA + T_e))/ln(T_x/T_e)].
/// At rest, where nothing is known of its history, by the mean of its tensions; so too where one of them is not
/// positive (on the way to an answer).
struct ArcLength {
  double length = 0;
  double by_in = 0, by_out = 0;  ///< m/N
  double by_wrap = 0;            ///< m
};
ArcLength arc_length(const Arc& arc);

}  // namespace taut::mechanics
