#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "taut/calc/verdict.hpp"
#include "taut/catalogue/section_search.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::checks::machine_masts_test {

using namespace taut_test;

/// A cantilever of 8 m in `parts` beams, `down` N at its top; `more` beams beside it.
Result upright(int parts, double down, double factor, const std::string& imperfection = "", bool strut = false) {
  std::string points, beams, names;
  for (int i = 1; i <= parts; ++i) {
    points += fmt::format("    j{}: [0 m, 0 m, {} m]\n", i, 8.0 * i / parts);
    beams += fmt::format("    b{}: {{from: {}, to: j{}, section: CHS 219.1x8, steel: S355, mass: 0 kg/m{}}}\n", i,
                         i == 1 ? std::string("foot") : fmt::format("b{}.top", i - 1), i, imperfection);
    names += fmt::format("{}b{}", i == 1 ? "" : ", ", i);
  }
  std::string loads = fmt::format("{{at: b{}.top, force: [0.1 kN, 0 kN, {} N]}}", parts, -down);
  if (strut) {
    points += "    f: [5 m, 0 m, 0 m]\n    h: [5 m, 0 m, 8 m]\n";
    beams += "    other: {from: f, to: h, section: CHS 219.1x8, steel: S355, mass: 0 kg/m}\n";
    loads += ", {at: other.top, force: [0 kN, 0 kN, -90 kN]}";
  }
  return run_text(
      fmt::format("taut: 1\nmachine:\n  points:\n    foot: [0 m, 0 m, 0 m]\n{}  beams:\n{}  loads: [{}]\n"
                  "analyses: [{{equilibrium: {{}}}}]\nchecks: {{masts: {{all: {{beams: [{}], load_factor: "
                  "{}}}}}}}\n",
                  points, beams, loads, names, factor));
}

// pi^2 E I/(4 L^2) over 100 kN, in however many beams it stands: the sum of Dunkerley's would be 1.62.
TEST(MachineMasts, AMastOfManyBeamsHasTheFactorOfAll) {
  const double alpha = std::pow(std::numbers::pi / 16, 2) * 210e9 * catalogue::find_section("CHS 219.1x8")->I_y / 100e3;
  const Result one = upright(1, 100e3, 2), four = upright(4, 100e3, 2);
  EXPECT_NEAR(check_of(four, "all.buckling").value, check_of(one, "all.buckling").value, 1e-3);
  EXPECT_NEAR(check_of(four, "all.section").value, check_of(one, "all.section").value, 1e-3);
  EXPECT_TRUE(check_of(four, "all.buckling").passes);
  const std::string rule = check_of(upright(4, 100e3, 1.01 * alpha), "all.section").rule;
  EXPECT_NE(rule.find("the mast buckles, its critical factor is 2.39"), std::string::npos) << rule;
}

// With a beam beside it that presses too, the sum is what is known, and said to be a bound.
TEST(MachineMasts, BesideOthersThatPressABoundIsCalledOne) {
  const Result r = upright(4, 100e3, 2, "", true);
  const std::string rule = check_of(r, "all.section").rule;
  EXPECT_NE(rule.find("the mast may buckle, its critical factor is at least 1.62"), std::string::npos) << rule;
  EXPECT_NE(rule.find("Dunkerley"), std::string::npos) << rule;
}

}  // namespace taut::checks::machine_masts_test
