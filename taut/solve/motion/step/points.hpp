#pragma once
#include "taut/base/array.hpp"
#include "taut/solve/motion/run/run.hpp"

namespace taut::solve::dynamics {

/// Point masses and the lines between them side by side, for many explicit steps in a row. Node 0 is the ground.
struct Points {
  Array<double> x, v, a, dead;  ///< by node, three each: m, m/s, m/s2; dead: forces that do not change, N
  Array<double> inverse_mass;   ///< by node, 1/kg; 0: does not move
  struct Link {
    int from = 0, to = 0;
    double dx = 0, dy = 0, dz = 0;  ///< from the origin of one end's body to the other's, beside their places, m
    double per_length = 1;          ///< 1/L
    double stiffness = 0;           ///< EA of all copies, N
    double damping = 0;             ///< beta, s
    double copies = 1;
    double hangs = 0;  ///< half of its weight, of one copy, N
  };
  Array<Link> links;        ///< by line
  Array<double> e, e_last;  ///< by line: strain now and before
  Array<double> T;          ///< by line: of one copy, N
  Array<double> change;     ///< by line: of that in the last step, N
  Array<double> force;      ///< by node, three each, N
};

/// Whether the steps to come may be taken so: Verlet, nothing but points, no break under way, no condition to watch.
bool steps_as_points(const Run& run);

/// Steps of velocity Verlet, all but the last few to the time `limit`, `most` at most. The same as one by one, without
/// what nobody reads in between; slack and taut, extremes and the dampers' work are kept at each step.
void step_points(Run& run, Points& points, double limit, long most);

}  // namespace taut::solve::dynamics
