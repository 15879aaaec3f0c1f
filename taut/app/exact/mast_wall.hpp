#pragma once
#include "taut/calc/result.hpp"
#include "taut/methods/mast_section/run.hpp"
#include "taut/structure/section_class.hpp"

/// The walls of the section of a `mast_section` deck: whether they yield before they buckle.
namespace taut::app {

/// The wall of a section under forces at the clamp. Of a mast that is not the method's cantilever the moment is not
/// known there: pressed alike, as that leaves a wall the least.
structure::WallClass wall_of(const mast_section::Input& in, const catalogue::SectionRow& section, double yield,
                             const mast_section::ClampForces& f);

/// A wall that buckles before it yields fails: the method's stress limit does not know of it. With [sigma] alone the
/// yield stress is not known, other than that it is no less: the class is judged where it is the same for all steels.
/// Precondition: there is a section.
void check_wall(const mast_section::Input& in, const mast_section::Solved& method, Result& r);

}  // namespace taut::app
