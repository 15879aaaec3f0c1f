#include "taut/app/exact/friction_drive_exact.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "taut/calc/answers.hpp"
#include "taut/units/display.hpp"

// The method and the engine on the same drive.
namespace taut::app::friction_drive_exact_test {

using namespace friction_drive;

Input saw() {
  Input in;
  in.cutting_force = 4000;
  in.friction = 0.35;
  in.wrap = 3.5;
  in.rope_mass = 0.6;
  in.speed = 15;
  in.grip_reserve = 1;
  in.idler_loss = 1;
  in.rope_area = 70e-6;
  return in;
}

Output solved(const Input& in) {
  Output out;
  EXPECT_TRUE(friction_drive::solve(in, out).ok());
  return out;
}

Result completed(const Input& in) { return run_friction_drive(in); }

double number(const Result& r, const std::string& name) {
  const Value* v = r.find_value(name);
  return v == nullptr ? not_computed : v->value;
}

TakeUp weight(double W) { return {.weight = W, .mass = {}, .screw = {}}; }
TakeUp screw(double W) { return {.weight = {}, .mass = {}, .screw = W}; }

TEST(FrictionDriveExact, NoSlipTakeUpOfTheMethodUsesTheWholeArc) {
  Input in = saw();
  const Output o = solved(in);
  in.take_up = weight(o.takeup_no_slip * (1 + 1e-9));
  const Result r = completed(in);
  EXPECT_NEAR(number(r, "T_1_exact"), o.T_1_no_slip, 1e-5 * o.T_1_no_slip);
  EXPECT_NEAR(number(r, "T_2_exact"), o.T_2_no_slip, 1e-5 * o.T_2_no_slip);
  EXPECT_NEAR(number(r, "arc_used_exact"), 1, 1e-6);
  EXPECT_EQ(number(r, "slips_exact"), 0);
}

TEST(FrictionDriveExact, IdlerLossIsTheMethodsToo) {
  Input in = saw();
  in.idler_loss = 1.08;
  const Output o = solved(in);
  in.take_up = weight(o.takeup_with_idler_loss * (1 + 1e-9));
  EXPECT_NEAR(number(completed(in), "arc_used_exact"), 1, 1e-6);
  in.take_up = weight(o.takeup_no_slip);
  EXPECT_EQ(number(completed(in), "slips_exact"), 1) << "takeup_no_slip leaves the idler loss out";
}

TEST(FrictionDriveExact, PaperPullSlipsAndPassesOnWhatTheMethodSays) {
  Input in = saw();
  in.grip_reserve = 1.2;
  const Output o = solved(in);
  in.take_up = weight(o.P_M);
  const Result r = completed(in);
  EXPECT_EQ(number(r, "slips_exact"), 1);
  EXPECT_NEAR(number(r, "cutting_force_exact"), o.cutting_force_at_P_M, 1e-6 * o.cutting_force_at_P_M);
  bool fails = false;
  for (const Check& c : r.checks) fails |= c.name == "grip with the take-up, exact" && !c.passes;
  EXPECT_TRUE(fails);
}

// The pull that holds m times the cutting force passes, one that holds the cutting force alone does not.
TEST(FrictionDriveExact, TheTakeUpHasToHoldTheReserve) {
  Input in = saw();
  in.grip_reserve = 1.3;
  const auto grip_with = [&](double pull) {
    in.take_up = weight(pull);
    const Result r = completed(in);
    const auto grip = std::find_if(r.checks.begin(), r.checks.end(),
                                   [](const Check& c) { return c.name == "grip with the take-up, exact"; });
    EXPECT_NE(grip, r.checks.end());
    return std::pair(grip->passes, number(r, "slips_exact"));
  };
  const double needed = solved(in).takeup_no_slip;
  EXPECT_EQ(grip_with(needed * (1 + 1e-6)), std::pair(true, 0.));
  EXPECT_EQ(grip_with(needed * (1 - 1e-3)), std::pair(false, 0.)) << "it holds, but without the reserve";
  EXPECT_EQ(grip_with(needed / 1.4), std::pair(false, 1.));
}

TEST(FrictionDriveExact, WithoutTakeUpTheMethodsPullIsTried) {
  Input in = saw();
  in.grip_reserve = 1.3;
  const Output o = solved(in);
  const Result r = completed(in);
  EXPECT_NEAR(number(r, "take_up_exact"), o.takeup_with_idler_loss, 1e-6);
  EXPECT_LT(number(r, "arc_used_exact"), 1);
  for (const Check& c : r.checks) EXPECT_EQ(c.name.find("exact"), std::string::npos);
}

TEST(FrictionDriveExact, ScrewLosesItsGripAtTheMethodsSpeed) {
  Input in = saw();
  const Output o = solved(in);
  in.take_up = screw(o.takeup_no_slip);
  in.rope_stiffness = 1e15;  // small strains, as the method has it
  in.speed = 0.999 * o.speed_of_lost_grip;
  const Result slow = completed(in);
  EXPECT_EQ(slow.status, Status::ok) << slow.message;
  EXPECT_EQ(number(slow, "slips_exact"), 1);
  EXPECT_LT(number(slow, "cutting_force_exact"), 0.01 * in.cutting_force);
  in.speed = 1.001 * o.speed_of_lost_grip;
  EXPECT_EQ(completed(in).status, Status::infeasible);
}

TEST(FrictionDriveExact, CreepNeedsAStiffness) {
  Input in = saw();
  Result r = completed(in);
  EXPECT_NEAR(number(r, "creep_exact"), 4000 / 7e6, 1e-9);
  EXPECT_NEAR(number(r, "creep_speed_exact"), 15 * 4000 / 7e6, 1e-8);
  in.rope_area.reset();
  r = completed(in);
  EXPECT_TRUE(std::isnan(number(r, "creep_exact")));
  EXPECT_FALSE(std::isnan(number(r, "slip_arc_exact")));
}

TEST(FrictionDriveExact, CutWithinTheBranchLeavesMoreSlackTension) {
  Input in = saw();
  in.take_up = weight(11e3);
  const double at_idler = number(completed(in), "T_2_exact");
  in.cut = CutPlace::in_tight_branch;
  EXPECT_NEAR(number(completed(in), "T_2_exact"), at_idler + 2000, 1e-6);
}

TEST(FrictionDriveExact, OneTakeUpOnly) {
  Input in = saw();
  in.take_up = TakeUp{.weight = 1e3, .mass = 100, .screw = {}};
  ASSERT_EQ(complaints(in).size(), 1u);
  EXPECT_EQ(complaints(in)[0].path, "take_up");
  in.take_up = TakeUp{.weight = {}, .mass = 100, .screw = {}};
  EXPECT_TRUE(complaints(in).empty());
}

TEST(FrictionDriveExact, OnlyATakeUpOfTheDeckIsTheDecks) {
  Input in = saw();
  const auto line = [](const Input& of) {
    for (const Answer& a : answers(of, completed(of), Display())) {
      if (a.label == "Take-up") return a.text;
    }
    return std::string();
  };
  EXPECT_NE(line(in).find("a pull of"), std::string::npos) << line(in);
  EXPECT_EQ(line(in).find("the deck's"), std::string::npos) << line(in);
  in.take_up = weight(20e3);
  EXPECT_NE(line(in).find("the deck's 20 kN holds the rope"), std::string::npos) << line(in);
}

}  // namespace taut::app::friction_drive_exact_test
