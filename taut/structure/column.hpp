#pragma once
#include <functional>
#include <optional>
#include <vector>

/// A column of pieces (stepped, tapered) under axial forces, in its bent shape: small rotations, one plane. For the
/// machine with its ropes and any rotation see rod.hpp. All SI; x from the base upwards, w across.
namespace taut::structure {

/// From the top of the piece below to its own top. A taper runs linearly in E I.
struct ColumnPiece {
  double length = 0;             ///< m, > 0
  double EI = 0;                 ///< at its lower end, N m2, > 0
  std::optional<double> EI_top;  ///< at its upper end; else the same
  double weight = 0;             ///< per metre, N/m
};

/// At the top of a piece: force downwards and across, moment that bends as the force across does.
struct ColumnLoad {
  std::size_t piece = 0;
  double down = 0, across = 0, moment = 0;  ///< N, N, N m
};

struct Column {
  std::vector<ColumnPiece> pieces;
  std::vector<ColumnLoad> loads;
  bool clamped_base = true;  ///< else hinged
  double top_stiffness = 0;  ///< across, of what holds the top (guys), N/m; infinite: it does not move
  double sway = 0;           ///< inclination as built, towards positive w
  double bow = 0;            ///< largest offset of a half wave of sine over the height as built, m; of a column with a
                             ///< free top a quarter wave with this offset at its top
  double height() const;
};

/// A cross-section of the loaded column: from the base, N compression positive; w from where it was built; V along w
/// and M = E I w'' as the forces across above cause them.
struct ColumnPoint {
  double x = 0, w = 0, turn = 0;
  double N = 0, V = 0, M = 0;
};

/// Second order, all loads times `factor`. Empty: not stable under the axial forces (from 1.0 critical factors on).
std::optional<std::vector<ColumnPoint>> bent_shape(const Column& column, double factor = 1);

/// What all axial forces may be multiplied with before the column buckles, alpha_cr; infinite: nothing presses it. 0:
/// it stands on a hinge and nothing holds its top.
double critical_factor(const Column& column);

/// Length of the hinged prismatic column of bending stiffness EI that buckles at the same axial force, where `N` is the
/// present one: pi sqrt(EI/(alpha_cr N)).
double buckling_length(double EI, double critical_factor, double N);

}  // namespace taut::structure
