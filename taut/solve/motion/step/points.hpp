#pragma once
#include <Eigen/Core>

#include "taut/base/array.hpp"
#include "taut/solve/motion/run/run.hpp"

namespace taut::solve::dynamics {

/// Ropes between point masses laid out side by side, for many explicit steps in a row. The nodes of a strand (a rope,
/// or its part between two bodies) stand one after another: its joints, and at either end a copy of the body's place.
/// The link i runs from node i to node i + 1; between two strands it is none, without stiffness.
struct Points {
  using Column = Eigen::ArrayXd;
  using Places = Eigen::Array<double, Eigen::Dynamic, 3>;

  /// By node. free_fall: acceleration by forces that do not change.
  Places x, v, a, free_fall;  ///< m, m/s, m/s2, m/s2
  Column share;               ///< 1/mass, 1/kg; 0 at the ends of strands
  struct End {
    int node = 0, body = -1;
    Vector3 offset = Vector3::Zero();  ///< from the body's origin, m
  };
  Array<End> starts, ends;        ///< by strand; body: -1 is the ground
  Array<Vector3> at, velocity;    ///< by body that is no joint, m, m/s
  Array<Vector3> rate;            ///< m/s2
  Array<Vector3> on_body, still;  ///< all forces, and those that do not change, N
  Array<double> body_share;       ///< 1/mass, 1/kg; 0: does not move

  Array<int> link;                           ///< by line
  Array<int> line;                           ///< by link; -1: none
  Array<int> joint;                          ///< by link: of the mechanism's bodies the one at its end; -1: no joint
  Array<int> body;                           ///< of the mechanism's, those that are no joints
  Column L, per_length, stiffness, damping;  ///< by link: m, 1/m, EA of one copy, N, beta, s
  Column copies;
  std::array<Column, 2> hangs;  ///< half of its weight at each end, of one copy, N; 0 at joints
  bool damped = false;
  bool changes_known = false;  ///< `change` is that of a step before
  Places force;                ///< by link: on the node before it, of all copies, N
  Column l;                    ///< by link, m
  Column e, e_was;             ///< strain now and a step before
  Column T, change;            ///< of one copy; in the last step, N
  Column held;                 ///< of that, by the damper, N
  Column error;                ///< the largest one of T, N
};

/// Whether the steps to come may be taken so: Verlet, nothing but points, no break under way, no condition to watch.
bool steps_as_points(const Run& run);

/// Steps of velocity Verlet, all but the last few to the time `limit`, `most` at most. The same as one by one, without
/// what nobody reads in between; slack and taut, extremes and the dampers' work are kept at each step.
void step_points(Run& run, Points& points, double limit, long most);

}  // namespace taut::solve::dynamics
