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

/// The same rope warmer by `thermal_strain` = a dT (a: expansion, 1/K): its unstretched length is L (1 + a dT), its
/// weight per metre w/(1 + a dT), EA is unchanged. `thermal_strain` > -1.
CatenaryRope heated(const CatenaryRope& rope, double thermal_strain);

/// The tension at the middle of the unstretched length, as components: H >= 0 towards the end, V upwards (positive: the
/// rope rises there). At the unstretched length s from the start the tension is (H, V + w (s - L/2)). The middle, and
/// not an end, because it makes every formula symmetric: a rope with its ends swapped has V = -V.
struct CatenaryForce {
  double H = 0;  ///< N
  double V = 0;  ///< N
};

/// Where the end of a rope lies, seen from its start, and how that depends on the force: the rope's compliance, a
/// symmetric matrix, positive definite unless H = 0.
struct EndPosition {
  double x = 0;      ///< m
  double z = 0;      ///< m, up
  double dx_dH = 0;  ///< m/N; infinite for a rope that hangs straight down in a loop
  double dx_dV = 0;  ///< m/N, equal to dz/dH
  double dz_dV = 0;  ///< m/N
};

/// x = H (L/EA + I),  I = (1/w) log(1 + 2 w L/(T0 + T1 - w L)),  z = V (L/EA + 2 L/(T0 + T1)), with T0, T1 the tensions
/// at the ends: Irvine, Cable Structures (1981), eqs. 1.35, 1.36, in forms that lose no digits from w = 0 to a very
/// slack rope. H >= 0; H = 0 stands for a rope in a vertical line.
EndPosition end_position(const CatenaryRope& rope, const CatenaryForce& force);

/// x and z alone, in extended precision.
struct ExactEnd {
  long double x = 0, z = 0;
};
ExactEnd exact_end(const CatenaryRope& rope, const CatenaryForce& force);

/// d(x, z)/d(length), and d(x, z)/d(thermal strain), at a constant force in the middle (m/m and m).
struct EndRates {
  double dx_dlength = 0, dz_dlength = 0;
  double dx_dheat = 0, dz_dheat = 0;
};
EndRates end_rates(const CatenaryRope& rope, const CatenaryForce& force);

/// How the force follows the end, the length and the temperature while the rope stays a solution.
/// `out_of_plane`: horizontal force across the span's plane per metre across, H/x.
struct CatenaryStiffness {
  double dH_dx = 0, dH_dz = 0, dV_dz = 0;  ///< N/m; dV/dx = dH/dz
  double out_of_plane = 0;                 ///< N/m
  double dH_dlength = 0, dV_dlength = 0;   ///< N/m, of the force in the middle; weight per metre kept
  double dH_dheat = 0, dV_dheat = 0;       ///< N per unit of thermal strain, from this temperature on
};
CatenaryStiffness stiffness(const CatenaryRope& rope, const CatenaryForce& force);

/// A solved span: force in the middle, and how well it closes.
struct CatenarySolution {
  CatenaryForce force;
  double closure = 0;  ///< distance of the computed end from the given one, m
  int iterations = 0;
};

/// Why no tension holds this rope between these ends.
enum class NoCatenary {
  too_short,      ///< an inextensible rope shorter than the chord, or as long
  slack,          ///< a weightless rope longer than the chord carries nothing: its shape is not determined
  not_converged,  ///< our failure; never seen in the tested range
};
/// What to change, as part of a sentence.
std::string_view to_text(NoCatenary why);

/// The force that holds `rope` between its start and an end `x` >= 0 beside and `z` above (or below) it.
/// A damped Newton iteration for the minimum of the complementary energy, a convex function of (H, V), whose last steps
/// take the residual in extended precision: the force is then as good as the coordinates given, also for a taut stiff
/// rope, where one ulp of the chord c is (EA/T) ulp of the tension. With the ends swapped the answer is the same to the
/// last bit. `start`: a nearby solution; it saves iterations and changes nothing else.
tl::expected<CatenarySolution, NoCatenary> solve_catenary(const CatenaryRope& rope, double x, double z,
                                                          const std::optional<CatenaryForce>& start = std::nullopt);

}  // namespace taut::rope
