#include "taut/catalogue/rule.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

namespace taut::catalogue::rule_test {

TEST(Rules, the_built_in_tables) {
  std::set<std::string> ids;
  for (const RuleRow& rule : rules()) {
    EXPECT_TRUE(ids.insert(rule.id).second) << rule.id;
    EXPECT_FALSE(rule.trust_text.empty()) << rule.id;
    EXPECT_FALSE(rule.source.empty()) << rule.id;
    EXPECT_TRUE(rule.low || !rule.text.empty()) << rule.id;
  }
  for (const char* topic :
       {"safety", "ratio", "groove", "friction", "sheave", "termination", "buckling", "hoist", "layout", "modulus"}) {
    EXPECT_FALSE(rules_of(topic).empty()) << topic;
  }
  EXPECT_EQ(rules_of("safety.crane_running").size(), 9U);
  EXPECT_TRUE(rules_of("saf").empty());
}

TEST(Rules, values) {
  const auto value = [](std::string_view id) { return find_rule(id).and_then(value_of); };
  EXPECT_EQ(value("safety.crane_running.M5"), 4.5);
  EXPECT_EQ(value("Safety.Skyline.CH"), 3.0);
  EXPECT_EQ(value("buckling.c"), 0.49);
  EXPECT_EQ(value("hoist.HC2.beta2"), 0.34);
  EXPECT_DOUBLE_EQ(value("layout.tail_tree_angle").value(), 50.0 * std::numbers::pi / 180.0);
  EXPECT_EQ(value("modulus.skyline_planning"), 100e9);
  EXPECT_NEAR(value("sheave.plain_bearing").value(), 1.0 / 1.09, 5e-5);
  EXPECT_EQ(find_rule("buckling.c")->trust, Trust::unverified);
}

TEST(Rules, what_is_not_a_number_says_so) {
  EXPECT_EQ(value_of(*find_rule("friction.mast_block")).error().message,
            "rule 'friction.mast_block' is a range, 0.1 to 0.16 1: choose a value in it");
  EXPECT_FALSE(value_of(*find_rule("friction.v_groove")));
  const auto none = find_rule("safety.crane_runing.M5");
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().candidates.front(), "safety.crane_running.M5");
}

// equal.
TEST(Rules, ladders_of_classes_only_rise) {
  for (const char* prefix : {"safety.crane_running.M", "safety.crane_stay.M", "ratio.crane_drum.M",
                             "ratio.crane_sheave.M", "ratio.crane_compensating_sheave.M"}) {
    double last = 0.0;
    for (int i = 1; i <= 8; ++i) {
      const auto rule = find_rule(fmt::format("{}{}", prefix, i));
      ASSERT_TRUE(rule) << prefix << i;
      EXPECT_GE(*rule->low, last) << rule->id;
      last = *rule->low;
    }
  }
  for (const RuleRow& rule : rules_of("termination")) EXPECT_LE(*rule.high, 1.0) << rule.id;
  for (const RuleRow& rule : rules_of("sheave")) EXPECT_LT(*rule.high, 1.0) << rule.id;
}

TEST(Rules, a_users_table) {
  const std::string header = "id,field,item,class,low,high,unit,text,source,trust\n";
  EXPECT_TRUE(read_rules(header + "a.b,,x,,1,2,deg,,book,verified\n", "r"));
  EXPECT_FALSE(read_rules(header + "a.b,,x,,2,1,deg,,book,verified\n", "r"));
  EXPECT_FALSE(read_rules(header + "a.b,,x,,1,,deg,,book,verified\n", "r"));
  EXPECT_FALSE(read_rules(header + "a.b,,x,,,,1,,book,verified\n", "r"));
  EXPECT_FALSE(read_rules(header + "a.b,,x,,1,1,furlong,,book,verified\n", "r"));
}

}  // namespace taut::catalogue::rule_test
