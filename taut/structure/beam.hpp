#pragma once
#include "taut/catalogue/section.hpp"
#include "taut/math/vector.hpp"

/// Elastic beams, geometrically exact: valid for rotations of any size. All SI, z up.
namespace taut::structure {

/// Elastic moduli of structural steel, Pa (EN 1993-1-1, 3.2.6: E 210 GPa, nu 0.3).
struct Elasticity {
  double E = 210e9;
  double G = 210e9 / 2.6;
};

/// Properties of a beam section. x, y: axes of the section towards which it bends; EI_x resists bending towards x.
struct BeamSection {
  double area = 0;     ///< m2
  double EA = 0;       ///< N
  double EI_x = 0;     ///< N m2, bending in the plane x-z
  double EI_y = 0;     ///< N m2, bending in the plane y-z
  double GJ = 0;       ///< N m2, torsion
  double W_x = 0;      ///< elastic modulus for bending in the plane x-z, m3
  double W_y = 0;      ///< m3
  double weight = 0;   ///< own weight per metre, N/m
  bool round = false;  ///< a tube: both bending moments add as vectors; false: stresses add in the corner fibre
};

/// Properties of a catalogue section whose strong axis y-y takes the bending towards x. Its own weight is not included:
/// set `weight`.
BeamSection beam_section(const catalogue::SectionRow& row, const Elasticity& steel = {});

/// A tube of outer diameter D and wall t, m.
BeamSection tube_section(double diameter, double wall, const Elasticity& steel = {});

/// The largest |N|/A + M/W, Pa. Of a box M/W is |M_x|/W_x + |M_y|/W_y, with sharp corners. `axial` N; moments for
/// bending towards x and y, N m.
double largest_stress(const BeamSection& section, double axial, double bends_to_x, double bends_to_y);

/// Axial force (tension positive), shear along x and y of the section, moments of bending towards x and y, torsion.
struct SectionForces {
  double axial = 0, shear_x = 0, shear_y = 0;          ///< N
  double bends_to_x = 0, bends_to_y = 0, torsion = 0;  ///< N m
};

}  // namespace taut::structure
