#include "taut/structure/cross_section.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "taut/base/expects.hpp"
#include "taut/catalogue/section_search.hpp"

// Expected numbers by hand from EN 1993-1-1 with the catalogue's properties (six figures), not by this code.
namespace taut::structure::cross_section_test {

SteelSection steel(const char* name, double yield = 355e6) {
  return {.section = *catalogue::find_section(name), .yield = yield, .E = 210e9, .gamma = {}};
}
CrossForces forces(double N, double M_y, double M_z = 0, double V_z = 0, double V_y = 0, double torsion = 0) {
  return {.N = N, .V_y = V_y, .V_z = V_z, .M_y = M_y, .M_z = M_z, .torsion = torsion};
}
CrossSectionUse use(const SteelSection& m, const CrossForces& f) {
  Sheet<double> s;
  return cross_section(m, f, s);
}

// Class 1: the mast of spec case A. A 24730.6 mm2, W_pl 3874.39 cm3.
TEST(CrossSection, TubeOfClassOne) {
  const auto u = use(steel("CHS 508x16"), forces(162638.979, 852064.180, 0, 106508.023));
  EXPECT_EQ(u.section_class, 1);
  EXPECT_NEAR(u.N_pl, 8779369, 20);
  EXPECT_NEAR(u.M_y_Rd, 1375408, 5);
  EXPECT_NEAR(u.V_z_Rd, 3226880, 10);
  EXPECT_NEAR(u.n, 0.0185251, 1e-7);
  EXPECT_NEAR(u.M_Ny, 1373846, 5);
  EXPECT_NEAR(u.utilisation, 0.620203, 5e-6);
  EXPECT_NEAR(u.shear, 106508.023 / 3226880, 1e-6);
  EXPECT_EQ(u.worst(), u.utilisation);
}

// Class 3: D/t 50.8. sigma = 400e3/15645.1 + hypot(300, 160) kN m/1910.25 cm3 = 203.555 MPa.
TEST(CrossSection, TubeOfClassThree) {
  const auto u = use(steel("CHS 508x10"), forces(400e3, 300e3, -160e3, 90e3));
  EXPECT_EQ(u.section_class, 3);
  EXPECT_NEAR(u.N_pl, 5554022, 20);
  EXPECT_NEAR(u.M_y_Rd, 678137, 5);
  EXPECT_NEAR(u.V_z_Rd, 2041395, 10);
  EXPECT_NEAR(u.utilisation, 0.573393, 5e-6);
}

TEST(CrossSection, BoxOfClassThree) {
  const auto u = use(steel("SHS 350x10"), forces(1500e3, 100e3, 60e3));
  EXPECT_EQ(u.section_class, 3);
  EXPECT_NEAR(u.utilisation, 0.617882, 5e-6);
}

// Class 1, both moments: n 0.148372, a_w 0.5, a_f 0.367935, exponent 1.70235, sum 0.212966.
TEST(CrossSection, BoxUnderBothMoments) {
  const auto u = use(steel("RHS 300x200x10"), forces(500e3, 120e3, 40e3, 100e3));
  EXPECT_EQ(u.section_class, 1);
  EXPECT_NEAR(u.n, 0.1483720, 2e-7);
  EXPECT_NEAR(u.M_Ny, 339203, 2);  // M_pl: n is too small to take anything
  EXPECT_NEAR(u.M_Nz, 255908, 2);
  EXPECT_NEAR(u.V_z_Rd, 1167371, 5);
  EXPECT_NEAR(u.V_y_Rd, 778247, 5);
  EXPECT_NEAR(u.utilisation, 0.353770, 2e-6);  // M_y/M_Ny; the sum of (6.41) is less
  // near the limit the sum decides: (0.8)^1.70235 + (0.6)^1.70235
  const auto v = use(steel("RHS 300x200x10"), forces(500e3, 0.8 * u.M_Ny, 0.6 * u.M_Nz));
  EXPECT_NEAR(v.utilisation, std::pow(0.8, 1.7023478) + std::pow(0.6, 1.7023478), 2e-6);
}

// V = 0.8 V_pl: rho = 0.36; M = (955.502 - 0.36 x 5695.62^2/80 mm3) f_y.
TEST(CrossSection, LargeShear) {
  const auto box = steel("RHS 300x200x10");
  const auto u = use(box, forces(100e3, 50e3, 0, 0.8 * 1167370.55));
  EXPECT_NEAR(u.M_y_Rd, 287380, 3);
  EXPECT_NEAR(u.n, 100e3 / 2642008, 1e-7);
  const auto tube = use(steel("CHS 508x16"), forces(0, 50e3, 0, 0.6 * 3226880, 0.53 * 3226880));
  const double rho = std::pow(2 * std::hypot(0.6, 0.53) - 1, 2);
  EXPECT_NEAR(tube.M_y_Rd / 1375408, 1 - rho, 1e-5);
  const auto beyond = use(box, forces(0, 50e3, 0, 1.01 * 1167370.55));
  EXPECT_GT(beyond.worst(), 1);
}

// A_m = 290 x 190 mm2 - (4 - pi) (12.5 mm)^2 = 54965.9 mm2; tau_t = T/(2 A_m t) = 30 kN m/(2 A_m x 10 mm) = 27.2897 MPa
// leaves 0.866853 of V_pl.
TEST(CrossSection, TorsionTakesShear) {
  const auto u = use(steel("RHS 300x200x10"), forces(0, 50e3, 0, 100e3, 0, -30e3));
  EXPECT_NEAR(u.V_z_Rd, 0.8668526 * 1167371, 5);
  const auto lost = use(steel("RHS 300x200x10"), forces(0, 50e3, 0, 0, 0, 300e3));
  EXPECT_EQ(lost.V_z_Rd, 0);
  EXPECT_GT(lost.worst(), 1);
}

// CHS 219.1x8: 2 A_m t = 16 mm x pi/4 (211.1 mm)^2 = 560.002 cm3, T_Rd = 114.777 kN m in f_y/sqrt(3) = 204.959 MPa.
TEST(CrossSection, TorsionAndBendingTogether) {
  const SteelSection m = steel("CHS 219.1x8");
  const auto u = use(m, forces(0, 81e3, 0, 16e3, 0, 99.4e3));
  EXPECT_NEAR(u.T_Rd, 114777, 20);
  EXPECT_NEAR(u.torsion, 0.86603, 2e-4);
  const auto plain = use(m, forces(0, 81e3, 0, 16e3));
  EXPECT_NEAR(u.utilisation, plain.utilisation / std::sqrt(1 - 0.86603 * 0.86603), 2e-3);
  EXPECT_LT(plain.utilisation, 1);
  EXPECT_GT(u.utilisation, 1);
  // without shear: (M/M_pl)^2 + (T/T_pl)^2 = 1, the plastic limit of a thin tube
  const auto circle = use(m, forces(0, 0.6 * plain.M_y_Rd, 0, 0, 0, 0.8 * u.T_Rd));
  EXPECT_NEAR(circle.utilisation, 1, 1e-9);
  const auto twisted = use(m, forces(0, 0, 0, 0, 0, 1.1 * u.T_Rd));
  EXPECT_NEAR(twisted.torsion, 1.1, 1e-9);
  EXPECT_GT(twisted.worst(), 1);
}

// Class 3: sigma sqrt(1/(1 - 3 tau^2/f_y^2)) <= f_y is von Mises, with tau of the outer fibre.
TEST(CrossSection, TorsionInClassThreeIsVonMises) {
  const SteelSection m = steel("CHS 508x10");
  const double T = 250e3, sigma = 400e3 / 15645.1e-6 + 340e3 / 1910.25e-6, tau = T / (2 * 1910.25e-6);
  const auto u = use(m, forces(400e3, 300e3, -160e3, 0, 0, T));
  EXPECT_EQ(u.section_class, 3);
  EXPECT_NEAR(u.utilisation, sigma / 355e6 / std::sqrt(1 - 3 * std::pow(tau / 355e6, 2)), 1e-4);
  EXPECT_NEAR(elastic_stress(m.section, forces(400e3, 300e3, -160e3, 0, 0, T)), std::hypot(sigma, std::sqrt(3) * tau),
              1e-4 * sigma);
}

TEST(CrossSection, TorsionOfRoundingChangesNothing) {
  for (const char* name : {"CHS 508x16", "RHS 300x200x10"}) {
    const auto u = use(steel(name), forces(100e3, 50e3, 0, 80e3, 0, 1e-6)),
               v = use(steel(name), forces(100e3, 50e3, 0, 80e3));
    EXPECT_EQ(u.utilisation, v.utilisation);
    EXPECT_EQ(u.shear, v.shear);
    EXPECT_EQ(u.M_y_Rd, v.M_y_Rd);
  }
}

TEST(CrossSection, TooMuchAxialForceIsTooMuch) {
  EXPECT_NEAR(use(steel("CHS 508x16"), forces(-1.2 * 8779369, 0)).utilisation, 1.2, 1e-5);
  EXPECT_NEAR(use(steel("SHS 350x12"), forces(1.2 * 16069.5e-6 * 355e6, 0)).utilisation, 1.2, 1e-5);
  EXPECT_NEAR(use(steel("CHS 508x16"), forces(0.99 * 8779369, 0)).utilisation, 0.99, 1e-5);
}

TEST(CrossSection, PartialFactor) {
  SteelSection m = steel("CHS 508x16");
  m.gamma.M0 = 1.1;
  const auto u = use(m, forces(162638.979, 852064.180));
  const double n = 0.01852513 * 1.1;
  EXPECT_NEAR(u.utilisation, 852064.180 * 1.1 / (1375408.2 * (1 - std::pow(n, 1.7))), 5e-6);
}

TEST(CrossSection, ClassFourIsRefused) { EXPECT_THROW(use(steel("CHS 508x8"), forces(1, 1)), ContractViolation); }

TEST(CrossSection, StressOfTheMastPaper) {
  EXPECT_NEAR(elastic_stress(steel("CHS 508x16").section, forces(162638.979, 852064.180)), 295492555, 1500);
  EXPECT_NEAR(elastic_stress(steel("SHS 350x10").section, forces(-1500e3, 100e3, -60e3)), 0.617882 * 355e6, 2e3);
}

RC_GTEST_PROP(CrossSection, SameWrittenAsComputed, ()) {
  const auto& all = catalogue::sections();
  const auto& row = all[*rc::gen::inRange<std::size_t>(0, all.size())];
  const double yield = *rc::gen::element(235e6, 355e6, 460e6);
  const auto part = [&] { return *rc::gen::inRange(-900, 900) / 1e3; };
  const double N_pl = row.area * yield, V_pl = N_pl / 3;
  CrossForces f{.N = part() * N_pl,
                .V_y = part() * V_pl,
                .V_z = part() * V_pl,
                .M_y = part() * row.W_pl_y * yield,
                .M_z = part() * row.W_pl_z * yield,
                .torsion = part() * row.W_el_y * yield / 4};
  RC_PRE(section_class(row, yield, f).value < 4);
  static const Description none;
  Sheet<Num> written("test", none, nullptr);
  Sheet<double> plain;
  const SteelSection m{.section = row, .yield = yield, .E = 210e9, .gamma = {}};
  const CrossSectionUse a = cross_section(m, f, written), b = cross_section(m, f, plain);
  RC_ASSERT(a.utilisation == b.utilisation);
  RC_ASSERT(a.shear == b.shear);
  RC_ASSERT(b.utilisation >= b.n);
  CrossForces less = f;
  less.torsion *= 0.9;
  // before n = 1 no moment is left and the use has no bound; from there on it is a sum beyond 1
  if (b.n < 1) {
    RC_ASSERT(cross_section(m, less, plain).utilisation <= b.utilisation);
  } else {
    RC_ASSERT(b.utilisation >= 1);
  }
  // signs don't count, and a tube has no axes
  const auto mirrored = cross_section(
      m, CrossForces{.N = f.N, .V_y = -f.V_y, .V_z = f.V_z, .M_y = -f.M_y, .M_z = f.M_z, .torsion = -f.torsion}, plain);
  RC_ASSERT(mirrored.utilisation == b.utilisation);
  if (row.shape == catalogue::SectionShape::chs) {
    const double c = std::cos(0.7), s = std::sin(0.7);
    const auto turned = cross_section(m,
                                      CrossForces{.N = f.N,
                                                  .V_y = c * f.V_y - s * f.V_z,
                                                  .V_z = s * f.V_y + c * f.V_z,
                                                  .M_y = c * f.M_y - s * f.M_z,
                                                  .M_z = s * f.M_y + c * f.M_z,
                                                  .torsion = f.torsion},
                                      plain);
    if (std::isfinite(b.utilisation)) RC_ASSERT(std::abs(turned.utilisation / b.utilisation - 1) < 1e-9);
  }
}

}  // namespace taut::structure::cross_section_test
