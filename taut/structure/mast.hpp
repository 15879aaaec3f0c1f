#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/structure/member.hpp"

/// A mast or strut under its load cases: the worst section along its height and the member as a whole, by EN 1993-1-1,
/// and the same forces by an allowable stress. All SI.
namespace taut::structure {

/// One cross-section of a mast.
struct MastStation {
  double height = 0;     ///< along the axis from its base, m
  std::size_t part = 0;  ///< of the mast's parts
  CrossForces service;   ///< without any factor, for an allowable stress
  CrossForces design;    ///< with factors, in the bent shape where that is known, for the section
  CrossForces member;    ///< with factors, for (6.61), which magnifies moments itself
};

/// N_cr of a part that bends about its strong and about its weak axis, N.
struct CriticalForces {
  double y = 0, z = 0;
};

/// One state of the mast.
struct MastCase {
  std::string words;  ///< "at rest", "load path, in, x = 40 m"
  std::vector<MastStation> stations;
  /// N_cr of the whole structure in this state, as the axial force of each part, N; empty: the lengths in the parts'
  /// members count.
  std::vector<CriticalForces> critical_force;
  /// Whether members are checked by (6.61) and (6.62) too: not needed where sections are under forces of second order
  /// with sway and bow as built in the worst direction, EN 1993-1-1, 5.2.2 (7) a.
  bool members = true;
};

/// One prismatic part: its own section, or a piece of a tapered one.
struct MastPart {
  Member member;
  std::optional<double> allowable_stress;             ///< [sigma], Pa
  std::optional<catalogue::SectionRow> stronger_end;  ///< of a tapered piece; its walls may be the more slender ones
};

struct Mast {
  std::vector<MastPart> parts;
};

/// Where something is worst: indices into cases and stations (of a member: of its case and part).
struct MastPlace {
  std::size_t load_case = 0, station = 0, part = 0;
};

/// One utilisation and where it is.
struct MastWorst {
  double value = 0;
  MastPlace at;
};

/// What the checks of a mast find. A station whose section is of class 4 ends it: `refused` says why and what to
/// change.
struct MastUse {
  std::string refused;
  MastWorst slenderness;  ///< of walls over the limit of class 3
  WallClass slenderest;   ///< that wall, and the section it is of
  std::string slenderest_section;
  MastWorst section;  ///< N + M + V + T
  MastWorst shear;
  MastWorst torsion;     ///< T/T_Rd
  MastWorst flexural;    ///< (6.46)
  MastWorst member;      ///< (6.61), (6.62)
  MastWorst stress;      ///< elastic_stress: |N|/A + M/W and torsion, Pa, without factors
  MastWorst stress_use;  ///< over [sigma]; 0 without one
  bool pressed = false;  ///< in any case
  /// The largest of what decides: EN 1993-1-1, and [sigma] where it is given; infinite where refused.
  double utilisation() const;
};

/// All cases, stations and parts, of a tapered part both ends. Expects at least one case with a station.
MastUse mast_use(const Mast& mast, const std::vector<MastCase>& cases);

/// What (6.61) takes of a part (with those beside it in the same section, which are one member) in a case: the largest
/// compression and the largest moments, of a tube the largest resultant (as M_y).
CrossForces member_forces(const Mast& mast, const MastCase& c, std::size_t part);

/// The member of a part in a case: with the case's critical force where it has one.
Member member_in(const Mast& mast, const MastCase& c, std::size_t part);

}  // namespace taut::structure
