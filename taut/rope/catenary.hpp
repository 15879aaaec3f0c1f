#pragma once
#include <optional>
#include <string_view>
#include <tl/expected.hpp>

namespace taut::rope {

/// A free rope in its vertical plane. All SI.
struct CatenaryRope {
  double length = 0;     ///< unstretched, m, > 0
  double weight = 0;     ///< per unstretched length, N/m, >= 0
  double stiffness = 0;  ///< EA, N, > 0; infinity for an inextensible rope
};

/// The same rope at a higher temperature, `thermal_strain` = a dT > -1 (a: expansion coefficient, 1/K; dT: rise, K):
/// its unstretched length is L (1 + a dT), its weight per metre w/(1 + a dT), EA is unchanged.
CatenaryRope heated(const CatenaryRope& rope, double thermal_strain);

/// The tension at the middle of the unstretched length, in components: H >= 0 towards the end, V upwards (positive
/// where the rope rises). At the unstretched length s from the start the tension is (H, V + w (s - L/2)). The middle is
/// used because it makes the formulas symmetric: with the ends swapped V becomes -V.
struct CatenaryForce {
  double H = 0;  ///< N
  double V = 0;  ///< N
};

/// Position of the end relative to the start, and its derivatives by the force: the compliance of the rope, a symmetric
/// matrix, positive definite unless H = 0.
struct EndPosition {
  double x = 0;      ///< m
  double z = 0;      ///< m, up
  double dx_dH = 0;  ///< m/N; infinite for a vertical rope that hangs in a loop
  double dx_dV = 0;  ///< m/N, equal to dz/dH
  double dz_dV = 0;  ///< m/N
};

/// x = H (L/EA + I),  I = (1/w) log(1 + 2 w L/(T0 + T1 - w L)),  z = V (L/EA + 2 L/(T0 + T1)), with the tensions T0, T1
/// at the ends: Irvine, Cable Structures (1981), eqs. 1.35, 1.36, rewritten so that no digits are lost from w = 0 to a
/// very slack rope. H >= 0; H = 0: a rope in a vertical line.
EndPosition end_position(const CatenaryRope& rope, const CatenaryForce& force);

/// Derivatives of x and z by the unstretched length (m/m) and by the thermal strain (m), at a constant force in the
/// middle.
struct EndRates {
  double dx_dlength = 0, dz_dlength = 0;
  double dx_dheat = 0, dz_dheat = 0;
};
EndRates end_rates(const CatenaryRope& rope, const CatenaryForce& force);

/// Derivatives of the force in the middle by the position of the end, the length and the temperature. `out_of_plane`:
/// horizontal force normal to the plane of the span, per metre of displacement in that direction, H/x.
struct CatenaryStiffness {
  double dH_dx = 0, dH_dz = 0, dV_dz = 0;  ///< N/m; dV/dx = dH/dz
  double out_of_plane = 0;                 ///< N/m
  double dH_dlength = 0, dV_dlength = 0;   ///< N/m, at constant weight per metre
  double dH_dheat = 0, dV_dheat = 0;       ///< N per unit of additional thermal strain
};
CatenaryStiffness stiffness(const CatenaryRope& rope, const CatenaryForce& force);

/// A solved span: force in the middle and accuracy.
struct CatenarySolution {
  CatenaryForce force;
  double closure = 0;  ///< distance of the computed end from the given one, m
  int iterations = 0;
};

/// Why there is no tension that holds this rope between these ends.
enum class NoCatenary {
  too_short,      ///< an inextensible rope not longer than the chord
  slack,          ///< a weightless rope longer than the chord carries nothing: its shape is not determined
  not_converged,  ///< a failure of the solver; not observed in the tested range
};
/// The reason and what to change, as part of a sentence.
std::string_view to_text(NoCatenary why);

/// The force that holds `rope` between its start and an end at the horizontal distance `x` >= 0 and the height `z`, m.
/// Damped Newton iteration for the minimum of the complementary energy, a convex function of (H, V). The last steps
/// evaluate the residual in extended precision, so that the force is as accurate as the coordinates given, also for a
/// taut and stiff rope, where a rounding error of the chord c is multiplied by EA/T in the tension. With the ends
/// swapped the answer is the same to the last bit.
/// `start`: the force of a similar span; it saves iterations and does not change the answer. Returns NoCatenary where
/// there is no solution.
tl::expected<CatenarySolution, NoCatenary> solve_catenary(const CatenaryRope& rope, double x, double z,
                                                          const std::optional<CatenaryForce>& start = std::nullopt);

}  // namespace taut::rope
