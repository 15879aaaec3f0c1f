#include "taut/methods/friction_drive/friction_drive.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

namespace taut::friction_drive::friction_drive_test {

rc::Gen<double> between(double low, double high) {
  return rc::gen::map(rc::gen::inRange(0, 1000001), [=](int i) { return low + (high - low) * i * 1e-6; });
}

Input random_input() {
  Input in;
  in.cutting_force = *between(10, 20e3);
  in.friction = *between(0.05, 1.5);
  in.wrap = *between(0.5, 8);
  in.rope_mass = *between(0, 3);
  in.speed = *between(0, 40);
  in.grip_reserve = *between(1, 2);
  in.section_factor = *between(0, 0.9);
  in.fill_ratio = *between(0.3, 1);
  in.rest_arc = *between(0, 0.3);
  in.idler_loss = *between(1, 1.2);
  if (*rc::gen::arbitrary<bool>()) in.rope_area = *between(1e-5, 1e-3);
  if (*rc::gen::arbitrary<bool>()) in.sheave_radius = *between(0.05, 1);
  return in;
}

Input gripping_input() {
  Input in = random_input();
  Output out;
  RC_PRE(solve(in, out).ok());
  return in;
}

Output solved(const Input& in) {
  Output out;
  RC_ASSERT(solve(in, out).ok());
  return out;
}

bool near(double a, double b, double tolerance = 1e-9) {
  return std::abs(a - b) <= tolerance * std::max({1.0, std::abs(a), std::abs(b)});
}

TEST(FrictionDrive, EveryFieldIsDescribedOnce) {
  for (const Description* d : {&Input::describe(), &Output::describe()}) {
    auto keys = d->keys();
    std::sort(keys.begin(), keys.end());
    EXPECT_EQ(std::adjacent_find(keys.begin(), keys.end()), keys.end());
  }
}

RC_GTEST_PROP(FrictionDrive, DoubleAndNumAgreeToTheLastBit, ()) {
  const Input in = random_input();
  Output plain, traced;
  Sheet<Num> s(about().short_source, Input::describe(), &in);
  const Outcome a = solve(in, plain), b = compute(in, s, traced);
  RC_ASSERT(a.status == b.status);
  RC_ASSERT(a.message == b.message);
  const auto x = values_of(Output::describe(), &plain), y = values_of(Output::describe(), &traced);
  RC_ASSERT(x.size() == y.size());
  for (std::size_t i = 0; i < x.size(); ++i) RC_ASSERT(x[i].value == y[i].value);
}

RC_GTEST_PROP(FrictionDrive, ForcesScale, ()) {
  const Input in = gripping_input();
  const double k = *between(0.1, 10);
  Input scaled = in;
  scaled.cutting_force *= k;
  scaled.rope_mass *= k;
  const Output a = solved(in), b = solved(scaled);
  for (double Output::*force : {&Output::P_slack, &Output::P_tight, &Output::P_T, &Output::P_M, &Output::P_M_printed,
                                &Output::takeup_no_slip, &Output::T_1, &Output::T_2}) {
    RC_ASSERT(near(b.*force, k * a.*force, 1e-8));
  }
  RC_ASSERT(a.e == b.e);
}

RC_GTEST_PROP(FrictionDrive, MassAndSpeedOnlyMatterAsCentrifugalTension, ()) {
  const Input in = gripping_input();
  Input other = in;
  other.rope_mass *= 4;
  other.speed /= 2;
  RC_ASSERT(near(solved(in).P_M, solved(other).P_M));
}

RC_GTEST_PROP(FrictionDrive, BranchesAreTheOnesOfThePaper, ()) {
  const Input in = gripping_input();
  const Output o = solved(in);
  RC_ASSERT(near(o.P_tight - o.c, (o.P_slack - o.c) * o.e, 1e-9));
  RC_ASSERT(near(o.P_M, (o.P_T - in.cutting_force) * (o.e + 1) / (o.e - 1), 1e-6));
  RC_ASSERT(near(o.T_1 - o.T_2, o.P_M * (o.e - 1) / (o.e + 1) + in.cutting_force, 1e-8));
  if (in.grip_reserve == 1) RC_ASSERT(near(o.P_tight, in.idler_loss * o.P_slack + in.cutting_force, 1e-8));
}

RC_GTEST_PROP(FrictionDrive, NoSlipDriveHoldsWithItsReserve, ()) {
  const Input in = gripping_input();
  const Output o = solved(in);
  RC_ASSERT(near(o.T_1_no_slip - o.T_2_no_slip, in.cutting_force, 1e-8));
  RC_ASSERT((o.T_1_no_slip - o.c) / (o.T_2_no_slip - o.c) <= o.e * (1 + 1e-9));
  // m times the cutting force is just what the slack branch can carry
  RC_ASSERT(near((o.T_2_no_slip - o.c) * (o.e - 1), in.grip_reserve * in.cutting_force, 1e-8));
  RC_ASSERT(!(o.takeup_with_idler_loss < o.takeup_no_slip * (1 - 1e-12)));
}

RC_GTEST_PROP(FrictionDrive, IdlerLossWithoutReserveIsThePapersDrive, ()) {
  Input in = gripping_input();
  in.grip_reserve = 1;
  const Output o = solved(in);
  RC_ASSERT(near(o.takeup_with_idler_loss, o.takeup_15_16, 1e-7));
}

RC_GTEST_PROP(FrictionDrive, MoreGripNeedsLessPull, ()) {
  const Input in = gripping_input();
  Input more = in;
  more.wrap += *between(0.01, 1);
  RC_ASSERT(solved(more).takeup_no_slip < solved(in).takeup_no_slip);
  more = in;
  more.friction = std::min(1.5, in.friction * 1.1);
  RC_ASSERT(solved(more).takeup_no_slip <= solved(in).takeup_no_slip);
  more = in;
  more.grip_reserve += 0.1;
  RC_ASSERT(solved(more).takeup_no_slip > solved(in).takeup_no_slip);
}

RC_GTEST_PROP(FrictionDrive, WithoutAndreevTheWholeWrapWorks, ()) {
  Input in = gripping_input();
  in.section_factor = 0;
  in.fill_ratio = 1;
  in.rest_arc = 0;
  const Output o = solved(in);
  RC_ASSERT(near(o.e, o.euler_ratio));
  RC_ASSERT(near(o.phi, in.wrap));
}

TEST(FrictionDrive, NoReserveAndNoLossLeaveTheSlackBranchEmpty) {
  Input in;
  in.cutting_force = 1000;
  in.friction = 0.3;
  in.wrap = 3;
  in.rope_mass = 0.5;
  in.speed = 10;
  in.grip_reserve = 1;
  in.idler_loss = 1;
  Output out;
  ASSERT_TRUE(solve(in, out).ok());
  EXPECT_NEAR(out.P_M, 0, 1e-9);
  EXPECT_NEAR(out.T_2, out.c, 1e-9);
  EXPECT_GT(out.slip_ratio, out.e);
  EXPECT_EQ(exit_code(run(in)), 4);
}

}  // namespace taut::friction_drive::friction_drive_test
