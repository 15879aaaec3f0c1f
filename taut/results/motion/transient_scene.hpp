#pragma once
#include "taut/calc/result.hpp"
#include "taut/study/transient.hpp"

namespace taut::results {

/// Where something round or a body is in one frame, and what the ropes do to it.
struct HeldPart {
  std::string name;
  Vector3 at = Vector3::Zero();
  double radius = 0;
  Vector3 axis = Vector3::UnitY();  ///< in the ground frame
  double turned = 0;                ///< rad, right-handed about the axis, against the body that carries it
  Vector3 force = Vector3::Zero();  ///< of all ropes on it, all copies, N
  bool moves = false;               ///< on a body that is free or has a given motion
};

/// The free parts of the ropes in one frame, each with the arc behind it: points from node to node.
struct RopePart {
  int reeving = 0, from = 0;
  std::vector<Vector3> points;  ///< m; empty: broken
  std::vector<double> tension;  ///< N, by point
};

/// A place of a body in one frame, seen from the ground.
Vector3 place_in(const solve::TransientFrame& frame, const machine::Place& place);

std::vector<RopePart> rope_parts(const machine::Model& model, const solve::TransientFrame& frame);
/// In the order of their first node along the ropes; each name once.
std::vector<HeldPart> held_parts(const machine::Model& model, const solve::TransientFrame& frame,
                                 const solve::TransientFrame& first);

/// All frames as a scene in space, and its name, which the figures of the same motion bear as theirs.
Scene scene_of(const study::TransientRun& run);
std::string scene_name(const study::TransientRun& run);

}  // namespace taut::results
