#pragma once
#include <limits>
#include <optional>

#include "taut/structure/cross_section.hpp"

/// Members under axial force and bending, EN 1993-1-1:2005, 6.3.3 by annex B (method 2). Hollow sections: no
/// lateral-torsional buckling. All SI.
namespace taut::structure {

/// How a member may buckle, bending about one axis.
struct BucklingAxis {
  std::optional<double> length;  ///< buckling length, m; or
  std::optional<double>
      critical_force;  ///< N_cr, N, from a solution of the whole structure; neither: it does not buckle
  double C_m = 0.9;    ///< factor of the moments' shape: 0.9 where the ends sway, else c_m_of
};

/// C_m of table B.3 for end moments M and psi M (-1 <= psi <= 1): 0.6 + 0.4 psi >= 0.4.
double c_m_of(double psi);

/// Buckling lengths over the column's own, of ideal ends: 2 clamped cantilever, 0.7 clamped with its top held, 1 hinged
/// with its top held. A hinged column with a free top has none: it falls over.
std::optional<double> buckling_factor(bool clamped_base, bool held_top);

struct Member {
  SteelSection steel;
  BucklingAxis y, z;           ///< bending about the strong axis, about the weak one
  std::optional<Curve> curve;  ///< else that of the section
};

/// What a member holds against buckling.
struct MemberUse {
  double N_cr_y = 0, N_cr_z = 0, lambda_y = 0, lambda_z = 0, chi_y = 1, chi_z = 1;
  double k_yy = 0, k_yz = 0, k_zy = 0, k_zz = 0;
  double flexural = 0;  ///< N/(chi A f_y/gamma_M1), the larger (6.46)
  double eq_6_61 = 0, eq_6_62 = 0;
  double worst() const;  ///< of the two equations; they contain the first one
};

/// Whether the axial force presses it, by more than rounding: 1e-9 of A f_y.
bool is_pressed(const SteelSection& steel, const CrossForces& f);

/// (6.46), (6.61) and (6.62) with N and the largest moments along the member, whatever their signs. Where it is not
/// pressed all is 0: the sections decide.
///
/// k_yy = C_my (1 + (lambda_y - 0.2) n_y) <= C_my (1 + 0.8 n_y), n_y = N/(chi_y A f_y/gamma_M1), k_zz likewise with z,
/// k_yz = 0.6 k_zz, k_zy = 0.6 k_yy (classes 1, 2); k_yy = C_my (1 + 0.6 lambda_y n_y) <= C_my (1 + 0.6 n_y), k_yz =
/// k_zz, k_zy = 0.8 k_yy (class 3); table B.1, hollow sections. M_Rk = W_pl f_y or W_el f_y. A tube has no axes: its
/// resultant moment enters with the smaller chi and the larger k, and both equations are one. Class 4 is a
/// ContractViolation.
template <class T>
MemberUse member_use(const Member& m, const CrossForces& f, Sheet<T>& s);

}  // namespace taut::structure
