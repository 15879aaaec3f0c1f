#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "taut/methods/closed_loop/closed_loop.hpp"

namespace taut::closed_loop::description_test {

TEST(ClosedLoopDescription, HasTheDeckKeys) {
  for (const char* key : {"span",
                          "slope",
                          "position",
                          "mode",
                          "sag",
                          "winch_pull",
                          "head_efficiency",
                          "loop_length",
                          "gathering_force",
                          "gathering_angle",
                          "return_weight",
                          "traction_weight",
                          "return_rope",
                          "traction_rope",
                          "tail_efficiency",
                          "carriage",
                          "section_distance",
                          "distance_kind",
                          "sag_of",
                          "position_of",
                          "branch_distance",
                          "branch_offset",
                          "carriage_weight",
                          "return_stiffness",
                          "traction_stiffness",
                          "roller",
                          "haul",
                          "safety_factor",
                          "wire_strength",
                          "weight_per_area",
                          "choose_ropes"}) {
    EXPECT_NE(Input::describe().find(key), nullptr) << key;
  }
}

TEST(ClosedLoopDescription, RequiredKeysAreFew) {
  std::set<std::string> required;
  for (const Field& f : Input::describe().fields) {
    if (f.required) required.insert(f.key);
  }
  EXPECT_EQ(required, (std::set<std::string>{"span", "gathering_force", "gathering_angle", "tail_efficiency"}));
}

TEST(ClosedLoopDescription, DefaultsAreThoseOfTheStruct) {
  const Description& d = Input::describe();
  EXPECT_EQ(default_text(d, *d.find("mode")), "sag");
  EXPECT_EQ(default_text(d, *d.find("roller")), "free");
  EXPECT_EQ(default_number(d, *d.find("weight_per_area")), 98066.5);
  EXPECT_EQ(default_number(d, *d.find("safety_factor")), std::nullopt);
}

TEST(ClosedLoopDescription, EveryValueSaysWhatItIs) {
  std::set<std::string> keys;
  for (const Field& f : Output::describe().fields) {
    EXPECT_FALSE(f.words.empty()) << f.key;
    EXPECT_TRUE(keys.insert(f.key).second) << f.key;
  }
  EXPECT_EQ(keys.size() * sizeof(double), sizeof(Output));  // no field forgotten
}

TEST(ClosedLoopAbout, SaysWhereItComesFromAndWhatItLeavesOut) {
  const Method& m = about();
  EXPECT_EQ(m.name, "closed_loop");
  EXPECT_NE(m.source.find("Martynikhin"), std::string::npos);
  EXPECT_NE(m.scope.find("Not modelled"), std::string::npos);
  EXPECT_GE(m.errata.size(), 10U);
  for (const Erratum& e : m.errata) {
    EXPECT_FALSE(e.evidence.empty()) << e.where;
    EXPECT_NE(e.test.find("ClosedLoop"), std::string::npos) << e.where;
  }
}

}  // namespace taut::closed_loop::description_test
