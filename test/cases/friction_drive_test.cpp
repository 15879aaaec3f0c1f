#include "taut/methods/friction_drive/friction_drive.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "taut/math/degree.hpp"
#include "taut/methods/friction_drive/saw_drive_test.hpp"
#include "test/support/solved.hpp"

// Ryabukhin et al. 2022 prints no worked example: the numbers are of an independent calculation; the witness here
// integrates the paper's own differential equation.
namespace taut::friction_drive::friction_drive_test {

Input case_a() {
  Input in;
  in.cutting_force = 2500;
  in.friction = 0.3;
  in.wrap = 180 * degree;
  in.rope_mass = 0.6;
  in.speed = 20;
  in.grip_reserve = 1.2;
  in.section_factor = 0.2;
  in.fill_ratio = 0.5 / 0.6;
  return in;
}

Output solved(const Input& in) { return taut_test::solved_as<Output>(in); }

/// Tension after the arc, by the classical Runge-Kutta method on dP/d(alpha) = mu (P - c): (4)-(11).
double integrate(double P, double mu, double c, double arc) {
  constexpr int steps = 2000;
  const double h = arc / steps;
  const auto slope = [&](double p) { return mu * (p - c); };
  for (int i = 0; i < steps; ++i) {
    const double k1 = slope(P), k2 = slope(P + h / 2 * k1), k3 = slope(P + h / 2 * k2), k4 = slope(P + h * k3);
    P += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return P;
}

TEST(FrictionDriveCase, CaseA) {
  const Output out = solved(case_a());
  EXPECT_NEAR(out.phi, 1.975844436, 5e-10);
  EXPECT_NEAR(out.e, 1.808962237, 5e-10);
  EXPECT_NEAR(out.andreev_ratio, 1.808962237, 5e-10);
  EXPECT_NEAR(out.euler_ratio, std::exp(0.3 * std::numbers::pi), 1e-12);
  EXPECT_NEAR(out.c, 240, 1e-12);
  EXPECT_NEAR(out.P_slack, 4435.0461, 5e-5);
  EXPECT_NEAR(out.P_tight, 7828.6800, 5e-5);
  EXPECT_NEAR(out.P_T, 3393.6339, 5e-5);
  EXPECT_NEAR(out.P_M, 3102.9678, 5e-5);
  EXPECT_NEAR(out.P_M_printed, 2953.3407, 5e-5);
  EXPECT_NEAR(out.takeup_no_slip, 9916.9099, 5e-5);
}

TEST(FrictionDriveCase, ExampleOfTheSaw) {
  const Output out = solved(saw_drive());
  EXPECT_NEAR(out.e, 16.322, 5e-4);
  EXPECT_NEAR(out.P_M, 1806.0, 0.05);
  EXPECT_NEAR(out.P_M_printed, 1394.7, 0.05);
  EXPECT_NEAR(out.slip_ratio, 54.7, 0.05);
  EXPECT_NEAR(out.takeup_no_slip, 4678.8, 0.05);
  EXPECT_NEAR(out.takeup_15_16, 6328.2, 0.05);
}

TEST(FrictionDriveCase, TightBranchIsTheIntegralOverTheArc) {
  for (const Input& in : {case_a(), saw_drive()}) {
    const Output out = solved(in);
    EXPECT_NEAR(integrate(out.P_slack, in.friction, out.c, out.phi), out.P_tight, 1e-6 * out.P_tight);
  }
}

TEST(FrictionDriveCase, PrintedEquation13IsNotTheIntegral) {
  const Input in = case_a();
  const Output out = solved(in);
  const double exact = integrate(out.P_slack, in.friction, out.c, out.phi);
  EXPECT_NEAR(out.P_tight_printed - exact, out.c * out.e, 1e-3);
  EXPECT_GT(std::abs(out.P_tight_printed - exact), 0.05 * exact);
}

/// P_M from the integral alone: the pull of the drive less the cutting force, over the share that T_1 - T_2 takes of
/// P_M.
double P_M_by_integration(const Input& in, const Output& out) {
  const double mu = in.friction, arc = out.phi, c = out.c;
  const double grip = integrate(c + 1, mu, c, arc) - c;  // what one newton of slack branch becomes
  const double P_slack = in.grip_reserve * (in.cutting_force + c * (grip - 1)) / (grip - in.idler_loss);
  const double pull = integrate(P_slack, mu, c, arc) - P_slack;
  const double share = 1 / (1 + 1 / grip) - 1 / grip / (1 + 1 / grip);
  return (pull - in.cutting_force) / share;
}

TEST(FrictionDriveCase, SignOfEquation3) {
  for (const Input& in : {case_a(), saw_drive()}) {
    const Output out = solved(in);
    const double P_M = P_M_by_integration(in, out);
    // T_1 - T_2 of the line above (3), with the P_M asked for, has to be the pull.
    EXPECT_NEAR(out.T_1 - out.T_2, out.P_T, 1e-6 * out.P_T);
    EXPECT_NEAR(out.P_M, P_M, 1e-6 * P_M);
    EXPECT_GT(out.P_M_3_printed - P_M, in.cutting_force);
  }
}

TEST(FrictionDriveCase, PrintedEquation18HoldsForMOneOnly) {
  for (Input in : {case_a(), saw_drive()}) {
    for (const double m : {1.0, 1.1, 1.2, 1.5}) {
      in.grip_reserve = m;
      const Output out = solved(in);
      const double P_M = P_M_by_integration(in, out);
      EXPECT_NEAR(out.P_M, P_M, 1e-6 * in.cutting_force);
      if (m == 1.0) {
        EXPECT_NEAR(out.P_M_printed, P_M, 1e-6 * in.cutting_force);
      } else {
        EXPECT_LT(out.P_M_printed, P_M - 0.9 * (m - 1) * out.c) << "too small: unsafe";
      }
    }
  }
}

// The driving sheave's torque on the rope has the sign of T_1 - T_2: the branch it draws in is the tight one.
TEST(FrictionDriveCase, TightBranchIsDrawnIn) {
  const Output out = solved(saw_drive());
  EXPECT_GT(out.T_1, out.T_2);
  EXPECT_GT(out.P_tight, out.P_slack);
  EXPECT_GT(integrate(out.P_slack, 0.8, out.c, 1.0), out.P_slack)
      << "tension grows from the slack branch to the tight one";
}

TEST(FrictionDriveCase, PaperDriveSlips) {
  for (const Input& in : {case_a(), saw_drive()}) {
    const Output out = solved(in);
    // From the paper's T_2 the whole arc builds up less than the paper's T_1.
    EXPECT_LT(integrate(out.T_2, in.friction, out.c, out.phi), out.T_1);
    EXPECT_GT(out.slip_ratio, out.e);
    const Result r = run(in);
    ASSERT_EQ(r.checks.size(), 1u);
    EXPECT_EQ(r.checks[0].name, "no slip");
    EXPECT_FALSE(r.checks[0].passes);
    EXPECT_EQ(exit_code(r), 4);
    // The consistent drive holds, with m times the cutting force to spare.
    EXPECT_GE(integrate(out.T_2_no_slip, in.friction, out.c, out.phi) * (1 + 1e-9),
              out.T_2_no_slip + in.grip_reserve * in.cutting_force);
    EXPECT_NEAR(out.T_1_no_slip + out.T_2_no_slip - 2 * out.c, out.takeup_no_slip, 1e-6);
  }
}

// What a take-up of constant pull P_M passes on: shift force from branch to branch until the arc is used up.
TEST(FrictionDriveCase, PullOfPMIsNotEnoughForTheCut) {
  const Input in = saw_drive();
  const Output out = solved(in);
  double low = 0, high = out.P_M;
  for (int i = 0; i < 60; ++i) {
    const double P = (low + high) / 2;
    const double T_2 = out.c + (out.P_M - P) / 2;
    (integrate(T_2, in.friction, out.c, out.phi) >= T_2 + P ? low : high) = P;
  }
  EXPECT_NEAR(out.cutting_force_at_P_M, low, 1e-4);
  EXPECT_LT(low, 0.5 * in.cutting_force);
}

TEST(FrictionDriveCase, NoGripIsInfeasible) {
  Input in = case_a();
  in.friction = 0.02;
  Output out;
  const Outcome outcome = solve(in, out);
  EXPECT_EQ(outcome.status, Status::infeasible);
  EXPECT_LE(out.e, 1.08);
  EXPECT_EQ(exit_code(run(in)), 3);
}

}  // namespace taut::friction_drive::friction_drive_test
