#pragma once
#include <limits>

#include "taut/calc/outcome.hpp"

/// An endless elastic rope on a driving sheave and an idler, running steadily: the tensions that set themselves. All
/// SI.
namespace taut::solve {

enum class TakeUp {
  weight,  ///< a constant pull on the idler
  screw    ///< fixed centres, set so that the pull on the idler is this at rest without load
};

/// Where the load holds the rope back. at_idler: the idler feels the whole tight tension (the method's assumption).
/// in_tight_branch: in its middle, so that between idler and load the rope has little more than the slack tension.
enum class LoadPlace { at_idler, in_tight_branch };

struct BeltDrive {
  double friction = 0;       ///< mu on the driving sheave, > 0
  double wrap = 0;           ///< on the driving sheave, rad, > 0
  double working_arc = 0;    ///< of it, the part that can pull, rad, > 0, <= wrap
  double momentum_flow = 0;  ///< c = q U^2, N
  double idler_loss = 1;     ///< tension after the idler over that before it, >= 1
  double load = 0;           ///< N, >= 0
  LoadPlace place = LoadPlace::at_idler;
  double stiffness = std::numeric_limits<double>::infinity();  ///< EA, N; infinite: small strains
  double branch = 1;                                           ///< length of each of the two branches, m, > 0
  double radius = 0;                                           ///< of both sheaves, m; 0: arcs left out of the length
  TakeUp take_up = TakeUp::weight;
  double pull = 0;  ///< of the weight, or of the screw at rest, N, > 0
};

struct BeltDriveState {
  double T_1 = 0;       ///< tight branch at the driving sheave, N; contains c, as all tensions
  double T_2 = 0;       ///< slack branch, N
  double load = 0;      ///< that the drive passes on, N: less than asked for where it slips
  double slip_arc = 0;  ///< arc on which the rope creeps, rad
  double rest_arc = 0;  ///< what is left of the working arc, rad
  double creep = 0;     ///< (T_1 - T_2)/EA
  double pull = 0;      ///< on the idler while it runs, N
  double stretch = 0;   ///< what the length is out by, over the length: closure of a screw take-up
  bool slips = false;   ///< the whole working arc slips
};

/// Tensions by: (14) T_1 = idler_loss T_2 + load; on the driving sheave first rest at T_1, then creep on
/// `slip_arc` = ln((T_1 - c)/(T_2 - c))/mu (rope/contact.hpp); for a weight the balance of the idler, for a screw the
/// rope's unstretched length, the integral of ds/(1 + T/EA) around the loop, as at rest. Where the arc does not do, the
/// drive slips at the limit and passes on what it can. Infeasible: no tension lies above c, the rope lifts off; or the
/// slipping drive can't even turn its idler.
Outcome solve(const BeltDrive& drive, BeltDriveState& out);

}  // namespace taut::solve
