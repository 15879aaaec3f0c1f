#pragma once
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/machine/place.hpp"
#include "taut/structure/rod.hpp"

namespace taut::machine {

/// How the end of a beam is connected to its body. clamped: no relative rotation. hinged at the start: free to incline
/// in any direction, no rotation about its own axis (a universal joint). hinged at the end: a ball joint.
enum class BeamHold { clamped, hinged };

/// A piece of a beam between two bodies (or the ground). Its own weight is the only load between its ends.
struct BeamPiece {
  structure::RodPiece rod;
  int section_every = 1;  ///< integration steps of `rod` between two listed sections; a divisor of their number
  Place start, end;
  BeamHold start_hold = BeamHold::clamped, end_hold = BeamHold::clamped;
  /// Axes of the section as built, in three frames: of the body at its start, of the body at its end, and of the body
  /// on which the whole beam begins (`reference`). A first-order beam takes its geometry from the last one.
  Matrix3 start_axes = Matrix3::Identity(), end_axes = Matrix3::Identity(), reference_axes = Matrix3::Identity();
  int reference = ground;
};

/// An elastic beam: a chain of pieces. The sections between two pieces are bodies that only the beam holds.
struct Beam {
  std::string name;
  double length = 0;  ///< of its axis as built, m
  Array<BeamPiece> pieces;
};

/// The unknowns of a piece.
struct PieceState {
  Vector3 force = Vector3::Zero();     ///< at its start, exerted by the part above on the part below, N
  Vector3 moment = Vector3::Zero();    ///< the same, N m; of a clamped start
  double torque = 0;                   ///< about the axis of a hinged start, N m
  Matrix3 axes = Matrix3::Identity();  ///< of the section at a hinged start
};

}  // namespace taut::machine
