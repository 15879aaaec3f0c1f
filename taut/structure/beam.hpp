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

/// Elastic shear stress in a wall of a box that runs along a force, over that force, 1/m2.
struct WallShear {
  double corner = 0;  ///< at its ends, and from there linearly to 0 in the middle of the walls across the force
  double middle = 0;  ///< the largest
};

/// Which fibre a section's bending moments stress most. `tube`: they add as vectors. `box`: their stresses add, in a
/// corner. `unsaid`: one modulus for all directions, of a tube or of a box that stands anyhow; stresses are those of
/// the tube, and the corner of a box may have up to sqrt(2) of their bending.
enum class Outline { box, tube, unsaid };

/// Properties of a beam section. x, y: axes of the section towards which it bends; EI_x resists bending towards x.
struct BeamSection {
  double area = 0;    ///< m2
  double EA = 0;      ///< N
  double EI_x = 0;    ///< N m2, bending in the plane x-z
  double EI_y = 0;    ///< N m2, bending in the plane y-z
  double GJ = 0;      ///< N m2, torsion
  double W_x = 0;     ///< elastic modulus for bending in the plane x-z, m3
  double W_y = 0;     ///< m3
  double W_t = 0;     ///< elastic torsion modulus, M_t/W_t is the largest shear stress, m3; 0: not known
  WallShear shear_x;  ///< of a force along x; 0: not known
  WallShear shear_y;  ///< along y
  double weight = 0;  ///< own weight per metre, N/m
  Outline outline = Outline::box;
};

/// Properties of a catalogue section whose strong axis y-y takes the bending towards x. Its own weight is not included:
/// set `weight`.
BeamSection beam_section(const catalogue::SectionRow& row, const Elasticity& steel = {});

/// Of a round section, over a force in any direction: 2/A of a thin tube, which no round section exceeds. A, m2.
WallShear round_shear(double area);

/// A tube of outer diameter D and wall t, m.
BeamSection tube_section(double diameter, double wall, const Elasticity& steel = {});

/// Axial force (tension positive), shear along x and y of the section, moments of bending towards x and y, torsion.
struct SectionForces {
  double axial = 0, shear_x = 0, shear_y = 0;          ///< N
  double bends_to_x = 0, bends_to_y = 0, torsion = 0;  ///< N m
};

/// The stresses of one point of a section, Pa, not negative.
struct PointStress {
  double sigma = 0;           ///< along the axis
  double tau = 0;             ///< shear
  double equivalent() const;  ///< sqrt(sigma^2 + 3 tau^2), von Mises, EN 1993-1-1, (6.1)
};

/// The point of the largest equivalent stress (EN 1993-1-1, 6.2.1 (5), gamma_M0 = 1), all signs taken as adding up.
///
/// Tube and `unsaid`, at the angle f from the fibre that bending stresses most: sigma = |N|/A + M/W cos f, tau =
/// |M_t|/W_t + 2/A (V_along sin f + V_across cos f), V_along in the plane of the bending. Box, along one of its walls
/// from a corner (f = 0) to the middle (90 deg): sigma = |N|/A + M_a/W_a + M_w/W_w cos f with M_w in the plane of the
/// wall; tau = |M_t|/W_t + V_w (corner + (middle - corner) sin f) + V_a corner_a cos f, which bounds its parabola and
/// is exact at both ends. Where W_t or the shear is not known its stress is left out.
PointStress most_stressed_point(const BeamSection& section, const SectionForces& f);

/// Its equivalent stress, Pa.
double largest_stress(const BeamSection& section, const SectionForces& f);

/// The same with the corner of a box that stands at its worst, where the outline is not said, Pa.
double largest_stress_in_corner(const BeamSection& section, const SectionForces& f);

/// Whether W_t is not known and a torsion counts beside the other stresses: as much of it as a double tells, were W_t
/// no larger than W.
bool leaves_out_torsion(const BeamSection& section, const SectionForces& f);

}  // namespace taut::structure
