#include "taut/checks/rope/rope_rules.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace taut::checks::rope_rules_test {

catalogue::RopeRow six_strand(const std::string& core) {
  catalogue::RopeRow rope;
  rope.id = "mine";
  rope.construction = "6x36WS";
  rope.core = core;
  rope.diameter = 16e-3;
  return rope;
}

rope::RopeRules rules_for(const RopeCheckRequest& request, const catalogue::RopeRow& rope) {
  std::vector<Complaint> complaints;
  const AskedRules asked = asked_rules(request, "checks.ropes.x", complaints);
  complain_of_limits(request, asked, rope, "checks.ropes.x", complaints);
  EXPECT_TRUE(complaints.empty()) << complaints.front().path << complaints.front().message;
  return rope_rules(request, asked, rope);
}

std::string complaint_for(const RopeCheckRequest& request, const catalogue::RopeRow& rope) {
  std::vector<Complaint> complaints;
  const AskedRules asked = asked_rules(request, "checks.ropes.x", complaints);
  complain_of_limits(request, asked, rope, "checks.ropes.x", complaints);
  return complaints.empty() ? std::string() : complaints.front().path + ": " + complaints.front().message;
}

// US Army TM 5-3810-305-10: sleeve 0.95 with a steel core, 0.925 with fibre; of an unknown core the weaker one.
TEST(RopeRules, termination_by_core) {
  RopeCheckRequest request;
  request.termination = "sleeve";
  EXPECT_EQ(rules_for(request, six_strand("IWRC")).termination->value, 0.95);
  EXPECT_EQ(rules_for(request, six_strand("FC")).termination->value, 0.925);
  EXPECT_EQ(rules_for(request, six_strand("")).termination->value, 0.925);
  request.termination = "wedge";  // the only one that begins so; of 0.75 to 0.95 the safe end
  EXPECT_EQ(rules_for(request, six_strand("IWRC")).termination->value, 0.75);
  request.termination_efficiency = 0.9;
  EXPECT_EQ(rules_for(request, six_strand("IWRC")).termination->trust, "user");
  request = {};
  request.termination = "glue";
  EXPECT_NE(complaint_for(request, six_strand("IWRC")).find("there is no termination 'glue'"), std::string::npos);
  request.termination = "swaged_socket";
  EXPECT_NE(complaint_for(request, six_strand("FC")).find("no efficiency of 'swaged_socket' for a fibre core"),
            std::string::npos);
}

// A machine at 350 degC has ropes of that temperature; one at 60 degC says nothing of them.
TEST(RopeRules, a_hot_machine_has_hot_ropes) {
  const auto in = [](double around, const std::optional<double>& own = {}) {
    RopeCheckRequest request;
    request.temperature = own;
    std::vector<Complaint> complaints;
    return rope_rules(request, asked_rules(request, "checks.ropes.x", complaints), six_strand("IWRC"), around);
  };
  EXPECT_EQ(in(623.15).temperature, 623.15);
  EXPECT_EQ(in(623.15).heat_strength->value, 0.65);
  EXPECT_FALSE(in(623.15).hottest_end);
  EXPECT_FALSE(in(333.15).temperature);
  EXPECT_FALSE(in(333.15).heat_strength);
  EXPECT_EQ(in(623.15, 293.15).temperature, 293.15) << "the deck's own word counts";
}

// TM 5-3810-305-10 has sleeves up to 1 in. and one size of hand splices: beyond, and of an unknown diameter, no number.
TEST(RopeRules, termination_by_diameter) {
  RopeCheckRequest request;
  request.termination = "sleeve";
  catalogue::RopeRow rope = six_strand("IWRC");
  rope.diameter = 25.4e-3;
  EXPECT_EQ(rules_for(request, rope).termination->value, 0.95);
  rope.diameter = 28e-3;
  EXPECT_NE(complaint_for(request, rope).find("no efficiency of 'sleeve' for a rope of 28 mm (they hold up to 25.4 mm"),
            std::string::npos);
  rope.diameter = 0;
  EXPECT_NE(complaint_for(request, rope).find("whose diameter is not known"), std::string::npos);
  rope.diameter = 32e-3;
  request.termination = "hand_splice";
  EXPECT_NE(complaint_for(request, rope).find("up to 12.7 mm"), std::string::npos);
  request.termination_efficiency = 0.8;
  EXPECT_EQ(rules_for(request, rope).termination->value, 0.8);
}

// More fields never ask for less: each factor says for itself whether bending and ends are in it.
TEST(RopeRules, each_field_covers_its_own_bending) {
  RopeCheckRequest request;
  request.field = {"skyline.ch", "crane_stay"};
  request.group = "M1";
  const auto both = rules_for(request, six_strand("IWRC"));
  ASSERT_EQ(both.safety_factors.size(), 2U);
  EXPECT_FALSE(both.safety_factors[0].covers_bending);
  EXPECT_TRUE(both.safety_factors[1].covers_bending);
  request.safety_factor = 4;  // of the deck: only where all fields cover it
  EXPECT_FALSE(rules_for(request, six_strand("IWRC")).safety_factors[2].covers_bending);
  request.field = {"crane_stay"};
  EXPECT_TRUE(rules_for(request, six_strand("IWRC")).safety_factors[1].covers_bending);
  request.sheave_weakening = Choose::yes;
  const auto counts = rules_for(request, six_strand("IWRC"));
  EXPECT_TRUE(counts.bending_asked);
  for (const rope::Limit& limit : counts.safety_factors) EXPECT_FALSE(limit.covers_bending);
}

// Ropeways cover the bending alone, and so does a deck's word; cranes the ends too, by their least termination.
TEST(RopeRules, ends_are_covered_by_cranes_alone) {
  RopeCheckRequest request;
  request.termination = "clips";
  request.field = {"ropeway_track"};
  const auto ropeway = rules_for(request, six_strand("IWRC"));
  EXPECT_TRUE(ropeway.safety_factors[0].covers_bending);
  EXPECT_FALSE(ropeway.safety_factors[0].covers_ends);
  EXPECT_FALSE(ropeway.least_termination);
  request.field.clear();
  request.safety_factor = 3.5;
  request.sheave_weakening = Choose::no;
  const auto own = rules_for(request, six_strand("IWRC"));
  EXPECT_TRUE(own.safety_factors[0].covers_bending);
  EXPECT_FALSE(own.safety_factors[0].covers_ends);
  request = {};
  request.termination = "clips";
  request.field = {"crane_running.en13001"};
  EXPECT_EQ(rules_for(request, six_strand("IWRC")).least_termination->value, 0.8);
  request.field = {"crane_running"};
  request.group = "M5";
  const auto crane = rules_for(request, six_strand("IWRC"));
  EXPECT_TRUE(crane.safety_factors[0].covers_ends);
  EXPECT_TRUE(crane.least_termination);
}

TEST(RopeRules, a_class_that_there_is_not_is_one_mistake) {
  RopeCheckRequest request;
  request.group = "M9";
  for (const auto& fields : std::vector<std::vector<std::string>>{
           {}, {"crane_running"}, {"crane_stay"}, {"crane_running", "crane_stay"}, {"skyline.ch"}}) {
    request.field = fields;
    std::vector<Complaint> complaints;
    asked_rules(request, "checks.ropes.x", complaints);
    ASSERT_EQ(complaints.size(), 1U) << fields.size();
    EXPECT_EQ(complaints[0].path, "checks.ropes.x.class");
  }
}

TEST(RopeRules, what_is_no_safety_factor_is_refused) {
  RopeCheckRequest request;
  for (const char* field : {"skyline_elastic_limit", "skyline_extension.us_wa"}) {
    request.field = {field};
    EXPECT_FALSE(complaint_for(request, six_strand("IWRC")).empty()) << field;
  }
}

TEST(RopeRules, wire_stress_needs_the_wires) {
  RopeCheckRequest request;
  request.wire_diameter = 1e-3;
  EXPECT_NE(complaint_for(request, six_strand("IWRC")).find("'diameter', 'area' and 'grade'"), std::string::npos);
  catalogue::RopeRow rope = six_strand("IWRC");
  rope.area = 1e-4;
  rope.grade = 1770e6;
  EXPECT_NEAR(rules_for(request, rope).wire->value, 1.0 / 16, 1e-12);
}

TEST(RopeRules, heat_by_core_and_end) {
  RopeCheckRequest request;
  request.temperature = 273.15 + 250;
  request.termination = "socket";
  const auto steel = rules_for(request, six_strand("IWRC"));
  EXPECT_NEAR(steel.hottest->value, 673.15, 1e-9);
  EXPECT_EQ(steel.heat_strength->value, 0.75);
  EXPECT_NEAR(steel.hottest_end->value, 388.15, 1e-9);
  EXPECT_NE(steel.hottest_end->trust.find("UNVERIFIED"), std::string::npos);
  const auto fibre = rules_for(request, six_strand("FC"));
  EXPECT_NEAR(fibre.hottest->value, 373.15, 1e-9);
  EXPECT_FALSE(fibre.heat_strength);
  request.termination = "clips";  // of which the tables say nothing
  EXPECT_FALSE(rules_for(request, six_strand("IWRC")).hottest_end);
}

TEST(RopeRules, fields_and_classes) {
  RopeCheckRequest request;
  request.field = {"crane_running"};
  EXPECT_NE(complaint_for(request, six_strand("IWRC")).find("needs a 'class'"), std::string::npos);
  request.group = "M9";
  EXPECT_NE(complaint_for(request, six_strand("IWRC")).find("no class 'M9'"), std::string::npos);
  request.group = "M5";
  const auto crane = rules_for(request, six_strand("IWRC"));
  EXPECT_EQ(crane.safety_factors.at(0).value, 4.5);
  EXPECT_TRUE(crane.safety_factors[0].covers_bending);
  EXPECT_FALSE(crane.sheave_ratios.empty());
  request.field = {"skyline.ch", "skyline.ru"};  // stands: no D/d; 2.5 to 3 the safe end
  request.group.reset();
  const auto skyline = rules_for(request, six_strand("IWRC"));
  EXPECT_EQ(skyline.safety_factors.size(), 2U);
  EXPECT_EQ(skyline.safety_factors[1].value, 3);
  EXPECT_TRUE(skyline.sheave_ratios.empty());
  request.field = {"skyline"};  // whose? no class has to do with it
  EXPECT_EQ(complaint_for(request, six_strand("IWRC")),
            "checks.ropes.x.field[0]: 'skyline' has rules by country: give skyline.ch or skyline.ru");
  request.group = "M4";
  EXPECT_NE(complaint_for(request, six_strand("IWRC")).find("give skyline.ch or skyline.ru"), std::string::npos);
  request.field = {"tether"};
  EXPECT_NE(complaint_for(request, six_strand("IWRC")).find("give tether.us_or"), std::string::npos);
  request.group.reset();
  request.field = {"skylin.ch"};
  EXPECT_NE(complaint_for(request, six_strand("IWRC")).find("skyline.ch"), std::string::npos);
}

TEST(RopeRules, one_dynamic_factor) {
  RopeCheckRequest request;
  request.dynamic_factor = 1.4;
  EXPECT_EQ(rules_for(request, six_strand("IWRC")).dynamic_factor, 1.4);
  request.hoist = HoistRequest{.hoisting_class = HoistClass::HC3, .speed = 0.5};
  EXPECT_NE(complaint_for(request, six_strand("IWRC")).find("either"), std::string::npos);
  request.dynamic_factor.reset();
  EXPECT_NEAR(rules_for(request, six_strand("IWRC")).dynamic_factor, 1.15 + 0.51 * 0.5, 1e-12);
}

TEST(RopeRules, a_request_adds_what_the_rope_has_not) {
  RopeCheckRequest request;
  request.construction = "8x36WS-IWRC";
  request.breaking_force = 1e5;
  request.grade = 1770e6;
  catalogue::RopeRow unknown = six_strand("FC");
  unknown.breaking_force = 0;
  unknown.grade.reset();
  const auto rope = with_request(unknown, request);
  EXPECT_EQ(rope.core, "IWRC");
  EXPECT_EQ(rope.breaking_force, 1e5);
  EXPECT_EQ(rope.trust, catalogue::Trust::verified);  // its user answers for it
  EXPECT_EQ(rope.diameter, 16e-3);
}

// Another value of `checks:` would hide the rope's own one, and relax the check.
TEST(RopeRules, a_second_value_of_the_rope_is_refused) {
  RopeCheckRequest request;
  request.breaking_force = 3e5;
  catalogue::RopeRow row = six_strand("FC");
  row.breaking_force = 1e5;
  EXPECT_EQ(with_request(row, request).breaking_force, 1e5);
  std::vector<Complaint> complaints;
  complain_of_values(request, row, "checks.ropes.a", complaints);
  ASSERT_EQ(complaints.size(), 1U);
  EXPECT_EQ(complaints[0].path, "checks.ropes.a.breaking_force");
  request.breaking_force = 1e5;
  complain_of_values(request, row, "checks.ropes.a", complaints);
  row.breaking_force = 0;
  request.breaking_force = 3e5;
  complain_of_values(request, row, "checks.ropes.a", complaints);
  EXPECT_EQ(complaints.size(), 1U);
}

TEST(RopeRules, an_unknown_core_is_no_steel) {
  RopeCheckRequest request;
  request.core = "sisal";
  EXPECT_NE(complaint_for(request, six_strand("IWRC")).find("there is no core 'sisal'"), std::string::npos);
}

// "ferrule" means the one termination whose name begins so, for its strength and for its temperature.
TEST(RopeRules, an_abbreviated_termination_has_its_temperature) {
  RopeCheckRequest request;
  request.temperature = 400;
  for (const char* name : {"ferrule", "ferrule_eye"}) {
    request.termination = name;
    const auto rules = rules_for(request, six_strand("IWRC"));
    ASSERT_TRUE(rules.hottest_end && rules.termination) << name;
    EXPECT_NEAR(rules.hottest_end->value, 150 + 273.15, 1e-9) << name;
  }
}

// A number of the deck's own changes neither where a termination may be used nor how hot it may be.
TEST(RopeRules, an_efficiency_is_no_other_termination) {
  RopeCheckRequest request;
  request.temperature = 400;
  request.termination_efficiency = 0.85;
  for (const char* name : {"ferrule", "ferrule_eye"}) {
    request.termination = name;
    const auto rules = rules_for(request, six_strand("IWRC"));
    ASSERT_TRUE(rules.hottest_end) << name;
    EXPECT_NEAR(rules.hottest_end->value, 150 + 273.15, 1e-9) << name;
    EXPECT_EQ(rules.termination->value, 0.85);
    EXPECT_EQ(rules.termination->trust, "user");
  }
  request.termination = "u_bolt_grips";
  EXPECT_TRUE(rules_for(request, six_strand("IWRC")).termination_refused.empty());
  request.field = {"crane_stay"};
  request.group = "M5";
  EXPECT_NE(rules_for(request, six_strand("IWRC")).termination_refused.find("not for lifting"), std::string::npos);
  for (const char* wrong : {"sokcet", "hand splice", "hand"}) {
    request.termination = wrong;
    EXPECT_NE(complaint_for(request, six_strand("IWRC")).find("there is no termination '"), std::string::npos) << wrong;
  }
}

TEST(RopeRules, the_fatigue_proof_needs_the_number_of_bendings) {
  RopeCheckRequest request;
  request.en13001 = En13001Request{};
  EXPECT_FALSE(rules_for(request, six_strand("IWRC")).fatigue_history);
  request.en13001->factor = 1;
  EXPECT_NE(complaint_for(request, six_strand("IWRC")).find("en13001: 'spectrum' and 'factor'"), std::string::npos);
  request.en13001->bends = 5e5;
  EXPECT_DOUBLE_EQ(*rules_for(request, six_strand("IWRC")).fatigue_history, 1);
  request.en13001->spectrum = 0.2;
  EXPECT_DOUBLE_EQ(*rules_for(request, six_strand("IWRC")).fatigue_history, 0.2);
}

// A class that the field of use does not need asks for D/d; that of a stay is its factor's.
TEST(RopeRules, a_class_is_never_ignored) {
  RopeCheckRequest request;
  request.group = "M8";
  request.field = {"skyline.ch"};
  const auto ratios = [&] { return rules_for(request, six_strand("IWRC")).sheave_ratios.size(); };
  EXPECT_GT(ratios(), 0U);
  EXPECT_TRUE(rules_for(request, six_strand("IWRC")).ratio_asked);
  request.running = Choose::no;
  EXPECT_EQ(ratios(), 0U);
  request.running = Choose::by_field;
  request.field = {"crane_stay"};
  EXPECT_EQ(ratios(), 0U);
  request.field = {"skyline.ch"};
  request.group = "M9";
  EXPECT_NE(complaint_for(request, six_strand("IWRC")).find("there is no class 'M9'"), std::string::npos);
}

// ISO 4308-1 as the tables have it: M5 is Z_p 4.5, D/d 20 of sheaves and 18 of drums. However the class is said.
TEST(RopeRules, a_field_that_names_its_class_has_all_that_goes_by_it) {
  RopeCheckRequest request;
  request.running = Choose::by_field;
  const auto is_of_M5 = [&](const char* words) {
    const auto rules = rules_for(request, six_strand("FC"));
    EXPECT_EQ(rules.safety_factors.at(0).value, 4.5) << words;
    EXPECT_EQ(rules.sheave_ratios.at(0).value, 20) << words;
    EXPECT_EQ(rules.drum_ratios.at(0).value, 18) << words;
    EXPECT_TRUE(rules.ratio_asked) << words;
    EXPECT_EQ(rules.group, "M5") << words;
  };
  request.field = {"crane_running"};
  request.group = "m5";
  is_of_M5("class: m5");
  request.field = {"crane_running.M5"};
  is_of_M5("both");
  request.group.reset();
  is_of_M5("the field alone");
  request.field = {"safety.crane_running.M5"};
  is_of_M5("the id of the rule");
  request.field = {"crane_stay.M5"};
  EXPECT_TRUE(rules_for(request, six_strand("FC")).sheave_ratios.empty()) << "a stay does not run";
}

TEST(RopeRules, a_rope_has_one_class) {
  RopeCheckRequest request;
  request.field = {"crane_running.M5"};
  request.group = "M1";
  EXPECT_EQ(
      complaint_for(request, six_strand("FC")),
      "checks.ropes.x.field[0]: 'crane_running.M5' is of the class M5, and 'class' says M1: a rope has one class");
  request.group.reset();
  request.field = {"crane_running.M5", "crane_stay.M3"};
  EXPECT_EQ(
      complaint_for(request, six_strand("FC")).find("checks.ropes.x.field[1]: 'crane_stay.M3' is of the class M3"), 0U);
}

// EN 12385-3: fibre cores up to 100 degC, steel cores up to 400 degC. Beyond there is no share, not that of a cold
// rope.
TEST(RopeRules, beyond_the_last_temperature_no_strength_is_known) {
  RopeCheckRequest request;
  const auto at = [&](double celsius, const char* core) {
    request.temperature = 273.15 + celsius;
    return rules_for(request, six_strand(core));
  };
  EXPECT_EQ(rope::heat_share(at(400, "IWRC")), 0.65);
  EXPECT_TRUE(std::isnan(rope::heat_share(at(401, "IWRC"))));
  EXPECT_NE(at(401, "IWRC").no_strength.find("at 401 degC: the tables end at 400 degC"), std::string::npos);
  EXPECT_EQ(rope::heat_share(at(90, "FC")), 1);
  EXPECT_TRUE(std::isnan(rope::heat_share(at(150, "FC"))));
  EXPECT_TRUE(std::isnan(rope::heat_share(at(150, "")))) << "a fibre core is assumed";
  request.temperature.reset();
  EXPECT_EQ(rope::heat_share(rules_for(request, six_strand("FC"))), 1);
}

catalogue::RopeRow candidate(const std::string& construction, const RopeCheckRequest& request,
                             std::vector<std::string>& denied) {
  catalogue::RopeRow rope = six_strand("IWRC");
  rope.construction = construction;
  denied.clear();
  return candidate_with_request(rope, request, "checks.ropes.x", denied);
}

// What the deck says of a rope that a design chooses fills gaps, or it denies the candidate; it makes no other rope.
TEST(RopeRules, a_candidate_is_judged_by_its_own_row) {
  std::vector<std::string> denied;
  RopeCheckRequest request;
  request.construction = "6x36WS-IWRC";
  EXPECT_EQ(candidate("6x36", request, denied).construction, "6x36WS-IWRC") << "the row names the class alone";
  EXPECT_TRUE(denied.empty());
  EXPECT_EQ(candidate("", request, denied).construction, "6x36WS-IWRC");
  EXPECT_TRUE(denied.empty());
  EXPECT_EQ(candidate("6x7", request, denied).construction, "6x7");
  ASSERT_EQ(denied.size(), 1U);
  EXPECT_EQ(denied[0], "checks.ropes.x.construction: the rope has the construction 6x7");
  request = {};
  request.core = "FC";
  EXPECT_EQ(candidate("6x36", request, denied).core, "IWRC");
  ASSERT_EQ(denied.size(), 1U);
  EXPECT_EQ(denied[0], "checks.ropes.x.core: the rope has the core IWRC");
}

}  // namespace taut::checks::rope_rules_test
