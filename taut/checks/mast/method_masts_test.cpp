#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "test/support/machine_decks.hpp"

namespace taut::checks::method_masts_test {

using taut_test::check_of;
using taut_test::run_text;

std::string deck(const std::string& input, const std::string& mast) {
  return "taut: 1\nmethod: mast_section\ninput: {skyline_force: 100 kN, mainline_force: 40 kN, skyline_block_height: 8 "
         "m, block_friction: 0.16, steel: EN 10210-1 S355H, safety: 1.05, section: CHS 508x20, " +
         input + "}\nchecks: {masts: {m: {section: CHS 508x20, steel: EN 10210-1 S355H, load_factor: 1.62" + mast +
         "}}}\n";
}

// Ropes at rest bend the mast as those paid out, and press it more; by hand 140 kN cos(12 deg) across and 140 kN
// (sin(12 deg) + 1) down.
TEST(MethodMasts, EveryDirectionOfTheRopesCounts) {
  const Result r = run_text(deck("branch_angle: 12 deg", ""));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const double alpha = 12 * 3.14159265358979 / 180;
  const Result own = run_text(
      deck("branch_angle: 12 deg", fmt::format(", height: 8 m, loads: [{{down: {:.9g} kN, across: {:.9g} kN}}]",
                                               140 * (std::sin(alpha) + 1), 140 * std::cos(alpha))));
  ASSERT_EQ(own.status, Status::ok) << own.message << to_text(own.errors);
  for (const char* name : {"m.section", "m.member"})
    EXPECT_NEAR(check_of(r, name).value / check_of(own, name).value, 1, 1e-6) << name;
}

// The flat branch bends the mast most, wherever it stands in the list.
TEST(MethodMasts, EveryPositionCounts) {
  const auto at = [](const std::string& places) {
    const Result r =
        run_text(deck("span: {length: 300 m, rope_weight: 18 N/m, load: 40 kN, horizontal_tension: 90 kN, "
                      "carriage_position: [" +
                          places + "]}",
                      ""));
    EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    return check_of(r, "m.member").value;
  };
  const double near = at("10 m"), far = at("290 m");
  EXPECT_EQ(at("10 m, 290 m"), std::max(near, far));
  EXPECT_EQ(at("290 m, 10 m"), std::max(near, far));
}

TEST(MethodMasts, ASideForceBendsItToo) {
  const auto with = [](const std::string& more) {
    return check_of(run_text(deck("branch_angle: 12 deg" + more, "")), "m.member").value;
  };
  EXPECT_GT(with(", lateral_force: 60 kN"), 1.02 * with(""));
}

// It carries the blocks of the method, wherever the deck ends it.
TEST(MethodMasts, AHeightBelowTheBlocksIsTold) {
  const Result low = run_text(deck("branch_angle: 12 deg", ", height: 6 m")),
               own = run_text(deck("branch_angle: 12 deg", ""));
  ASSERT_EQ(low.status, Status::ok) << low.message << to_text(low.errors);
  EXPECT_EQ(check_of(low, "m.member").value, check_of(own, "m.member").value);
  const auto tells = [](const std::string& w) { return w.find("height of 6 m") != std::string::npos; };
  EXPECT_TRUE(std::any_of(low.warnings.begin(), low.warnings.end(), tells));
  EXPECT_TRUE(std::none_of(own.warnings.begin(), own.warnings.end(), tells));
}

// Guys hold and press the mast; the resultants on its blocks do not have that.
TEST(MethodMasts, AMastWithGuysIsNotJudgedWithoutThem) {
  const std::string guy =
      ", anchor_distance: 12 m, stiffness: 30 MN, weight: 15 N/m, breaking_force: 900 kN, install: {tension: 20 kN}}";
  const Result r = run_text(deck("branch_angle: 12 deg, guys: [{plan_angle: 120 deg" + guy + ", {plan_angle: 180 deg" +
                                     guy + ", {plan_angle: 240 deg" + guy + "]",
                                 ""));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_TRUE(std::none_of(r.checks.begin(), r.checks.end(), [](const Check& c) { return c.name.starts_with("m."); }));
  EXPECT_TRUE(std::any_of(r.unjudged.begin(), r.unjudged.end(), [](const auto& u) { return u.starts_with("m by"); }));
}

}  // namespace taut::checks::method_masts_test
