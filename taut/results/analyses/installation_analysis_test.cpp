#include <fmt/format.h>

#include <algorithm>

#include "test/support/machine_decks.hpp"

namespace installation_analysis_test {

using namespace taut_test;
using taut::Result;
using taut::Status;
using taut::Table;

std::string installation_of(const std::string& asked) {
  return skyline_deck(fmt::format("  - installation: {{reeving: skyline, {}}}", asked));
}

/// The empty skyline alone, at a temperature, with this length at 15 degC.
Result bare(double length, double kelvin) {
  return run_text(fmt::format(R"(taut: 1
machine:
  temperature: {:.17g} K
  points: {{stump: [0 m, 0 m, 4 m], tower: [360 m, 0 m, 124 m]}}
  ropes: {{skyline: {{mass: 1.6 kg/m, stiffness: 20 MN, reference_temperature: 15 degC}}}}
  supports:
    jack1: {{at: [110 m, 0 m, 33 m], diameter: 400 mm, friction: 0.1}}
    jack2: {{at: [240 m, 0 m, 78 m], friction: 0.1}}
  reevings:
    - {{rope: skyline, path: [{{anchor: stump}}, {{over: jack1}}, {{over: jack2}}, {{anchor: tower}}], length: {:.17g} m}}
)",
                              kelvin, length));
}

TEST(InstallationAnalysis, EachRowIsTheBareRopeAtItsTemperature) {
  const Result r =
      run_text(installation_of("temperatures: [-20 degC, 15 degC, 40 degC], given: {tension: 30 kN, at: end}"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const Table& t = table_of(r, "installation");
  ASSERT_EQ(t.rows.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(cell(t, i, "T_end"), 30e3, 1e-4);
    const Result one = bare(cell(t, i, "unstretched"), cell(t, i, "temperature"));
    ASSERT_EQ(one.status, Status::ok) << one.message << to_text(one.errors);
    EXPECT_NEAR(value_of(one, "skyline.T_start") / cell(t, i, "T_start"), 1, 1e-6);
    EXPECT_NEAR(value_of(one, "skyline.T_end") / 30e3, 1, 1e-6);
    const double dT = cell(t, i, "temperature") - 288.15;
    EXPECT_NEAR(cell(t, i, "installed") / cell(t, i, "unstretched"), 1 + 1.2e-5 * dT, 1e-12);
    const Table& spans = table_of(one, "spans");
    double free = 0;
    for (std::size_t k = 0; k < 3; ++k) free += cell(spans, k, "stretched");
    EXPECT_NEAR(cell(t, i, "stretched"), free, 0.1) << "but for what lies on the saddle";
  }
}

/// Whether the result warns of a rope of another length than the machine has.
bool told_of_another_rope(const std::string& asked) {
  const Result r = run_text(installation_of(asked));
  EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  return std::any_of(r.unsafe.begin(), r.unsafe.end(),
                     [](const std::string& words) { return words.find("is put up with") != std::string::npos; });
}

// The skyline has 382 m.
TEST(InstallationAnalysis, AnotherRopeThanTheOneThatIsCalculatedIsUnsafe) {
  EXPECT_TRUE(told_of_another_rope("temperatures: [-20 degC, 40 degC], given: {tension: 30 kN, temperature: 15 degC}"));
  EXPECT_TRUE(told_of_another_rope("temperatures: [-20 degC, 40 degC], given: {tension: 30 kN}"));
  EXPECT_FALSE(told_of_another_rope("temperatures: [-20 degC, 40 degC], given: {length: 382.01 m}"));
  EXPECT_FALSE(told_of_another_rope("temperatures: [-20 degC, 40 degC]"));
}

TEST(InstallationAnalysis, AChartKeepsTheLengthOfItsTemperature) {
  const Result r = run_text(
      installation_of("from: -20 degC, to: 40 degC, steps: 4, given: {sag: 3 m, span: 2, temperature: 10 degC}"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const Table& t = table_of(r, "installation");
  ASSERT_EQ(t.rows.size(), 5U);
  for (std::size_t i = 1; i < 5; ++i) {
    EXPECT_NEAR(cell(t, i, "unstretched"), cell(t, 0, "unstretched"), 1e-8);
    EXPECT_GT(cell(t, i, "sag_2"), cell(t, i - 1, "sag_2"));
    EXPECT_LT(cell(t, i, "T_start"), cell(t, i - 1, "T_start"));
  }
  EXPECT_NEAR(cell(t, 2, "temperature"), 283.15, 1e-9);
  EXPECT_NEAR(cell(t, 2, "sag_2"), 3, 1e-7);
}

TEST(InstallationAnalysis, WithoutAnythingGivenTheMachinesLength) {
  const Result r = run_text(skyline_deck("  - installation: {reeving: skyline}"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_NEAR(value_of(r, "skyline.install_length"), 382, 1e-9);
  EXPECT_NEAR(value_of(r, "skyline.install_T_start") / value_of(bare(382, 288.15), "skyline.T_start"), 1, 1e-7);
  const Table& lengths = table_of(r, "lengths");
  ASSERT_EQ(lengths.rows.size(), 1U) << "the mainline is not rigged yet";
  EXPECT_NEAR(cell(lengths, 0, "free") + cell(lengths, 0, "on_sheaves"), cell(lengths, 0, "stretched"), 1e-9);
}

TEST(InstallationAnalysis, WhatTheLineDoesNotNeedStaysOnTheDrum) {
  std::string deck = installation_of("given: {tension: 60 kN, at: end}");
  const std::string end = "{over: jack2}, {anchor: tower}";
  deck.replace(deck.find(end), end.size(), "{over: jack2}, {drum: winch}");
  const Result unsaid = run_text(deck);
  ASSERT_EQ(unsaid.status, Status::ok) << unsaid.message << to_text(unsaid.errors);
  EXPECT_TRUE(std::isnan(cell(table_of(unsaid, "lengths"), 0, "on_drums")));
  const Result r = run_text(deck, {"machine.drums.winch.length_on_drum=40 m"});
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const Table& t = table_of(r, "lengths");
  EXPECT_GT(cell(t, 0, "on_drums"), 40) << "drawn up: rope comes in";
  EXPECT_NEAR(cell(t, 0, "on_drums") + cell(t, 0, "unstretched"), 382 + 40, 1e-9);
}

TEST(InstallationAnalysis, ARopeOnAPlumbLineHasNoSag) {
  const Result r = run_text(
      "taut: 1\nmachine:\n  points: {a: [0 m, 0 m, 20 m], b: [0 m, 0 m, 0 m]}\n  ropes: {r: {mass: 1 kg/m, stiffness: "
      "5 "
      "MN, breaking_force: 100 kN}}\n  reevings: [{rope: r, name: line, path: [{anchor: a}, {anchor: b}], length: "
      "19.99 "
      "m}]\nanalyses: [installation: {reeving: line}]\nchecks: {ropes: {r: {safety_factor: 2}}}\n");
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_EQ(exit_code(r), 0);
}

TEST(InstallationAnalysis, TellsEachMistakeAtItsPlace) {
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"temperatures: [15]", "temperatures: a temperature needs its unit"},
      {"from: 0 degC", "'from' and 'to' belong together"},
      {"temperatures: [0 degC], from: 0 degC, to: 9 degC", "give either 'temperatures' or 'from' and 'to'"},
      {"given: {}", "needs one of tension, length, sag"},
      {"given: {tension: 3 kN, length: 300 m}", "given has 'tension' already"},
      {"given: {tension: 3 kN, span: 2}", "given.span: belongs to a 'sag'"},
      {"given: {sag: 3 m, span: 9}", "given.span: the empty rope has 3 free spans"},
  };
  for (const auto& [asked, expected] : rows) expect_mistake(run_text(installation_of(asked)), expected);
  expect_mistake(run_text(installation_of("temperatures: [0 degC]"), {"analyses[0].installation.reeving=sky"}),
                 "there is no reeving or guy 'sky'");
}

TEST(GivenModes, OfADeckAreThoseOfItsSag) {
  const auto deck = [](const std::string& given) {
    return skyline_deck(fmt::format("  - equilibrium: {{carriage: car, x: 170 m, motion: in, given: {{{}}}}}", given));
  };
  const std::vector<std::string> load = {"machine.loads[0].mass=1.5 t"};
  const Result by_sag = run_text(deck("reeving: skyline, sag: 9 m"), load);
  ASSERT_EQ(by_sag.status, Status::ok) << by_sag.message << to_text(by_sag.errors);
  const double length = value_of(by_sag, "skyline.unstretched");
  const Result by_length = run_text(deck(fmt::format("reeving: skyline, loop_length: {:.17g} m", length)), load);
  EXPECT_NEAR(value_of(by_length, "car.z"), value_of(by_sag, "car.z"), 1e-6);
  const Result by_pull = run_text(deck(fmt::format("reeving: skyline, winch_pull: {:.17g} N, at: end, efficiency: 0.8",
                                                   value_of(by_sag, "skyline.T_end") / 0.8)),
                                  load);
  EXPECT_NEAR(value_of(by_pull, "car.z"), value_of(by_sag, "car.z"), 1e-5);
  const Result by_main = run_text(
      deck(fmt::format("reeving: skyline, winch_pull: {:.17g} N, of: mainline", value_of(by_sag, "mainline.T_start"))),
      load);
  ASSERT_EQ(by_main.status, Status::ok) << by_main.message << to_text(by_main.errors);
  EXPECT_NEAR(value_of(by_main, "mainline.T_start") / value_of(by_sag, "mainline.T_start"), 1, 1e-8);
  const Result both = run_text(deck(fmt::format("reeving: skyline, loop_length: {:.17g} m, of: [skyline, mainline]",
                                                length + value_of(by_sag, "mainline.unstretched"))),
                               load);
  EXPECT_NEAR(value_of(both, "skyline.unstretched"), length, 1e-5);
}

TEST(GivenModes, TellEachMistakeAtItsPlace) {
  const auto deck = [](const std::string& given) {
    return skyline_deck(fmt::format("  - equilibrium: {{carriage: car, x: 170 m, given: {{{}}}}}", given));
  };
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"reeving: skylin, sag: 3 m", "given.reeving: there is no reeving or guy 'skylin'; did you mean 'skyline'?"},
      {"reeving: mainline, sag: 3 m", "given.reeving: the place of 'car' decides the length of its mainline"},
      {"reeving: skyline", "needs one of winch_pull, loop_length, sag, free_running"},
      {"reeving: skyline, free_running: true", "given.free_running: 'car' is held by its mainline"},
      {"reeving: skyline, free_running: false", "false says nothing"},
      {"reeving: skyline, sag: 3 m, efficiency: 0.9", "given.efficiency: belongs to a 'winch_pull'"},
      {"reeving: skyline, sag: 3 m, at: end", "given.at: belongs to a 'winch_pull'"},
      {"reeving: skyline, sag: 3 m, span: 7", "given.span: 'skyline' has 4 free spans"},
      {"reeving: skyline, loop_length: 300 m, of: [mainline]", "is not part of the loop"},
      {"reeving: skyline, winch_pull: 3 kN, of: [mainline, skyline]", "a winch pulls one rope"},
  };
  for (const auto& [given, expected] : rows) expect_mistake(run_text(deck(given)), expected);
}

}  // namespace installation_analysis_test
