#include "taut/structure/cross_section.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "taut/base/expects.hpp"
#include "taut/structure/hollow_section.hpp"

namespace taut::structure {
namespace {

using std::max;
using std::min;
using std::sqrt;

using catalogue::SectionRow;
using catalogue::SectionShape;

double to_power(double x, double exponent) { return std::pow(x, exponent); }
Num to_power(const Num& x, double exponent) {
  const double v = std::pow(x.value(), exponent);
  return {v, {}, make_node(Op::power, {x.formula(), make_number(exponent)}, v)};
}
Num to_power(const Num& x, const Num& exponent) {
  const double v = std::pow(x.value(), exponent.value());
  return {v, {}, make_node(Op::power, {x.formula(), exponent.formula()}, v)};
}

/// The quantities of a section that all conditions share. `f`: what torsion leaves of f_y for N and M.
template <class T>
struct Shared {
  T A, f_y, f, gamma_M0, h, b, t;
  bool round = false, plastic = true;
};

template <class T>
Shared<T> shared_of(const SteelSection& m, int section_class, Sheet<T>& s) {
  const SectionRow& r = m.section;
  const T A = s.named("A", si::m2, r.area), f_y = s.named("f_y", si::Pa, m.yield);
  return {A,
          f_y,
          f_y,
          s.named("gamma_M0", si::one, m.gamma.M0),
          s.named("h", si::m.in("mm"), r.height),
          s.named("b", si::m.in("mm"), r.width),
          s.named("t", si::m.in("mm"), r.thickness),
          r.shape == SectionShape::chs,
          section_class < 3};
}

/// Shear area, what is left of its resistance beside torsion, and how far a large shear weakens the section.
template <class T>
struct Shear {
  T A_v, rho;
  double V_Rd = 0, use = 0;
};

/// T over T_Rd, and what it leaves of f_y; empty where it leaves all of it to the last digit.
template <class T>
std::optional<T> torsion_share(Shared<T>& q, const SectionRow& r, double torsion, CrossSectionUse& u, Sheet<T>& s) {
  const double modulus = q.plastic ? 2 * enclosed_area(r) * r.thickness : torsion_modulus(r);
  u.T_Rd = modulus * value(q.f_y) / std::numbers::sqrt3 / value(q.gamma_M0);
  u.torsion = std::abs(torsion) / u.T_Rd;
  if (!counts_torsion(u.torsion)) return std::nullopt;
  const T W_t = s.named("W_t", si::m3, modulus), M_t = s.named("T_Ed", si::N_m, std::abs(torsion));
  const T T_Rd = s.eq("6.23", "T_Rd", si::N_m, W_t * q.f_y / sqrt(T(3.0)) / q.gamma_M0,
                      q.plastic ? "EN 1993-1-1, 6.2.7; W_t = 2 A_m t by Bredt" : "EN 1993-1-1, 6.2.7; W_t elastic");
  T eta = s.eq("6.23", "eta_T", si::one, M_t / T_Rd, "EN 1993-1-1, (6.23)");
  q.f = s.eq("6.1", "f_T", si::Pa, q.f_y * sqrt(max(1 - square(eta), T(0.0))),
             "EN 1993-1-1, (6.1): what the shear of torsion leaves to N and M");
  return eta;
}

template <class T>
Shear<T> shear_along(const Shared<T>& q, char along, double V_Ed, const std::optional<T>& torsion, Sheet<T>& s) {
  const std::string axis(1, along);
  const auto name = [&](const char* symbol) { return std::string(symbol) + "_" + axis; };
  const T A_v =
      q.round
          ? s.eq("", "A_v", si::m2, 2 * q.A / s.named("pi", si::one, std::numbers::pi), "EN 1993-1-1, 6.2.6 (3) g")
          : s.eq("", name("A_v"), si::m2, q.A * (along == 'z' ? q.h : q.b) / (q.b + q.h), "EN 1993-1-1, 6.2.6 (3) f");
  T V_Rd = s.eq("6.18", name("V_pl"), si::N, A_v * (q.f_y / sqrt(T(3.0))) / q.gamma_M0, "EN 1993-1-1, (6.18)");
  if (torsion) {
    V_Rd = s.eq("6.28", name("V_T"), si::N, max(T(1.0) - *torsion, T(0.0)) * V_Rd, "EN 1993-1-1, (6.28)");
  }
  const double left = value(V_Rd);
  Shear<T> shear{A_v, T(0.0), left, 0};
  shear.use = left > 0 ? V_Ed / left : std::numeric_limits<double>::infinity();
  if (shear.use <= 0.5) return shear;
  const T V = s.named(name("V_Ed"), si::N, V_Ed);
  shear.rho = left > 0
                  ? s.eq("6.29", name("rho"), si::one, min(square(2 * V / V_Rd - 1), T(1.0)), "EN 1993-1-1, 6.2.8 (3)")
                  : T(1.0);
  return shear;
}

/// M_Rd about one axis; `shear` acts along the walls that carry this moment.
template <class T>
T bending(const Shared<T>& q, char about, double W_pl, double W_el, const Shear<T>& shear, Sheet<T>& s) {
  const std::string axis(1, about);
  const T W = q.plastic ? s.named("W_pl_" + axis, si::m3, W_pl) : s.named("W_el_" + axis, si::m3, W_el);
  const char* clause = q.plastic ? "EN 1993-1-1, (6.13)" : "EN 1993-1-1, (6.14)";
  const std::string name = "M_" + axis + "_Rd";
  if (value(shear.rho) == 0) return s.eq(q.plastic ? "6.13" : "6.14", name, si::N_m, W * q.f / q.gamma_M0, clause);
  if (q.round || !q.plastic) {
    return s.eq("", name, si::N_m, (1 - shear.rho) * W * q.f / q.gamma_M0, "EN 1993-1-1, 6.2.8 (3), on all of it");
  }
  return s.eq("", name, si::N_m, (W - shear.rho * square(shear.A_v) / (8 * q.t)) * q.f / q.gamma_M0,
              "EN 1993-1-1, 6.2.8 (3), on the shear area");
}

/// N_pl less what shears take.
template <class T>
T axial(const Shared<T>& q, const Shear<T>& y, const Shear<T>& z, Sheet<T>& s) {
  if (value(y.rho) == 0 && value(z.rho) == 0) {
    return s.eq("6.10", "N_pl", si::N, q.A * q.f / q.gamma_M0, "EN 1993-1-1, (6.10)");
  }
  if (q.round || !q.plastic) {
    return s.eq("", "N_V", si::N, (1 - max(y.rho, z.rho)) * q.A * q.f / q.gamma_M0,
                "EN 1993-1-1, 6.2.10 (3), on all of it");
  }
  return s.eq("", "N_V", si::N, (q.A - y.rho * y.A_v - z.rho * z.A_v) * q.f / q.gamma_M0,
              "EN 1993-1-1, 6.2.10 (3), on the shear areas");
}

constexpr double no_resistance = std::numeric_limits<double>::infinity();

/// Classes 1, 2: a tube under the resultant moment.
template <class T>
double round_plastic(const T& M_Rd, const T& n, double M_Ed, CrossSectionUse& u, Sheet<T>& s) {
  const T M_N =
      s.eq("", "M_N", si::N_m, M_Rd * (1 - to_power(n, 1.7)), "EN 1993-1-1, 6.2.9.1, circular hollow section");
  u.M_Ny = u.M_Nz = value(M_N);
  if (M_Ed == 0) return 0;
  return value(s.eq("6.31", "eta_NM", si::one, s.named("M_Ed", si::N_m, M_Ed) / M_N, "EN 1993-1-1, (6.31)"));
}

/// M_Rd about both axes.
template <class T>
struct Moments {
  T y, z;
};

/// Classes 1, 2: a box.
template <class T>
double box_plastic(const Shared<T>& q, const Moments<T>& M_Rd, const T& n, const CrossForces& f, CrossSectionUse& u,
                   Sheet<T>& s) {
  const T a_w = s.eq("", "a_w", si::one, min((q.A - 2 * q.b * q.t) / q.A, T(0.5)), "EN 1993-1-1, 6.2.9.1 (5)");
  const T a_f = s.eq("", "a_f", si::one, min((q.A - 2 * q.h * q.t) / q.A, T(0.5)), "EN 1993-1-1, 6.2.9.1 (5)");
  const T M_Ny = s.eq("6.39", "M_Ny", si::N_m, min(M_Rd.y * (1 - n) / (1 - 0.5 * a_w), M_Rd.y), "EN 1993-1-1, (6.39)");
  const T M_Nz = s.eq("6.40", "M_Nz", si::N_m, min(M_Rd.z * (1 - n) / (1 - 0.5 * a_f), M_Rd.z), "EN 1993-1-1, (6.40)");
  u.M_Ny = value(M_Ny);
  u.M_Nz = value(M_Nz);
  const T M_y = s.named("M_y_Ed", si::N_m, std::abs(f.M_y)), M_z = s.named("M_z_Ed", si::N_m, std::abs(f.M_z));
  double use = 0;
  if (f.M_y != 0) use = value(s.eq("6.31", "eta_y", si::one, M_y / M_Ny, "EN 1993-1-1, (6.31)"));
  if (f.M_z != 0) use = std::max(use, value(s.eq("6.31", "eta_z", si::one, M_z / M_Nz, "EN 1993-1-1, (6.31)")));
  if (f.M_y == 0 || f.M_z == 0) return use;
  // 1.66/(1 - 1.13 n^2) leaves its meaning where the denominator vanishes: 6 is reached before
  const T a = value(n) < 0.8
                  ? s.eq("", "a", si::one, min(1.66 / (1 - 1.13 * square(n)), T(6.0)), "EN 1993-1-1, 6.2.9.1 (6)")
                  : s.eq("", "a", si::one, T(6.0), "EN 1993-1-1, 6.2.9.1 (6)");
  const T sum =
      s.eq("6.41", "eta_yz", si::one, to_power(M_y / M_Ny, a) + to_power(M_z / M_Nz, a), "EN 1993-1-1, (6.41)");
  return std::max(use, value(sum));
}

/// Class 3: the sum of the stresses.
template <class T>
double elastic(const Shared<T>& q, const SectionRow& r, const T& rho, const CrossForces& f, Sheet<T>& s) {
  const T N = s.named("N_Ed", si::N, std::abs(f.N)), W_y = s.named("W_el_y", si::m3, r.W_el_y);
  const char* clause = "EN 1993-1-1, (6.42)";
  const T f_yd = value(rho) == 0 ? q.f : T((1 - rho) * q.f);
  if (q.round) {
    const T M = s.named("M_Ed", si::N_m, std::hypot(f.M_y, f.M_z));
    const T sigma = s.eq("6.42", "sigma_x", si::Pa, N / q.A + M / W_y, clause);
    return value(s.eq("6.42", "eta_NM", si::one, sigma * q.gamma_M0 / f_yd, clause));
  }
  const T M_y = s.named("M_y_Ed", si::N_m, std::abs(f.M_y)), M_z = s.named("M_z_Ed", si::N_m, std::abs(f.M_z));
  const T sigma =
      s.eq("6.42", "sigma_x", si::Pa, N / q.A + M_y / W_y + M_z / s.named("W_el_z", si::m3, r.W_el_z), clause);
  return value(s.eq("6.42", "eta_NM", si::one, sigma * q.gamma_M0 / f_yd, clause));
}

}  // namespace

bool counts_torsion(double share) { return 1 - square(share) < 1; }

template <class T>
CrossSectionUse cross_section(const SteelSection& m, const CrossForces& f, Sheet<T>& s) {
  const SectionRow& r = m.section;
  CrossSectionUse u;
  u.section_class = section_class(r, m.yield, f).value;
  expects(u.section_class < 4, "a section of class 4 is refused before its resistance is asked for");
  Shared<T> q = shared_of<T>(m, u.section_class, s);
  const std::optional<T> torsion = torsion_share(q, r, f.torsion, u, s);
  const double V_y = q.round ? 0 : std::abs(f.V_y), V_z = q.round ? std::hypot(f.V_y, f.V_z) : std::abs(f.V_z);
  const Shear<T> z = shear_along(q, 'z', V_z, torsion, s);
  const Shear<T> y = q.round ? Shear<T>{z.A_v, T(0.0), z.V_Rd, 0} : shear_along(q, 'y', V_y, torsion, s);
  u.V_z_Rd = z.V_Rd;
  u.V_y_Rd = y.V_Rd;
  u.shear = std::max(y.use, z.use);
  u.N_pl = m.section.area * m.yield / m.gamma.M0;
  const T N_Rd = axial(q, y, z, s);
  const T M_y_Rd = bending(q, 'y', r.W_pl_y, r.W_el_y, z, s);
  const Moments<T> M_Rd{M_y_Rd, q.round ? M_y_Rd : bending(q, 'z', r.W_pl_z, r.W_el_z, y, s)};
  u.M_y_Rd = value(M_Rd.y);
  u.M_z_Rd = value(M_Rd.z);
  if (value(N_Rd) <= 0 || u.M_y_Rd <= 0 || u.M_z_Rd <= 0) {
    u.n = u.utilisation = no_resistance;
    return u;
  }
  const T n = s.eq("", "n", si::one, s.named("N_Ed", si::N, std::abs(f.N)) / N_Rd, "EN 1993-1-1, 6.2.9.1");
  u.n = value(n);
  if (!q.plastic) {
    u.utilisation = std::max(u.n, elastic(q, r, max(y.rho, z.rho), f, s));
  } else if (u.n >= 1) {
    const double M_y = std::abs(f.M_y) / u.M_y_Rd, M_z = std::abs(f.M_z) / u.M_z_Rd;
    u.utilisation = u.n + (q.round ? std::hypot(M_y, M_z) : M_y + M_z);
  } else {
    const double moments =
        q.round ? round_plastic(M_Rd.y, n, std::hypot(f.M_y, f.M_z), u, s) : box_plastic(q, M_Rd, n, f, u, s);
    u.utilisation = std::max(u.n, moments);
  }
  return u;
}

double elastic_stress(const SectionRow& r, const CrossForces& f) {
  const double bending = r.shape == SectionShape::chs ? std::hypot(f.M_y, f.M_z) / r.W_el_y
                                                      : std::abs(f.M_y) / r.W_el_y + std::abs(f.M_z) / r.W_el_z;
  return std::hypot(std::abs(f.N) / r.area + bending, std::numbers::sqrt3 * f.torsion / torsion_modulus(r));
}

template CrossSectionUse cross_section(const SteelSection&, const CrossForces&, Sheet<double>&);
template CrossSectionUse cross_section(const SteelSection&, const CrossForces&, Sheet<Num>&);

}  // namespace taut::structure
