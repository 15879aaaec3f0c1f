#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::checks::own_mast_test {

using namespace taut_test;

bool says(const std::vector<std::string>& all, const std::string& text) {
  return std::any_of(all.begin(), all.end(),
                     [&](const std::string& one) { return one.find(text) != std::string::npos; });
}

// The foot in tension, the mast above it pressed by 130 kN: it leans as the deck says.
TEST(OwnMast, AnUpliftBelowDropsNoSway) {
  const auto lifted = [](const std::string& lift) {
    return run_text(
        "taut: 1\nmachine:\n  points: {a: [0 m, 0 m, 0 m], c: [50 m, 0 m, 0 m]}\n  ropes: {r: {mass: 1 kg/m, "
        "stiffness: 20 MN, breaking_force: 300 kN}}\n  reevings: [{rope: r, path: [{anchor: a}, {anchor: c}], "
        "tension_at_start: 20 kN}]\nanalyses: [{equilibrium: {}}]\nchecks: {ropes: {r: {safety_factor: 3}}, masts: "
        "{up: {height: 8 m, section: CHS 219.1x8, steel: S355, sway: 0.08, loads: [{at: 2 m, down: -" +
        lift + "}, {down: 130 kN, across: 2 kN}]}}}\n");
  };
  const Result pressed = lifted("129 kN"), pulled = lifted("131 kN");
  EXPECT_FALSE(check_of(pulled, "up.section").passes);
  EXPECT_NEAR(check_of(pulled, "up.section").value, check_of(pressed, "up.section").value, 0.03);
  EXPECT_TRUE(says(pulled.assumptions, "as built leaning by 0.08"));
}

}  // namespace taut::checks::own_mast_test
