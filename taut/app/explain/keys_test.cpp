#include "taut/app/explain/keys.hpp"

#include <gtest/gtest.h>

#include <map>

#include "taut/app/machine_deck.hpp"

namespace taut::app::keys_test {

TEST(Keys, OfAMachineHavePathsUnitsDefaultsAndRanges) {
  std::map<std::string, std::string> found;
  walk_keys("", MachineDeck::describe(), [&](const std::string& path, const Description& d, const Field& f) {
    EXPECT_TRUE(found.emplace(path, kind_text(f) + "; " + default_of(d, f) + "; " + full_words(f)).second) << path;
  });
  EXPECT_EQ(found["machine.reevings[].length"],
            "m; -; unstretched length of the rope from end to end (above 0 m and at most 1e7 m)");
  EXPECT_EQ(found["machine.sheaves.NAME.efficiency"],
            "number; 1; T_small/T_large over the turning sheave (above 0 and at most 1)");
  EXPECT_EQ(found["analyses[].load_path.carriage"].substr(0, 16), "text; required; ");
  EXPECT_NE(found["design.seek"].find("`lightest`, `smallest`"), std::string::npos);
}

}  // namespace taut::app::keys_test
