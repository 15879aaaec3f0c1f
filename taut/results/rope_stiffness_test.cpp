#include "taut/results/rope_stiffness.hpp"

#include <fmt/format.h>

#include "test/support/machine_decks.hpp"

namespace rope_stiffness_test {

using namespace taut_test;
using taut::Result;
using taut::Status;

std::string deck_with(const std::string& skyline) {
  std::string text = skyline_deck("  - equilibrium: {carriage: car, x: 170 m}");
  const std::string given = "{mass: 1.6 kg/m, stiffness: 20 MN, breaking_force: 280 kN}";
  return text.replace(text.find(given), given.size(), skyline);
}

std::string warnings_of(const Result& r) {
  std::string all;
  for (const std::string& one : r.warnings) all += one + "\n";
  return all;
}

TEST(RopeStiffness, OfTheCatalogueIsItsAreaTimesTheModulusOfItsConstruction) {
  const Result r = run_text(deck_with("{rope: \"EN 12385-4|6x36-IWRC|20|1960\"}"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_NEAR(value_of(r, "skyline.stiffness"), 184e-6 * 107.5e9, 1);
  EXPECT_NE(warnings_of(r).find("stiffness of rope 'skyline': EA = 19.78 MN from area 184 mm^2 x modulus 107.5 GPa "
                                "(6x36-IWRC: modulus.6_strand_iwrc, 95 to 120 GPa, UNVERIFIED)"),
            std::string::npos)
      << warnings_of(r);
  // the same as given in the deck, which then answers for it
  const Result given = run_text(deck_with("{rope: \"EN 12385-4|6x36-IWRC|20|1960\", stiffness: 19.78 MN}"));
  EXPECT_NEAR(value_of(r, "skyline.T_max"), value_of(given, "skyline.T_max"), 1e-6);
  EXPECT_EQ(warnings_of(given).find("stiffness of rope"), std::string::npos);
  EXPECT_EQ(given.find_value("skyline.stiffness"), nullptr);
}

TEST(RopeStiffness, OfAPlanningProgramsRopesIsItsOwnPair) {
  const Result r = run_text(deck_with("{rope: \"SEILAPLAN|compacted|20|-\"}"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_NEAR(value_of(r, "skyline.stiffness"), 219.9e-6 * 100e9, 1);
}

TEST(RopeStiffness, AnInextensibleRopeHasToBeAskedFor) {
  const Result r = run_text(deck_with("{rope: \"EN 12385-4|6x36-IWRC|20|1960\", stiffness: .inf}"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_EQ(warnings_of(r).find("stiffness of rope"), std::string::npos);
  EXPECT_EQ(r.find_value("skyline.stiffness"), nullptr);
  expect_mistake(run_text(deck_with("{mass: 1.6 kg/m}")), "lacks its 'stiffness', EA");
}

}  // namespace rope_stiffness_test
