#pragma once
#include <algorithm>

#include "taut/structure/buckling.hpp"
#include "taut/structure/section_class.hpp"

/// Resistance of a hollow section to axial force, two bending moments, shear and torsion together, EN 1993-1-1:2005,
/// 6.2. Classes 1 to 3; class 4 is refused before. All SI.
namespace taut::structure {

/// EN 1993-1-1, 6.1; values of the national annex. Loads' factors are not here: they belong to the forces.
struct PartialFactors {
  double M0 = 1;  ///< resistance of sections
  double M1 = 1;  ///< resistance of members to buckling
};

/// A section in its steel.
struct SteelSection {
  catalogue::SectionRow section;  ///< with the wall that counts
  double yield = 0;               ///< f_y at its wall, Pa
  double E = 210e9;               ///< Pa
  PartialFactors gamma;
};

/// What a cross-section holds under given forces, and how much of it they take.
struct CrossSectionUse {
  int section_class = 1;
  double N_pl = 0;                ///< A f_y/gamma_M0, N
  double M_y_Rd = 0, M_z_Rd = 0;  ///< plastic (1, 2) or elastic (3), less what torsion and a large shear take, N m
  double V_y_Rd = 0, V_z_Rd = 0;  ///< plastic, less what torsion takes, N
  double n = 0;                   ///< |N| over N_pl, the latter less what torsion and a large shear take
  double M_Ny = 0, M_Nz = 0;      ///< of classes 1, 2: what is left beside N
  double shear = 0;               ///< V/V_Rd, the larger; with torsion beyond its resistance infinite
  double T_Rd = 0;                ///< of the wall in pure torsion, N m
  double torsion = 0;             ///< |T|/T_Rd
  double utilisation = 0;         ///< N, M, V and T together: of all conditions that apply the largest; passes at 1

  double worst() const { return std::max({shear, torsion, utilisation}); }
};

/// Whether a torsion of this share of T_Rd takes anything from the other resistances that a double tells.
bool counts_torsion(double share);

/// N + M + V + torsion of one cross-section.
///
/// Torsion: T/T_Rd <= 1 (6.23), T_Rd = W_t f_y/(sqrt(3) gamma_M0), W_t = 2 A_m t (Bredt) of classes 1 and 2, the
/// elastic modulus of class 3. Its shear stress is the same all around the wall, which keeps f_y sqrt(1 - (T/T_Rd)^2)
/// for N, M (6.1): that strength stands for f_y below. By the static theorem a distribution of stresses in it is safe.
/// Shear: V_Rd = A_v f_y/(sqrt(3) gamma_M0), A_v = 2A/pi of a tube for any direction, A h/(b + h) along the height and
/// A b/(b + h) along the width of a box; torsion leaves 1 - T/T_Rd of it (6.28), of the full f_y.
/// Above half of V_Rd the shear area has (1 - rho) f_y, rho = (2 V/V_Rd - 1)^2: of a box M_pl loses rho A_v^2/(8 t)
/// f_y and N_pl rho A_v f_y; of a tube, and of class 3, all of the section takes (1 - rho) f_y, which is safe.
/// Classes 1 and 2: tube M_N = M_pl (1 - n^1.7) for the resultant moment; box (6.39), (6.40) and, about both axes,
/// (6.41) with the exponent 1.66/(1 - 1.13 n^2) <= 6. Class 3: N/A + M_y/W_el,y + M_z/W_el,z <= f_y/gamma_M0 (of a tube
/// with the resultant moment). Written once for double and Num; a section of class 4 is a ContractViolation.
template <class T>
CrossSectionUse cross_section(const SteelSection& m, const CrossForces& f, Sheet<T>& s);

/// The mast paper's condition |N|/A + M/W_el of the most stressed fibre, Pa; of a box both moments, corners as sharp.
/// With torsion its equivalent stress, sqrt(sigma^2 + 3 (M_t/W_t)^2), of which the paper has none.
double elastic_stress(const catalogue::SectionRow& r, const CrossForces& f);

}  // namespace taut::structure
