#include "taut/results/answers/line_profile.hpp"

#include <algorithm>
#include <cmath>

#include "test/support/machine_decks.hpp"

namespace line_profile_test {

using namespace taut_test;
using taut::Profile;
using taut::Result;
using taut::Status;

const Profile& profile_named(const Result& r, const std::string& name) {
  for (const taut::Figure& f : r.figures) {
    const auto* p = std::get_if<Profile>(&f);
    if (p != nullptr && p->name == name) return *p;
  }
  throw std::runtime_error("no profile " + name);
}

TEST(LineProfile, HasGroundSupportsRopesAndTheWayOfTheCarriage) {
  const Result r = run_text(skyline_deck("  - load_path: {carriage: car, from: 220 m, to: 140 m, steps: 4}"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const Profile& p = profile_named(r, "load_path_profile");
  EXPECT_EQ(r.key_figure, p.name);
  ASSERT_EQ(p.supports.size(), 4U) << "the winch stands beside the tower";
  EXPECT_EQ(p.supports[0].name, "stump");
  EXPECT_EQ(p.supports[1].name, "jack1");
  EXPECT_NEAR(p.supports[1].top.y, 33, 0.5);
  EXPECT_NEAR(p.supports[1].ground, 22, 1e-9);
  ASSERT_EQ(p.ropes.size(), 2U);
  EXPECT_EQ(p.ropes[0].name, "skyline");
  EXPECT_EQ(p.ropes[0].role, taut::Role::rope);
  EXPECT_EQ(p.ropes[1].role, taut::Role::second_rope);
  ASSERT_EQ(p.places.size(), 5U);
  EXPECT_TRUE(std::is_sorted(p.places.begin(), p.places.end(), [](const auto& a, const auto& b) { return a.x < b.x; }));
  const taut::Table& t = table_of(r, "load_path");
  for (std::size_t i = 0; i < 5; ++i) {
    const std::size_t row = 4 - i;  // the deck goes the other way
    // friction may hold it lower than the answer of the table
    const double lower = cell(t, row, "z") - p.places[i].z;
    EXPECT_GE(lower, -1e-9);
    EXPECT_LT(lower, 0.05);
    EXPECT_NEAR(p.places[i].z - p.places[i].ground, cell(t, row, "clearance") - lower, 1e-9);
    const double skyline = cell(t, row, "skyline.T_max") / 280e3, mainline = cell(t, row, "mainline.T_max") / 110e3;
    EXPECT_NEAR(p.places[i].value, std::max(skyline, mainline), 1e-12);
    EXPECT_EQ(p.places[i].governs, skyline > mainline ? "skyline" : "mainline");
    EXPECT_LE(p.places[i].value, p.places[p.decisive].value);
  }
  EXPECT_NEAR(p.carriage_at.x, p.places[p.decisive].x, 1e-9) << "drawn where it bears most";
}

TEST(LineProfile, ShowsThePayloadAndItsLimits) {
  const Result r =
      run_text(skyline_deck("  - payload: {carriage: car, from: 140 m, to: 170 m, steps: 3, motion: in, "
                            "limits: {skyline: {safety_factor: 3.5}, clearance: 2 m}}"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const Profile& p = profile_named(r, "payload_profile");
  EXPECT_EQ(p.clearance, 2);
  const taut::Table& t = table_of(r, "payload");
  ASSERT_EQ(p.places.size(), t.rows.size());
  for (std::size_t i = 0; i < p.places.size(); ++i) {
    EXPECT_NEAR(p.places[i].value, cell(t, i, "payload"), 1e-9);
    EXPECT_EQ(p.places[i].governs, text_cell(t, i, "governing"));
  }
  EXPECT_NEAR(p.places[p.decisive].value, value_of(r, "payload_min"), 1e-9);
  EXPECT_NEAR(p.places[p.decisive].x, value_of(r, "payload_min_x"), 1e-9);
}

TEST(LineProfile, WithoutBreakingForcesTensionsAreShown) {
  std::string deck = skyline_deck("  - load_path: {carriage: car, from: 140 m, to: 220 m, steps: 2}");
  for (const char* force : {", breaking_force: 280 kN", ", breaking_force: 110 kN"}) {
    deck.erase(deck.find(force), std::string(force).size());
  }
  const Result r = run_text(deck);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const Profile& p = profile_named(r, "load_path_profile");
  EXPECT_EQ(p.value.unit.symbol, "N");
  EXPECT_NEAR(p.places[p.decisive].value, value_of(r, "T_max"), 1e-6);
}

}  // namespace line_profile_test
