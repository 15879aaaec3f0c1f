#include "taut/rope/rope_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace taut::rope::rope_check_test {

/// A hoist rope of 16 mm, 160 kN, under 40 kN over one sheave of 320 mm and a wedge at its end.
RopeUse hoist_rope() {
  RopeUse use;
  use.name = "hoist";
  use.rope.construction = "6x36";
  use.rope.core = "IWRC";
  use.rope.diameter = 0.016;
  use.rope.area = 117.76e-6;
  use.rope.breaking_force = 160e3;
  use.rope.grade = 1770e6;
  use.rope.trust = catalogue::Trust::verified;
  use.tension = 40e3;
  use.where = "hoist";
  use.bends = {
      {.name = "head", .kind = BendKind::sheave, .diameter = 0.32, .tension = 36e3, .wrap = 3.0, .about = {0, 1, 0}}};
  use.ends = {{.name = "hook", .tension = 30e3}};
  return use;
}

const Check* find(const RopeChecks& all, const std::string& name) {
  const auto at = std::find_if(all.checks.begin(), all.checks.end(), [&](const Check& c) { return c.name == name; });
  return at == all.checks.end() ? nullptr : &*at;
}

double value_of(const RopeChecks& all, const std::string& name) {
  const Check* c = find(all, name);
  EXPECT_NE(c, nullptr) << name;
  return c == nullptr ? std::nan("") : c->value;
}

TEST(RopeCheck, strength_at_every_place) {
  RopeRules rules;
  rules.safety_factors = {{.value = 3.5, .rule = "a rule", .trust = "verified"}};
  rules.termination = Limit{.value = 0.8, .rule = "wedge", .trust = "verified"};
  const RopeChecks all = check_rope(hoist_rope(), rules);
  EXPECT_DOUBLE_EQ(value_of(all, "hoist.safety_factor"), 4.0);
  EXPECT_NEAR(value_of(all, "hoist.termination"), 0.8 * 160 / 30, 1e-12);
  EXPECT_NEAR(value_of(all, "hoist.on_sheave"), (1 - 0.5 / std::sqrt(20)) * 160 / 36, 1e-12);
  for (const Check& c : all.checks) EXPECT_EQ(c.part, "hoist");
  EXPECT_TRUE(find(all, "hoist.safety_factor")->passes);
  EXPECT_EQ(find(all, "hoist.safety_factor")->trust, "verified");
  EXPECT_TRUE(find(all, "hoist.on_sheave")->trust.starts_with("UNVERIFIED"));
}

// The worst of several sheaves stays: here a smaller one with less tension.
TEST(RopeCheck, the_worst_sheave_governs) {
  RopeUse use = hoist_rope();
  use.bends.push_back({.name = "small", .kind = BendKind::sheave, .diameter = 0.08, .tension = 35e3, .wrap = 1.0});
  use.bends.push_back({.name = "touched",
                       .kind = BendKind::sheave,
                       .diameter = 0.01,
                       .tension = 40e3,
                       .wrap = 0.0});  // does not bend it
  RopeRules rules;
  rules.safety_factors = {{.value = 3.5, .rule = "a rule", .trust = "verified"}};
  const RopeChecks all = check_rope(use, rules);
  EXPECT_NEAR(value_of(all, "hoist.on_sheave"), (1 - 0.5 / std::sqrt(5)) * 160 / 35, 1e-12);
  EXPECT_EQ(
      std::count_if(all.checks.begin(), all.checks.end(), [](const Check& c) { return c.name == "hoist.on_sheave"; }),
      1);
}

// A factor that covers the bending takes nothing from one that does not.
TEST(RopeCheck, factors_of_both_kinds) {
  RopeRules rules;
  rules.safety_factors = {
      {.value = 3, .rule = "skyline", .trust = "verified"},
      {.value = 2.5, .rule = "stay", .trust = "verified", .covers_bending = true, .covers_ends = true}};
  rules.termination = Limit{.value = 0.8, .rule = "clips", .trust = "verified"};
  rules.least_termination = Limit{.value = 0.8, .rule = "at least", .trust = "verified"};
  const RopeChecks all = check_rope(hoist_rope(), rules);
  EXPECT_EQ(find(all, "hoist.on_sheave")->limit, 3);
  EXPECT_EQ(find(all, "hoist.termination")->limit, 0.8);  // 0.8 of 0.8 is nearer to its limit than 4.27 of 3
  RopeUse slender = hoist_rope();
  slender.ends[0].tension = 50e3;
  const RopeChecks weak = check_rope(slender, rules);
  EXPECT_NEAR(value_of(weak, "hoist.termination"), 0.8 * 160 / 50, 1e-12);
  EXPECT_FALSE(find(weak, "hoist.termination")->passes);
}

// A ropeway's factor covers the bending, not the ends: 0.8 x 160/30 at the hook.
TEST(RopeCheck, a_factor_that_covers_the_bending_alone) {
  RopeRules rules;
  rules.safety_factors = {{.value = 4.5, .rule = "ropeway", .trust = "verified", .covers_bending = true}};
  rules.termination = Limit{.value = 0.8, .rule = "clips", .trust = "verified"};
  const RopeChecks all = check_rope(hoist_rope(), rules);
  EXPECT_EQ(find(all, "hoist.on_sheave"), nullptr);
  EXPECT_NEAR(value_of(all, "hoist.termination"), 0.8 * 160 / 30, 1e-12);
  EXPECT_FALSE(find(all, "hoist.termination")->passes);
}

// What the deck asks for and cannot be made is said.
TEST(RopeCheck, what_is_asked_for_is_made_or_left_out) {
  RopeUse use = hoist_rope();
  use.unmeasured = {"'lost'"};
  use.ends.clear();
  RopeRules rules;
  rules.safety_factors = {{.value = 3, .rule = "a rule", .trust = "user"}};
  rules.bending_asked = true;
  rules.termination = Limit{.value = 0.5, .rule = "knot", .trust = "user"};
  const RopeChecks all = check_rope(use, rules);
  ASSERT_EQ(all.left_out.size(), 2U);
  EXPECT_NE(all.left_out[0].find("no end of it is fixed"), std::string::npos);
  EXPECT_NE(all.left_out[1].find("no diameter is known of 'lost'"), std::string::npos);
}

TEST(RopeCheck, a_crane_factor_has_the_bending_in_it) {
  RopeRules rules;
  rules.safety_factors = {
      {.value = 4.5, .rule = "ISO 4308-1", .trust = "verified", .covers_bending = true, .covers_ends = true}};
  rules.termination = Limit{.value = 0.75, .rule = "wedge", .trust = "verified"};
  rules.least_termination = Limit{.value = 0.8, .rule = "at least", .trust = "UNVERIFIED: recalled"};
  const RopeChecks all = check_rope(hoist_rope(), rules);
  EXPECT_EQ(find(all, "hoist.on_sheave"), nullptr);
  EXPECT_FALSE(find(all, "hoist.safety_factor")->passes);
  EXPECT_FALSE(find(all, "hoist.termination")->passes);
}

TEST(RopeCheck, peak_is_the_larger_of_factor_and_motion) {
  RopeUse use = hoist_rope();
  RopeRules rules;
  rules.dynamic_factor = 1.5;
  rules.elastic_share = Limit{.value = 0.6, .rule = "share", .trust = "user"};
  rules.dynamic_safety = Limit{.value = 2.0, .rule = "own", .trust = "user"};
  EXPECT_DOUBLE_EQ(value_of(check_rope(use, rules), "hoist.elastic_limit"), 60e3);
  use.peak = 97e3;
  use.peak_where = "load drop";
  const RopeChecks all = check_rope(use, rules);
  EXPECT_DOUBLE_EQ(value_of(all, "hoist.elastic_limit"), 97e3);
  EXPECT_FALSE(find(all, "hoist.elastic_limit")->passes);  // 0.6 x 160 = 96
  EXPECT_NEAR(value_of(all, "hoist.dynamic_safety_factor"), 160.0 / 97, 1e-12);
}

// 0.6 F_min of the tables leaves no factor for wear: it may fail, but a rope does not pass by it. The deck's own may.
TEST(RopeCheck, only_the_decks_own_elastic_limit_is_a_limit_of_strength) {
  RopeRules rules;
  rules.elastic_share = Limit{.value = 0.6, .rule = "share", .trust = "UNVERIFIED: recalled"};
  const RopeChecks tables = check_rope(hoist_rope(), rules);
  EXPECT_TRUE(find(tables, "hoist.elastic_limit")->passes);
  EXPECT_FALSE(find(tables, "hoist.elastic_limit")->limits);
  EXPECT_TRUE(find(tables, "hoist.elastic_limit")->covers.empty());
  rules.own_elastic_share = true;
  EXPECT_TRUE(find(check_rope(hoist_rope(), rules), "hoist.elastic_limit")->limits);
}

// What is asked for and can't be answered is reported.
TEST(RopeCheck, what_no_rule_and_no_drum_answers) {
  RopeRules rules;
  rules.runs = true;
  rules.fleet_angle = Limit{.value = 0.03, .rule = "smooth", .trust = "user"};
  rules.layers = Limit{.value = 3, .rule = "grooved", .trust = "user"};
  rules.rated_pull = 50e3;
  RopeUse use = hoist_rope();
  const auto reported = [&](const std::string& words) {
    const RopeChecks all = check_rope(use, rules);
    return std::count_if(all.left_out.begin(), all.left_out.end(),
                         [&](const std::string& one) { return one.find(words) != std::string::npos; });
  };
  use.drums.clear();
  EXPECT_EQ(reported("D/d"), 0) << "nobody asked for it";
  EXPECT_EQ(check_rope(use, rules).remarks.size(), 1U);
  EXPECT_EQ(reported("it ends on no drum"), 3);
  use.drums = {
      {.name = "winch", .tension = 40e3, .fleet_angle = 0.01, .layers = {}, .first_radius = {}, .last_radius = {}}};
  EXPECT_EQ(reported("'face_width'"), 2);  // the fleet angle is known
  use.drums[0].layers = 2;
  EXPECT_EQ(reported("'face_width'"), 0);
  rules.sheave_ratios = {{.value = 18, .rule = "ladder", .trust = "user"}};
  EXPECT_EQ(reported("D/d"), 0);
}

// phi2 as recalled decides nothing in silence; the peak of a motion has no part of it.
TEST(RopeCheck, a_recalled_dynamic_factor_is_told) {
  RopeUse use = hoist_rope();
  RopeRules rules;
  rules.dynamic_factor = 1.5;
  rules.dynamic_trust = "UNVERIFIED: phi2 recalled";
  rules.dynamic_safety = Limit{.value = 2.0, .rule = "own", .trust = "user"};
  EXPECT_EQ(find(check_rope(use, rules), "hoist.dynamic_safety_factor")->trust, "UNVERIFIED: phi2 recalled");
  use.peak = 97e3;
  EXPECT_EQ(find(check_rope(use, rules), "hoist.dynamic_safety_factor")->trust, "user");
}

TEST(RopeCheck, heat_takes_strength_and_its_trust) {
  RopeRules rules;
  rules.safety_factors = {{.value = 3.5, .rule = "a rule", .trust = "verified"}};
  rules.temperature = 423.15;
  rules.hottest = Limit{.value = 473.15, .rule = "steel core", .trust = "UNVERIFIED: recalled"};
  rules.heat_strength = Limit{.value = 0.9, .rule = "up to 200 degC", .trust = "UNVERIFIED: recalled"};
  const RopeChecks all = check_rope(hoist_rope(), rules);
  EXPECT_DOUBLE_EQ(value_of(all, "hoist.safety_factor"), 3.6);
  EXPECT_TRUE(find(all, "hoist.safety_factor")->trust.starts_with("UNVERIFIED"));
  EXPECT_TRUE(find(all, "hoist.temperature")->passes);
  rules.temperature = 500;
  EXPECT_FALSE(find(check_rope(hoist_rope(), rules), "hoist.temperature")->passes);
}

TEST(RopeCheck, an_unverified_breaking_force_is_told) {
  RopeUse use = hoist_rope();
  use.rope.trust = catalogue::Trust::unverified;
  RopeRules rules;
  rules.safety_factors = {{.value = 3.5, .rule = "a rule", .trust = "verified"}};
  EXPECT_TRUE(find(check_rope(use, rules), "hoist.safety_factor")->trust.starts_with("UNVERIFIED"));
}

TEST(RopeCheck, wire_stress_and_groove) {
  RopeRules rules;
  rules.wire = Limit{.value = 0.05, .rule = "d/20", .trust = "user"};
  rules.bending_modulus = 80e9;
  rules.groove_pressure = Limit{.value = 10e6, .rule = "cast iron", .trust = "user"};
  const RopeChecks all = check_rope(hoist_rope(), rules);
  EXPECT_NEAR(value_of(all, "hoist.wire_stress"), 36e3 / 117.76e-6 + 80e9 * 0.0008 / 0.32, 1);
  EXPECT_NEAR(value_of(all, "hoist.groove_pressure"), 2 * 36e3 / (0.016 * 0.32), 1e-3);
  EXPECT_FALSE(find(all, "hoist.groove_pressure")->passes);
}

TEST(RopeCheck, drum_pull_in_the_last_layer) {
  RopeUse use = hoist_rope();
  use.drums = {
      {.name = "winch", .tension = 38e3, .fleet_angle = 0.02, .layers = 3, .first_radius = 0.2, .last_radius = 0.232}};
  RopeRules rules;
  rules.rated_pull = 45e3;
  rules.fleet_angle = Limit{.value = 0.0262, .rule = "smooth", .trust = "UNVERIFIED: recalled"};
  rules.layers = Limit{.value = 3, .rule = "grooved", .trust = "verified"};
  const RopeChecks all = check_rope(use, rules);
  EXPECT_NEAR(find(all, "hoist.last_layer_pull")->limit, 45e3 * 0.2 / 0.232, 1e-9);
  EXPECT_TRUE(find(all, "hoist.last_layer_pull")->passes);
  EXPECT_TRUE(find(all, "hoist.fleet_angle")->passes);
  EXPECT_TRUE(find(all, "hoist.drum_layers")->passes);
  use.drums[0].haul = 76e3;  // another rope pulls as much
  const RopeChecks both = check_rope(use, rules);
  EXPECT_EQ(find(both, "hoist.last_layer_pull")->value, 76e3);
  EXPECT_FALSE(find(both, "hoist.last_layer_pull")->passes);
}

TEST(RopeCheck, what_is_not_known_is_told) {
  RopeUse use = hoist_rope();
  use.rope.breaking_force = 0;
  use.rope.diameter = 0;
  RopeRules rules;
  rules.safety_factors = {{.value = 3.5, .rule = "a rule", .trust = "verified"}};
  rules.sheave_ratios = {{.value = 20, .rule = "a rule", .trust = "verified"}};
  const RopeChecks all = check_rope(use, rules);
  EXPECT_TRUE(all.checks.empty());
  EXPECT_EQ(all.left_out.size(), 2U);
}

// EN 13001-3-2 with D/d = 20: gamma 2.07; below the formula's range nothing is enough.
TEST(RopeCheck, en13001) {
  RopeUse use = hoist_rope();
  RopeRules rules;
  rules.resistance = Limit{.value = 0, .rule = "EN 13001-3-2", .trust = "UNVERIFIED: recalled"};
  rules.dynamic_factor = 1.2;
  rules.fatigue_history = 8;
  const RopeChecks all = check_rope(use, rules);
  EXPECT_NEAR(find(all, "hoist.resistance")->limit, 160e3 / 2.07, 1e-6);
  EXPECT_NEAR(value_of(all, "hoist.resistance"), 1.2 * 36e3, 1e-9);
  EXPECT_NEAR(find(all, "hoist.fatigue")->limit, 160e3 / 14, 1e-6);
  use.bends[0].diameter = 0.08;
  EXPECT_FALSE(find(check_rope(use, rules), "hoist.resistance")->passes);
  // the peak of a motion that is larger than the factor says
  use = hoist_rope();
  use.peak = 1.5 * use.tension;
  use.last = use.tension;
  EXPECT_NEAR(value_of(check_rope(use, rules), "hoist.resistance"), 60e3, 1e-9);
  EXPECT_NEAR(value_of(check_rope(use, rules), "hoist.fatigue"), 60e3, 1e-9);
  use.peak = 1.01 * use.tension;
  EXPECT_NEAR(value_of(check_rope(use, rules), "hoist.resistance"), 1.2 * 36e3, 1e-9);
  EXPECT_NEAR(value_of(check_rope(use, rules), "hoist.fatigue"), 1.2 * 40e3, 1e-9);
}

/// A motion with more than twice the tension at rest takes loads that no state at rest has.
TEST(RopeCheck, beyond_a_sudden_load_the_tension_at_rest_is_not_known) {
  RopeRules rules;
  rules.safety_factors = {{.value = 3.5, .rule = "a rule", .trust = "verified"}};
  rules.dynamic_factor = 1.5;
  rules.resistance = Limit{.value = 0, .rule = "EN 13001-3-2", .trust = "verified"};
  RopeUse use = hoist_rope();  // 160 kN over 40 kN at rest
  const auto with = [&](double rest, double peak) {
    use.tension = use.bends[0].tension = use.ends[0].tension = rest;
    use.peak = peak;
    use.peak_where = "drop, t = 1 s";
    return check_rope(use, rules);
  };
  EXPECT_DOUBLE_EQ(value_of(with(40e3, 80e3), "hoist.safety_factor"), 4);
  EXPECT_TRUE(with(40e3, 80e3).left_out.empty());

  const RopeChecks enough = with(15e3, 40e3);  // even the peak leaves 4
  EXPECT_DOUBLE_EQ(value_of(enough, "hoist.safety_factor"), 4);
  EXPECT_NE(find(enough, "hoist.safety_factor")->rule.find("drop, t = 1 s"), std::string::npos);
  EXPECT_NEAR(value_of(enough, "hoist.on_sheave"), (1 - 0.5 / std::sqrt(20)) * 4, 1e-12);
  EXPECT_DOUBLE_EQ(value_of(enough, "hoist.resistance"), 40e3) << "the peak has the dynamic factor in it";
  EXPECT_TRUE(enough.left_out.empty());

  for (const double rest : {0.0, 15e3}) {
    const RopeChecks unknown = with(rest, 64e3);  // 2.5 at the peak
    EXPECT_EQ(find(unknown, "hoist.safety_factor"), nullptr);
    EXPECT_EQ(find(unknown, "hoist.on_sheave"), nullptr);
    ASSERT_EQ(unknown.left_out.size(), 2U);
    EXPECT_NE(unknown.left_out[0].find("hoist.safety_factor is not checked: the motion reaches 64 kN"),
              std::string::npos)
        << unknown.left_out[0];
  }

  // an analysis at rest that has that already asks for no other one
  EXPECT_NE(with(15e3, 64e3).left_out[0].find("add an analysis at rest"), std::string::npos);
  use.analysed = true;
  const std::string has_it = with(15e3, 64e3).left_out[0];
  EXPECT_EQ(has_it.find("add an analysis at rest"), std::string::npos) << has_it;
  EXPECT_NE(has_it.find("a stronger rope, or let the load come on with less slack"), std::string::npos) << has_it;
  EXPECT_NE(has_it.find("'dynamic_safety_factor'"), std::string::npos) << has_it;
  use.analysed = false;

  const RopeChecks broken = with(50e3, 150e3);  // 3.2 at rest
  EXPECT_DOUBLE_EQ(value_of(broken, "hoist.safety_factor"), 3.2);
  EXPECT_FALSE(find(broken, "hoist.safety_factor")->passes);
}

/// A motion that ends with more than the tension at rest has no state at rest with that load.
TEST(RopeCheck, what_a_motion_ends_with_may_stay) {
  RopeRules rules;
  rules.safety_factors = {{.value = 3.5, .rule = "a rule", .trust = "verified"}};
  RopeUse use = hoist_rope();  // 160 kN over 40 kN at rest
  use.peak = 60e3;
  use.peak_where = "lift, t = 1 s";
  use.last = 41e3;
  EXPECT_DOUBLE_EQ(value_of(check_rope(use, rules), "hoist.safety_factor"), 4) << "friction and small swings";
  use.last = 55e3;
  const RopeChecks unknown = check_rope(use, rules);
  EXPECT_EQ(find(unknown, "hoist.safety_factor"), nullptr);
  ASSERT_FALSE(unknown.left_out.empty());
  EXPECT_NE(unknown.left_out[0].find("the motion ends with 55 kN on average, more than the largest tension at rest, "
                                     "40 kN"),
            std::string::npos)
      << unknown.left_out[0];
  // 40 kN are of the motion itself: it is not called one at rest
  use.lasts = true;
  use.where = "lift, for 10 s until t = 12 s";
  const RopeChecks moves = check_rope(use, rules);
  ASSERT_FALSE(moves.left_out.empty());
  EXPECT_NE(moves.left_out[0].find("more than the largest tension that lasts, 40 kN (lift, for 10 s until t = 12 s)"),
            std::string::npos)
      << moves.left_out[0];
  rules.safety_factors[0].value = 2.5;  // 160/60 = 2.67 at the peak
  EXPECT_TRUE(find(check_rope(use, rules), "hoist.safety_factor")->passes);
}

TEST(RopeCheck, what_has_no_tension_in_it_is_judged_at_any) {
  RopeRules rules;
  rules.termination = Limit{.value = 0.75, .rule = "wedge", .trust = "verified"};
  rules.least_termination = Limit{.value = 0.8, .rule = "at least", .trust = "user"};
  RopeUse use = hoist_rope();
  use.tension = 0;
  use.peak = 150e3;
  const RopeChecks all = check_rope(use, rules);
  ASSERT_NE(find(all, "hoist.termination"), nullptr);
  EXPECT_FALSE(find(all, "hoist.termination")->passes);
}

TEST(RopeCheck, what_sheaves_without_a_diameter_leave_open) {
  RopeUse use = hoist_rope();
  use.bends.clear();
  use.unmeasured = {"'head'"};
  RopeRules rules;
  rules.sheave_ratios = {{.value = 20, .rule = "a rule", .trust = "verified"}};
  EXPECT_TRUE(check_rope(use, rules).left_out.empty()) << "nobody has asked";
  rules.ratio_asked = true;
  rules.groove_pressure = Limit{.value = 5e6, .rule = "own", .trust = "user"};
  rules.resistance = Limit{.value = 0, .rule = "EN", .trust = "verified"};
  const auto left = check_rope(use, rules).left_out;
  ASSERT_EQ(left.size(), 3U);
  for (const std::string& words : left)
    EXPECT_NE(words.find("no diameter is known of 'head'"), std::string::npos) << words;
  use.unmeasured.clear();
  const auto over_nothing = check_rope(use, rules).left_out;
  ASSERT_EQ(over_nothing.size(), 1U);
  EXPECT_EQ(over_nothing[0], "hoist: EN 13001-3-2 is not checked: no sheave or drum bends it under tension");
}

TEST(RopeCheck, a_termination_needs_a_factor) {
  RopeRules rules;
  rules.termination = Limit{.value = 0.4, .rule = "own", .trust = "user"};
  rules.dynamic_safety = Limit{.value = 2.2, .rule = "own", .trust = "user"};
  const RopeChecks all = check_rope(hoist_rope(), rules);
  EXPECT_EQ(find(all, "hoist.termination"), nullptr);
  ASSERT_EQ(all.left_out.size(), 1U);
  EXPECT_NE(all.left_out[0].find("its termination is not checked"), std::string::npos);
}

TEST(RopeCheck, each_drum_needs_its_data_and_bears_all_copies) {
  RopeUse use = hoist_rope();
  use.copies = 2;
  DrumEnd first{
      .name = "d1", .tension = 20e3, .fleet_angle = 0.01, .layers = 1, .first_radius = 0.2, .last_radius = 0.2};
  DrumEnd second = first;
  second.name = "d2";
  second.fleet_angle.reset();
  use.drums = {first, second};
  RopeRules rules;
  rules.fleet_angle = Limit{.value = 0.035, .rule = "own", .trust = "user"};
  rules.rated_pull = 25e3;
  const RopeChecks all = check_rope(use, rules);
  EXPECT_EQ(value_of(all, "hoist.last_layer_pull"), 40e3);
  ASSERT_EQ(all.left_out.size(), 1U);
  EXPECT_NE(all.left_out[0].find("'d2'"), std::string::npos) << all.left_out[0];
}

// Of a rope without a breaking force the result names every limit of strength that it leaves out.
TEST(RopeCheck, no_strength_is_told) {
  RopeRules rules;
  rules.dynamic_safety = Limit{.value = 4, .rule = "of the deck", .trust = "user"};
  rules.resistance = Limit{.value = 1, .rule = "EN 13001-3-2", .trust = "user"};
  RopeUse use = hoist_rope();
  use.rope.breaking_force = 0;
  const RopeChecks all = check_rope(use, rules);
  const auto told = [&](const std::string& words) {
    return std::any_of(all.left_out.begin(), all.left_out.end(),
                       [&](const std::string& one) { return one.find(words) != std::string::npos; });
  };
  EXPECT_TRUE(told("its dynamic strength is not checked: the breaking force is not known"));
  EXPECT_TRUE(told("EN 13001-3-2 is not checked: the breaking force is not known"));
}

// The weakening on sheaves lowers a safety factor at rest: without one there is nothing to lower.
TEST(RopeCheck, weakening_needs_a_factor_at_rest) {
  RopeRules rules;
  rules.bending_asked = true;
  rules.dynamic_safety = Limit{.value = 3, .rule = "of the deck", .trust = "user"};
  const RopeChecks all = check_rope(hoist_rope(), rules);
  ASSERT_FALSE(all.left_out.empty());
  EXPECT_NE(all.left_out.front().find("the weakening on sheaves is not checked"), std::string::npos);
}

// Too hot for the tables: no strength, so no check of it, and none that passes.
TEST(RopeCheck, without_a_known_strength_there_is_no_number) {
  RopeRules rules;
  rules.safety_factors = {{.value = 1, .rule = "a rule", .trust = "verified"}};
  rules.elastic_share = Limit{.value = 0.6, .rule = "own", .trust = "user"};
  rules.resistance = Limit{.value = 0, .rule = "EN 13001-3-2", .trust = "UNVERIFIED: recalled"};
  rules.termination = Limit{.value = 0.8, .rule = "wedge", .trust = "verified"};
  rules.temperature = 693.15;
  rules.hottest = Limit{.value = 673.15, .rule = "steel core", .trust = "UNVERIFIED: recalled"};
  rules.no_strength = "no strength is known at 420 degC";
  const RopeChecks all = check_rope(hoist_rope(), rules);
  ASSERT_EQ(all.checks.size(), 1U);
  EXPECT_FALSE(find(all, "hoist.temperature")->passes);
  EXPECT_EQ(std::count_if(all.left_out.begin(), all.left_out.end(),
                          [](const auto& one) { return one.find("known at 420 degC") != std::string::npos; }),
            3);
}

// A candidate of a design whose construction no rule of D/d knows is not judged; of a given rope that is a remark.
TEST(RopeCheck, no_rule_for_a_candidate_is_told) {
  RopeUse use = hoist_rope();
  RopeRules rules;
  rules.runs = true;
  EXPECT_TRUE(check_rope(use, rules).left_out.empty());
  EXPECT_EQ(check_rope(use, rules).remarks.size(), 1U);
  use.chosen = true;
  ASSERT_EQ(check_rope(use, rules).left_out.size(), 1U);
  EXPECT_NE(check_rope(use, rules).left_out[0].find("no rule is for its construction 6x36"), std::string::npos);
  rules.runs = false;
  EXPECT_TRUE(check_rope(use, rules).left_out.empty());
}

// Three numbers are doubted in the factor at the end of a hot rope, each by a source of its own.
TEST(RopeCheck, every_doubt_has_its_source) {
  RopeUse use = hoist_rope();
  use.rope.id = "own rope";
  use.rope.trust = catalogue::Trust::unverified;
  RopeRules rules;
  rules.safety_factors = {{.value = 3.5, .rule = "ISO 4308", .trust = "UNVERIFIED: factor"}};
  rules.heat_strength = Limit{.value = 0.9, .rule = "EN 12385-3", .trust = "UNVERIFIED: heat"};
  const Check factor = *find(check_rope(use, rules), "hoist.safety_factor");
  EXPECT_EQ(factor.trust, "UNVERIFIED: factor");
  ASSERT_EQ(factor.doubts.size(), 3U);
  EXPECT_EQ(factor.doubts[0].source, "ISO 4308");
  EXPECT_EQ(factor.doubts[1].source, "EN 12385-3");
  EXPECT_EQ(factor.doubts[2].source, "breaking force of the rope own rope");
}

}  // namespace taut::rope::rope_check_test
