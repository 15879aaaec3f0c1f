#pragma once
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/machine/place.hpp"
#include "taut/structure/rod.hpp"

namespace taut::machine {

/// How a beam's end is held by what it ends on. hinged at the start: free to lean any way, held against turning about
/// its axis (a universal joint). hinged at the end: a ball joint.
enum class BeamHold { clamped, hinged };

/// A piece of a beam between two bodies (or the ground): no force acts between but its own weight.
struct BeamPiece {
  structure::RodPiece rod;
  int section_every = 1;  ///< steps of `rod` from one reported section to the next; divides their number
  Place start, end;
  BeamHold start_hold = BeamHold::clamped, end_hold = BeamHold::clamped;
  /// The section as built, in the frames of the body at its start, of the one at its end, and of the body on which the
  /// whole beam begins: the latter carries the geometry as built of a first-order beam.
  Matrix3 start_axes = Matrix3::Identity(), end_axes = Matrix3::Identity(), reference_axes = Matrix3::Identity();
  int reference = ground;
};

/// An elastic beam: pieces one after the other, the sections between them bodies that nothing holds but the beam.
struct Beam {
  std::string name;
  double length = 0;  ///< of its axis as built, m
  Array<BeamPiece> pieces;
};

/// What is unknown of a piece.
struct PieceState {
  Vector3 force = Vector3::Zero();     ///< at its start, of the part above on the part below, N
  Vector3 moment = Vector3::Zero();    ///< there, N m; of a clamped start
  double torque = 0;                   ///< about the axis of a hinged start, N m
  Matrix3 axes = Matrix3::Identity();  ///< of the section at a hinged start
};

}  // namespace taut::machine
