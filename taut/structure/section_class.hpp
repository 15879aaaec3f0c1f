#pragma once
#include <string>
#include <vector>

#include "taut/calc/num.hpp"
#include "taut/calc/sheet.hpp"
#include "taut/catalogue/section.hpp"

/// Classes of hollow sections, EN 1993-1-1:2005 table 5.2: how much of its plastic resistance a wall lives to see.
namespace taut::structure {

/// Design forces of a cross-section. y is the strong axis: M_y bends along the height and goes with V_z.
struct CrossForces {
  double N = 0;             ///< compression positive, N
  double V_y = 0, V_z = 0;  ///< along the width, along the height, N
  double M_y = 0, M_z = 0;  ///< N m
  double torsion = 0;       ///< N m
};
CrossForces operator*(double factor, const CrossForces& f);
CrossForces operator+(const CrossForces& a, const CrossForces& b);

/// One kind of wall of a section against its limits.
struct WallClass {
  std::string wall;        ///< "tube" (D/t), "web" (walls along the height), "flange" (along the width)
  double slenderness = 0;  ///< D/t, or c/t with c = side - 3 t
  double alpha = 1;        ///< of a box: the part of its flat width that is pressed in the plastic state
  double limit_1 = 0, limit_2 = 0, limit_3 = 0;  ///< largest slenderness of classes 1, 2, 3
  int value = 1;                                 ///< 1 to 4
};

/// 1, 2, 3 or 4 by limits.
int class_of(double slenderness, double limit_1, double limit_2, double limit_3);

/// All kinds of walls of a section of that yield stress (Pa) under these forces, whatever their signs.
///
/// Tubes: D/t <= 50, 70, 90 epsilon^2, epsilon = sqrt(235 MPa/f_y). Walls of boxes, with the part alpha of a wall that
/// is pressed in the plastic state and the ratio psi of the elastic stresses at its ends:
///   1, 2: alpha > 0.5: 396, 456 epsilon/(13 alpha - 1); else 36, 41.5 epsilon/alpha
///   3:    psi > -1: 42 epsilon/(0.67 + 0.33 psi); else 62 epsilon (1 - psi) sqrt(-psi)
/// 33, 38, 42 epsilon where the whole wall is pressed alike; 72, 83, 124 epsilon in plain bending.
///
/// alpha is that of the plastic neutral axis of a thin box, in closed form, under N as it is and M_y, M_z grown in
/// their ratio up to the plastic state; of two like walls the more pressed one counts. Under one moment it is 1 of the
/// wall across and (1 + N/(2 c t f_y))/2 of the walls that bend in their plane, N < 0 in tension. A wall along the
/// neutral axis counts as pressed as a whole. psi is of the forces as they stand.
std::vector<WallClass> wall_classes(const catalogue::SectionRow& r, double yield, const CrossForces& f);

/// The worst of its walls; ties: the nearer one to the next class.
WallClass section_class(const catalogue::SectionRow& r, double yield, const CrossForces& f);

/// The same line by line: epsilon, the slenderness of the wall that governs, its limits.
WallClass write_class(const catalogue::SectionRow& r, double yield, const CrossForces& f, Sheet<Num>& s);

/// Why a section of class 4 is not computed, and what to change; empty for the others.
std::string class_4_words(const catalogue::SectionRow& r, const WallClass& w);

}  // namespace taut::structure
