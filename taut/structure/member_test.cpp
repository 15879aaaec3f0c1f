#include "taut/structure/member.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "taut/catalogue/section_search.hpp"

// Expected numbers by hand from EN 1993-1-1, annex B, with the catalogue's properties, not by this code.
namespace taut::structure::member_test {

Member member(const char* name, double L_y, double L_z, double C_m = 0.9) {
  Member m;
  m.steel = {.section = *catalogue::find_section(name), .yield = 355e6, .E = 210e9, .gamma = {}};
  m.y = {.length = L_y, .critical_force = {}, .C_m = C_m};
  m.z = {.length = L_z, .critical_force = {}, .C_m = C_m};
  return m;
}
CrossForces forces(double N, double M_y, double M_z = 0) {
  CrossForces f;
  f.N = N;
  f.M_y = M_y;
  f.M_z = M_z;
  return f;
}
MemberUse use(const Member& m, const CrossForces& f) {
  Sheet<double> s;
  return member_use(m, f, s);
}

// Spec case A, 8 m cantilever, k = 2, hot-finished: curve a.
TEST(Member, CantileverMastOfClassOne) {
  const auto u = use(member("CHS 508x16", 16, 16), forces(162638.979, 852064.180));
  EXPECT_NEAR(u.N_cr_y, 6064756, 20);
  EXPECT_NEAR(u.lambda_y, 1.203164, 5e-6);
  EXPECT_NEAR(u.chi_y, 0.5280025, 5e-6);
  EXPECT_NEAR(u.flexural, 0.0350853, 5e-7);
  EXPECT_NEAR(u.k_yy, 0.9252614, 5e-6);
  EXPECT_NEAR(u.eq_6_61, 0.608284, 5e-6);
  EXPECT_EQ(u.worst(), u.eq_6_61);
}

TEST(Member, AnAxialForceOfRoundingPressesNothing) {
  const Member m = member("CHS 508x16", 16, 16);
  EXPECT_EQ(use(m, forces(1e-9, 850e3)).worst(), 0);
  EXPECT_GT(use(m, forces(1, 850e3)).worst(), 0.5);
}

// Class 3, cold-formed: curve c; N 400 kN, M 340 kN m, L_cr 12 m.
TEST(Member, TubeOfClassThree) {
  const auto u = use(member("CHS-C 508x10", 12, 12), forces(400e3, 300e3, 160e3));
  EXPECT_NEAR(u.N_cr_y, 6983603, 20);
  EXPECT_NEAR(u.lambda_y, 0.8917929, 5e-6);
  EXPECT_NEAR(u.chi_y, 0.6048827, 5e-6);
  EXPECT_NEAR(u.flexural, 0.1190642, 5e-7);
  EXPECT_NEAR(u.k_yy, 0.9573375, 5e-6);
  EXPECT_NEAR(u.eq_6_61, 0.599048, 5e-6);
}

TEST(Member, BoxOfClassThree) {
  const auto u = use(member("SHS 350x10", 10, 10), forces(1500e3, 100e3, 60e3));
  EXPECT_NEAR(u.lambda_y, 0.9449128, 5e-6);
  EXPECT_NEAR(u.chi_z, 0.7037656, 5e-6);
  EXPECT_NEAR(u.flexural, 0.4449754, 1e-6);
  EXPECT_NEAR(u.k_yy, 1.1270500, 1e-5);
  EXPECT_EQ(u.k_yz, u.k_zz);
  EXPECT_NEAR(u.eq_6_61, 0.788414, 1e-5);
  EXPECT_NEAR(u.eq_6_62, 0.745484, 1e-5);
}

TEST(Member, BoxUnderBothMomentsWithItsFactor) {
  Member m = member("RHS 300x200x10", 6, 6, 0.6);
  m.steel.gamma.M1 = 1.1;
  const auto u = use(m, forces(500e3, 120e3, 40e3));
  EXPECT_NEAR(u.N_cr_y, 6804747, 20);
  EXPECT_NEAR(u.lambda_y, 0.7037251, 5e-6);
  EXPECT_NEAR(u.lambda_z, 0.9656165, 5e-6);
  EXPECT_NEAR(u.chi_y, 0.8459840, 5e-6);
  EXPECT_NEAR(u.chi_z, 0.6895273, 5e-6);
  EXPECT_NEAR(u.k_yy, 0.6583079, 5e-6);
  EXPECT_NEAR(u.k_zz, 0.7087316, 5e-6);
  EXPECT_NEAR(u.k_yz, 0.4252389, 5e-6);
  EXPECT_NEAR(u.k_zy, 0.3949847, 5e-6);
  EXPECT_NEAR(u.eq_6_61, 0.522215, 5e-6);
  EXPECT_NEAR(u.eq_6_62, 0.512262, 5e-6);
}

TEST(Member, HeldAgainstBucklingOrPulled) {
  Member m = member("CHS 508x16", 16, 16);
  m.y.length = m.z.length = std::nullopt;
  const auto u = use(m, forces(162638.979, 852064.180));
  EXPECT_EQ(u.chi_y, 1);
  EXPECT_NEAR(u.flexural, 0.0185251, 5e-7);
  EXPECT_EQ(use(member("CHS 508x16", 16, 16), forces(-1e6, 1e6)).worst(), 0);
  m.y.critical_force = m.z.critical_force = 6064755.6;  // from elsewhere: the same as by its length
  EXPECT_NEAR(use(m, forces(162638.979, 852064.180)).eq_6_61, 0.608284, 5e-6);
}

TEST(Member, ATubeHeldInOneWayBucklesInTheOther) {
  const auto both = use(member("CHS 508x16", 16, 16), forces(900e3, 300e3, 400e3));
  const auto one = use(member("CHS 508x16", 5, 16), forces(900e3, 300e3, 400e3));
  const auto other = use(member("CHS 508x16", 16, 5), forces(900e3, 400e3, 300e3));
  EXPECT_NEAR(one.eq_6_61, both.eq_6_61, 1e-12);
  EXPECT_NEAR(other.eq_6_61, both.eq_6_61, 1e-12);
}

TEST(Member, FactorsOfEndsAndMoments) {
  EXPECT_DOUBLE_EQ(c_m_of(1), 1);
  EXPECT_DOUBLE_EQ(c_m_of(0), 0.6);
  EXPECT_DOUBLE_EQ(c_m_of(-1), 0.4);
  EXPECT_EQ(buckling_factor(true, false), 2);
  EXPECT_EQ(buckling_factor(true, true), 0.7);
  EXPECT_EQ(buckling_factor(false, true), 1);
  EXPECT_FALSE(buckling_factor(false, false));
}

TEST(Member, SameWrittenAsComputed) {
  static const Description none;
  for (const char* name : {"CHS 508x16", "RHS 300x200x10", "SHS 350x10"}) {
    Sheet<Num> s("test", none, nullptr);
    const Member m = member(name, 7, 5);
    const CrossForces f = forces(700e3, 80e3, 30e3);
    const MemberUse written = member_use(m, f, s), plain = use(m, f);
    EXPECT_EQ(written.eq_6_61, plain.eq_6_61);
    EXPECT_EQ(written.eq_6_62, plain.eq_6_62);
    EXPECT_GT(s.steps().size(), 10U);
  }
}

}  // namespace taut::structure::member_test
