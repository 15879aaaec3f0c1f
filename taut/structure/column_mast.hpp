#pragma once
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "taut/base/gravity.hpp"
#include "taut/structure/column.hpp"
#include "taut/structure/mast.hpp"

/// A mast under forces that are given: cantilever, hinged or held at its top, prismatic, stepped or tapered. All SI.
namespace taut::structure {

/// From the top of the piece below to its own. Tapered: `top` has the section of its upper end, the sizes between run
/// linearly.
struct MastPiece {
  double length = 0;  ///< m
  catalogue::SectionRow section;
  std::optional<catalogue::SectionRow> top;
  double yield = 0;                        ///< f_y of its wall, Pa
  std::optional<double> allowable_stress;  ///< [sigma], Pa
};

/// Forces on a mast at one height: down, across in the plane of the strong axis (with M_y) and in that of the weak one.
struct MastLoad {
  double height = 0;                  ///< above the base, m; within the mast
  double down = 0;                    ///< N
  double across_y = 0, across_z = 0;  ///< bending about y (along the sections' height), about z, N
  double moment_y = 0, moment_z = 0;  ///< bending as across_y, across_z do, N m
  double torsion = 0;                 ///< about the mast's axis, upwards positive, N m
};

/// Loads that come together, each set times its factor.
struct MastCombination {
  std::string words;
  std::vector<MastLoad> loads;  ///< as they are
  std::vector<double> factors;  ///< of each load: partial factor times dynamic factor
  double weight_factor = 1;     ///< of its own weight: partial factor
};

struct ColumnMast {
  std::vector<MastPiece> pieces;  ///< from the base
  bool clamped_base = true;
  double top_stiffness = 0;  ///< of guys, both ways, N/m; infinite: the top does not move
  bool own_weight = false;   ///< each piece's mass times gravity, with the combination's `weight_factor`
  double gravity = standard_gravity;
  double E = 210e9;
  PartialFactors gamma;
  std::optional<Curve> curve;
  std::optional<double> sway;  ///< as built, pressed or not; else EN 1993-1-1, (5.5), where any part is pressed
  std::optional<double> bow;   ///< share of the buckling length; else table 5.1 where (5.8) asks for it
  double C_m = 0.9;
  std::vector<MastCombination> combinations;
};

/// The mast and its cases: sections under forces in the bent shape with the imperfections, in the direction that is
/// worse for each plane, members under those of first order, both with factors; stresses under those of first order
/// without. Its foot holds the torsion; what forces beside the bent axis add to it is left out. A tapered piece becomes
/// 8 parts, each with the section of its weaker end. Buckling lengths of stepped masts from the column's own critical
/// load. `refused`: a combination under which the column buckles.
struct ColumnMastResult {
  Mast mast;
  std::vector<MastCase> cases;
  std::string refused;
  double critical_factor = std::numeric_limits<double>::infinity();  ///< the least over the combinations, as factored
  double sway = 0, bow = 0;                                          ///< as taken (the bow of the worst combination, m)
  bool pressed = false;         ///< somewhere, under some combination; else there is no buckling length, and no bow
  double top_displacement = 0;  ///< the largest, m
};
ColumnMastResult column_mast(const ColumnMast& given);

}  // namespace taut::structure
