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

// EN 12385-4, 20 mm, 6x36 IWRC, grade 1960: 279 kN, 1.64 kg/m, 184 mm2. A slip of a thousand used to pass.
TEST(RopeStiffness, AValueThatNoRopeOfItsRowHasIsUnsafe) {
  const auto unsafe_of = [](const std::string& more) {
    const Result r = run_text(deck_with("{rope: \"EN 12385-4|6x36-IWRC|20|1960\", " + more + "}"));
    EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    std::string all;
    for (const std::string& one : r.unsafe) {
      if (one.find("row of the catalogue") != std::string::npos) all += one + "\n";
    }
    return all;
  };
  EXPECT_NE(unsafe_of("stiffness: 20 MN, breaking_force: 279.1 MN")
                .find("rope 'skyline' has the breaking force 2.791e+05 kN; its row of the catalogue, 'EN "
                      "12385-4|6x36-IWRC|20|1960', has 279"),
            std::string::npos)
      << unsafe_of("stiffness: 20 MN, breaking_force: 279.1 MN");
  EXPECT_NE(unsafe_of("stiffness: 20 MN, mass: 4 kg/m").find("mass 4 kg/m"), std::string::npos);
  EXPECT_NE(unsafe_of("stiffness: 20 MN, diameter: 12 mm").find("diameter 12 mm"), std::string::npos);
  // 184 mm2 of 0.6 x 95 GPa and of 206 GPa: 10.5 and 37.9 MN
  EXPECT_NE(unsafe_of("stiffness: 10 MN").find("10.49 MN when new to 37.9 MN"), std::string::npos)
      << unsafe_of("stiffness: 10 MN");
  EXPECT_NE(unsafe_of("stiffness: 40 MN"), "");
  for (const char* ordinary : {"stiffness: 11 MN", "stiffness: .inf", "stiffness: 20 MN, mass: 0 kg/m",
                               "stiffness: 20 MN, breaking_force: 320 kN, mass: 1.9 kg/m, diameter: 19 mm",
                               "stiffness: 20 MN, breaking_force: 100 kN"}) {
    EXPECT_EQ(unsafe_of(ordinary), "") << ordinary;
  }
}

// A modulus of 10 GPa in a design is that slip too.
TEST(RopeStiffness, AModulusThatNoChosenRopeHasIsUnsafe) {
  const auto unsafe_of = [](const std::string& rope, const std::string& modulus) {
    const Result r = run_text(fmt::format(R"(taut: 1
machine:
  points: {{a: [0 m, 0 m, 0 m], b: [10 m, 0 m, 0 m]}}
  ropes: {{line: {{{}}}}}
  reevings: [{{rope: line, path: [{{anchor: a}}, {{anchor: b}}], tension_at_start: 30 kN}}]
checks: {{ropes: {{line: {{safety_factor: 3}}}}}}
design: {{ropes: {{line: {{construction: 6x36, core: IWRC, grade: 1960 MPa{}}}}}}}
)",
                                          rope, modulus));
    EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    for (const std::string& one : r.unsafe) {
      if (one.find("rope 'line' has the stiffness") != std::string::npos) return one;
    }
    return std::string{};
  };
  EXPECT_NE(unsafe_of("", ", modulus: 10 GPa").find("its row of the catalogue, 'EN 12385-4|6x36-IWRC|"),
            std::string::npos);
  EXPECT_NE(unsafe_of("stiffness: 1 MN", ""), "");
  EXPECT_EQ(unsafe_of("", ""), "");
}

// 30 kN strain 1 MN by 3 %.
TEST(RopeStiffness, AStrainThatNoSteelRopeBearsIsToldOf) {
  const auto deck = [](const char* rope) {
    return fmt::format(R"(taut: 1
machine:
  points: {{a: [0 m, 0 m, 0 m], b: [10 m, 0 m, 0 m]}}
  ropes: {{line: {{{}, stiffness: 1 MN}}}}
  reevings: [{{rope: line, path: [{{anchor: a}}, {{anchor: b}}], tension_at_start: 30 kN}}]
)",
                       rope);
  };
  const Result r = run_text(deck("mass: 0.5 kg/m"));
  EXPECT_NE(warnings_of(r).find("30 kN, strains it by 3 % at a stiffness of 1 MN"), std::string::npos)
      << warnings_of(r);
  EXPECT_TRUE(r.unsafe.empty());  // it may be one of fibres
  const Result steel = run_text(deck("rope: \"EN 12385-4|6x36-IWRC|20|1960\""));
  EXPECT_EQ(steel.unsafe.size(), 2U);
}

}  // namespace rope_stiffness_test
