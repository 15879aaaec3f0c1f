#include "taut/structure/member.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "taut/base/expects.hpp"

namespace taut::structure {
namespace {

using std::min;

using catalogue::SectionShape;

constexpr const char* annex_b = "EN 1993-1-1, table B.1";

/// One axis: N_cr, slenderness, reduction, n = N/(chi N_Rk/gamma_M1).
template <class T>
struct MemberAxis {
  T lambda, chi, n;
  double N_cr = 0;
};

/// Both axes.
template <class T>
struct MemberAxes {
  MemberAxis<T> y, z;
};

/// What is given of one axis: how the member may buckle about it, and the section's I.
struct GivenAxis {
  const BucklingAxis& buckles;
  double I;  ///< m4
  const char* letter;
};

template <class T>
T critical_force(const Member& m, const GivenAxis& axis, Sheet<T>& s) {
  const auto name = [&](const char* symbol) { return std::string(symbol) + "_" + axis.letter; };
  const BucklingAxis& by = axis.buckles;
  if (by.critical_force || !by.length) {
    return s.named(name("N_cr"), si::N, by.critical_force.value_or(std::numeric_limits<double>::infinity()));
  }
  const T E = s.named("E", si::Pa.in("GPa"), m.steel.E), I_axis = s.named(name("I"), si::m4, axis.I);
  const T L = s.named(name("L_cr"), si::m, *by.length), pi = s.named("pi", si::one, std::numbers::pi);
  return s.eq("", name("N_cr"), si::N, square(pi) * E * I_axis / square(L), "Euler");
}

template <class T>
MemberAxis<T> axis_of(const Member& m, const GivenAxis& given, const T& N, const T& N_Rk, Sheet<T>& s) {
  const Curve curve = m.curve.value_or(curve_of(m.steel.section, m.steel.yield));
  const T N_cr = critical_force(m, given, s);
  const Buckling<T> b = flexural_buckling(N_Rk, N_cr, curve, given.letter, s);
  const T gamma_M1 = s.named("gamma_M1", si::one, m.steel.gamma.M1);
  const T n =
      s.eq("6.46", std::string("n_") + given.letter, si::one, N * gamma_M1 / (b.chi * N_Rk), "EN 1993-1-1, (6.46)");
  return {b.slenderness, b.chi, n, value(N_cr)};
}

/// k_yy or k_zz.
template <class T>
T own_factor(const MemberAxis<T>& a, double C_m, bool plastic, const char* letter, Sheet<T>& s) {
  const T C = s.named(std::string("C_m") + letter, si::one, C_m);
  const std::string k = std::string("k_") + letter + letter;
  if (plastic) {
    return s.eq("", k, si::one, min(C * (1 + (a.lambda - 0.2) * a.n), C * (1 + 0.8 * a.n)), annex_b);
  }
  return s.eq("", k, si::one, min(C * (1 + 0.6 * a.lambda * a.n), C * (1 + 0.6 * a.n)), annex_b);
}

/// Moments over their resistances.
template <class T>
T share(const Member& m, double M, double W, const char* letter, bool plastic, Sheet<T>& s) {
  const std::string axis(letter);
  const T W_axis = s.named((plastic ? "W_pl_" : "W_el_") + axis, si::m3, W);
  const T gamma_M1 = s.named("gamma_M1", si::one, m.steel.gamma.M1), f_y = s.named("f_y", si::Pa, m.steel.yield);
  return s.eq("", "m_" + axis, si::one, s.named("M_" + axis + "_Ed", si::N_m, std::abs(M)) * gamma_M1 / (W_axis * f_y),
              "EN 1993-1-1, 6.3.3 (4): M_Ed gamma_M1/(W f_y)");
}

template <class T>
void round_member(const Member& m, const MemberAxes<T>& axes, const CrossForces& f, bool plastic, MemberUse& u,
                  Sheet<T>& s) {
  const auto& r = m.steel.section;
  const auto& [y, z] = axes;
  const bool by_y = value(y.n) >= value(z.n);  // one section, two ways to be held
  const T k = own_factor(by_y ? y : z, std::max(m.y.C_m, m.z.C_m), plastic, by_y ? "y" : "z", s);
  const T M = share(m, std::hypot(f.M_y, f.M_z), plastic ? r.W_pl_y : r.W_el_y, by_y ? "y" : "z", plastic, s);
  u.k_yy = u.k_zz = value(k);
  u.eq_6_61 = u.eq_6_62 = value(
      s.eq("6.61", "eta_member", si::one, (by_y ? y : z).n + k * M, "EN 1993-1-1, (6.61), resultant moment of a tube"));
}

template <class T>
void box_member(const Member& m, const MemberAxes<T>& axes, const CrossForces& f, bool plastic, MemberUse& u,
                Sheet<T>& s) {
  const auto& r = m.steel.section;
  const auto& [y, z] = axes;
  const T k_yy = own_factor(y, m.y.C_m, plastic, "y", s), k_zz = own_factor(z, m.z.C_m, plastic, "z", s);
  const T k_yz = s.eq("", "k_yz", si::one, plastic ? 0.6 * k_zz : 1 * k_zz, annex_b);
  const T k_zy = s.eq("", "k_zy", si::one, plastic ? 0.6 * k_yy : 0.8 * k_yy, annex_b);
  const T M_y = share(m, f.M_y, plastic ? r.W_pl_y : r.W_el_y, "y", plastic, s);
  const T M_z = share(m, f.M_z, plastic ? r.W_pl_z : r.W_el_z, "z", plastic, s);
  u.k_yy = value(k_yy);
  u.k_zz = value(k_zz);
  u.k_yz = value(k_yz);
  u.k_zy = value(k_zy);
  u.eq_6_61 = value(s.eq("6.61", "eta_6.61", si::one, y.n + k_yy * M_y + k_yz * M_z, "EN 1993-1-1, (6.61)"));
  u.eq_6_62 = value(s.eq("6.62", "eta_6.62", si::one, z.n + k_zy * M_y + k_zz * M_z, "EN 1993-1-1, (6.62)"));
}

}  // namespace

double MemberUse::worst() const { return std::max({flexural, eq_6_61, eq_6_62}); }

double c_m_of(double psi) {
  expects(psi >= -1 && psi <= 1, "psi is the smaller over the larger end moment");
  return std::max(0.6 + 0.4 * psi, 0.4);
}

std::optional<double> buckling_factor(bool clamped_base, bool held_top) {
  if (clamped_base) return held_top ? 0.7 : 2.0;
  if (held_top) return 1.0;
  return std::nullopt;
}

bool is_pressed(const SteelSection& steel, const CrossForces& f) {
  return f.N > 1e-9 * steel.section.area * steel.yield;
}

template <class T>
MemberUse member_use(const Member& m, const CrossForces& f, Sheet<T>& s) {
  MemberUse u;
  if (!is_pressed(m.steel, f)) return u;
  const auto& r = m.steel.section;
  const int section_class = structure::section_class(r, m.steel.yield, f).value;
  expects(section_class < 4, "a section of class 4 is refused before its member is asked for");
  const T N_Rk = s.eq("", "N_Rk", si::N, s.named("A", si::m2, r.area) * s.named("f_y", si::Pa, m.steel.yield),
                      "EN 1993-1-1, table 6.7");
  const T N = s.named("N_Ed", si::N, f.N);
  const bool alike =
      r.shape == SectionShape::chs && m.y.length == m.z.length && m.y.critical_force == m.z.critical_force;
  const MemberAxis<T> y = axis_of(m, {m.y, r.I_y, "y"}, N, N_Rk, s);
  const MemberAxes<T> axes{y, alike ? y : axis_of(m, {m.z, r.I_z, "z"}, N, N_Rk, s)};
  const MemberAxis<T>& z = axes.z;
  u.N_cr_y = y.N_cr;
  u.N_cr_z = z.N_cr;
  u.lambda_y = value(y.lambda);
  u.lambda_z = value(z.lambda);
  u.chi_y = value(y.chi);
  u.chi_z = value(z.chi);
  u.flexural = std::max(value(y.n), value(z.n));
  if (r.shape == SectionShape::chs) {
    round_member(m, axes, f, section_class < 3, u, s);
  } else {
    box_member(m, axes, f, section_class < 3, u, s);
  }
  return u;
}

template MemberUse member_use(const Member&, const CrossForces&, Sheet<double>&);
template MemberUse member_use(const Member&, const CrossForces&, Sheet<Num>&);

}  // namespace taut::structure
