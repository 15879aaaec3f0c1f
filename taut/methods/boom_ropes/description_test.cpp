#include <gtest/gtest.h>

#include <set>

#include "taut/methods/boom_ropes/boom_ropes.hpp"

namespace taut::boom_ropes::description_test {

TEST(BoomDescription, KeysOfTheDeck) {
  for (const char* key : {"section_weight", "pad_friction", "tackle_efficiency", "extension_stiffness",
                          "retraction_stiffness", "tensioned_last", "tensioning_steps", "cases", "sliding"}) {
    EXPECT_NE(Input::describe().find(key), nullptr) << key;
  }
  for (const char* key : {"stroke",
                          "head_distance",
                          "center_3",
                          "center_2",
                          "overlap_23",
                          "overlap_12",
                          "gap",
                          "pad_height_3",
                          "pad_height_2",
                          "offset_extension",
                          "offset_retraction",
                          "offset_hoist",
                          "offset_lead",
                          "offset_cylinder",
                          "section2_weight",
                          "sheave_efficiency_1",
                          "sheave_efficiency_2",
                          "extension_length",
                          "retraction_length",
                          "S10",
                          "S20",
                          "kinetic_friction",
                          "extension_stiffness",
                          "retraction_stiffness",
                          "boom_length",
                          "luffing_angle",
                          "suspended_weight",
                          "operation"}) {
    EXPECT_NE(Sliding::describe().find(key), nullptr) << key;
  }
}

TEST(BoomDescription, NoKeyTwice) {
  for (const Description* d :
       {&Input::describe(), &Sliding::describe(), &Case::describe(), &Slip::describe(), &Output::describe()}) {
    std::set<std::string> seen;
    for (const Field& f : d->fields) EXPECT_TRUE(seen.insert(f.key).second) << f.key;
  }
}

TEST(BoomDescription, DefaultsAreInRange) {
  for (const Description* d : {&Input::describe(), &Sliding::describe(), &Case::describe(), &Slip::describe()}) {
    for (const Field& f : d->fields) {
      const auto x = default_number(*d, f);
      if (x && !f.required) {
        EXPECT_TRUE(f.range.contains(*x)) << f.key;
      }
    }
  }
}

TEST(BoomAbout, EveryErratumIsComplete) {
  EXPECT_EQ(about().name, "boom_ropes");
  for (const Erratum& e : about().errata) {
    EXPECT_FALSE(e.where.empty() || e.correct.empty() || e.evidence.empty()) << e.where;
    EXPECT_EQ(e.test.rfind("BoomRopesErrata.", 0), 0u) << e.test;
  }
}

}  // namespace taut::boom_ropes::description_test
