#pragma once
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/machine/model.hpp"

namespace taut::machine {

/// What holds the far end of a beam: nothing but what it carries, or the place where it ends.
enum class BeamTop { free, clamped, hinged };

/// A straight beam from one place to another, before it is cut into pieces.
struct StraightBeam {
  std::string name;
  Place from, to;  ///< of a free top: where it is before anything acts
  structure::BeamSection section;
  Vector3 strong = Vector3::UnitX();  ///< bending towards it is resisted by EI_x; what of it is across the axis counts
  structure::BeamOrder order = structure::BeamOrder::second;
  BeamHold base = BeamHold::clamped;
  BeamTop top = BeamTop::free;
  int elements = 16;
  double bow = 0;                    ///< e/L of a half wave of sine, free of stress
  double sway = 0;                   ///< inclination of the whole beam as built, tan; of a free top
  Vector3 sense = Vector3::UnitX();  ///< of bow and sway; what of it is across the axis counts
  double thermal_strain = 0;         ///< structure::RodPiece; places are given without it
  /// Where it is cut, as `cuts_of` has them: where something is fixed to it. Shares of its length in (0, 1), growing.
  Array<double> stations = {};
};

/// The stations at which the beam is cut: those given, and more where a piece would be so slender that forces up to its
/// strength decay along it (exp(l sqrt(N/EI)) below 1e3). Shares in (0, 1), growing.
Array<double> cuts_of(const StraightBeam& beam, double length);

/// Adds the beam and a body, free in all ways, for each cut and for its free top (the last, "NAME.top"). Bodies named
/// by its ends are there already, where they stand as built. The bodies' origins lie on the axis as built, their axes
/// are those of the ground frame.
void add_beam(Model& model, const StraightBeam& beam);

/// Moves the sections of all beams to where they are at their temperature before anything acts: guys are put up there.
/// What stands on a beam by a body of the deck stays where that is.
void warm_beams(Model& model);

}  // namespace taut::machine
