#pragma once
#include "taut/catalogue/section.hpp"

/// Hollow sections by their dimensions: those that no table has, and those whose wall came out thinner than nominal.
namespace taut::structure {

/// Nominal sizes, m. A circular one: height = width = diameter, radii do not count.
struct HollowSizes {
  catalogue::SectionShape shape = catalogue::SectionShape::chs;
  catalogue::Forming forming = catalogue::Forming::hot;
  double height = 0;        ///< H, outer, > 0
  double width = 0;         ///< B, outer, 0 < B <= H
  double wall = 0;          ///< t, 0 < t < B/2
  double outer_radius = 0;  ///< r_o of the corner
  double inner_radius = 0;  ///< r_i; r_o - r_i need not be t: EN 10210-2 computes with r_o = 1.5 t, r_i = 1.0 t
};

/// Those of a section of the catalogue.
HollowSizes sizes_of(const catalogue::SectionRow& row);

/// Properties by the formulas of EN 10210-2 and EN 10219-2, annex B (the ring's for a circular section): A, I, W_el,
/// W_pl, i, I_t (SI), mass with 7850 kg/m3. The name is "CHS 508x16" of the sizes in mm; no standard; trust derived.
/// Sizes that enclose nothing are a ContractViolation.
catalogue::SectionRow hollow_section(const HollowSizes& sizes);

/// The same section with its wall thinner by `share` of it (0 <= share < 1; EN 10210-2: 0.10, of seamless tubes
/// 0.125), outer sizes kept, radii in the old ratio to the wall. Its name says so; mass, standard and trust stay those
/// of the row.
catalogue::SectionRow with_thinner_wall(const catalogue::SectionRow& row, double share);

/// What the middle line of its wall encloses, with its rounded corners, m2: pi (D - t)^2/4; of a box (H - t)(B - t) -
/// (4 - pi) R_c^2, R_c = (r_o + r_i)/2.
double enclosed_area(const catalogue::SectionRow& row);

/// Elastic torsion modulus: M_t/W_t is the largest shear stress, m3. EN 10210-2, annex B: I_t/(D/2); of a box I_t/(t +
/// K/t), K = 2 A_h t/(length of the middle line).
double torsion_modulus(const catalogue::SectionRow& row);

/// Radii that the standards compute with: hot 1.5 t and t; cold 2 t and t (t <= 6 mm), 2.5 t and 1.5 t (t <= 10 mm),
/// 3 t and 2 t above.
HollowSizes with_usual_radii(HollowSizes sizes);

}  // namespace taut::structure
