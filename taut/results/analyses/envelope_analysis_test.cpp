#include <fmt/format.h>

#include <algorithm>

#include "test/support/machine_decks.hpp"

namespace envelope_analysis_test {

using namespace taut_test;
using taut::Result;
using taut::Status;
using taut::Table;

const char* const asked =
    "  - envelope: {carriage: car, from: 140 m, to: 220 m, steps: 4, loads: [0.5 t, 2 t], motions: [in, out], "
    "temperatures: [-20 degC, 30 degC]}";

/// The sense of the skyline over its jacks: else it creeps both ways, and each state has a band.
const std::string told = "machine.reevings[0].haul=to_start";

TEST(EnvelopeAnalysis, IsTheLeastAndLargestOfSingleRuns) {
  const Result r = run_text(skyline_deck(asked), {told});
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  struct Ends {
    double least = 1e99, most = -1e99;
    void add(double v) {
      least = std::min(least, v);
      most = std::max(most, v);
    }
  };
  Ends skyline, jack, anchor, clearance;
  for (const double x : {140.0, 160.0, 180.0, 200.0, 220.0}) {
    for (const double load : {500.0, 2000.0}) {
      for (const char* motion : {"in", "out"}) {
        for (const char* temperature : {"-20 degC", "30 degC"}) {
          const Result one = run_text(
              skyline_deck(fmt::format("  - equilibrium: {{carriage: car, x: {} m, motion: {}}}", x, motion)),
              {fmt::format("machine.loads[0].mass={} kg", load), fmt::format("machine.temperature={}", temperature),
               "machine.ropes.skyline.reference_temperature=15 degC",
               "machine.ropes.mainline.reference_temperature=15 degC", told});
          ASSERT_EQ(one.status, Status::ok) << one.message << to_text(one.errors);
          const Table& spans = table_of(one, "spans");
          for (std::size_t i = 0; i < spans.rows.size(); ++i) {
            if (text_cell(spans, i, "rope") != "skyline") continue;
            skyline.add(cell(spans, i, "T_from"));
            skyline.add(cell(spans, i, "T_to"));
          }
          const Table& sheaves = table_of(one, "sheaves");
          jack.add(cell(sheaves, row_of(sheaves, "name", "jack1"), "resultant"));
          const Table& anchors = table_of(one, "anchors");
          anchor.add(cell(anchors, row_of(anchors, "name", "tower"), "Fz"));
          clearance.add(value_of(one, "clearance_min"));
        }
      }
    }
  }
  const auto expect = [&](const char* table, const std::string& name, const std::string& quantity, const Ends& ends) {
    const Table& t = table_of(r, table);
    for (std::size_t i = 0; i < t.rows.size(); ++i) {
      if (text_cell(t, i, "name") != name || text_cell(t, i, "quantity") != quantity) continue;
      EXPECT_NEAR(cell(t, i, "min"), ends.least, 1e-6 * std::abs(ends.least) + 1e-9) << name;
      EXPECT_NEAR(cell(t, i, "max"), ends.most, 1e-6 * std::abs(ends.most) + 1e-9) << name;
      return;
    }
    ADD_FAILURE() << name << " " << quantity;
  };
  expect("envelope", "skyline", "tension", skyline);
  expect("envelope", "skyline on jack1", "resultant", jack);
  expect("envelope", "skyline on tower", "Fz", anchor);
  expect("envelope_lengths", "car", "clearance", clearance);
  EXPECT_EQ(value_of(r, "envelope_states"), 40);
  EXPECT_NEAR(value_of(r, "skyline.T_max_envelope"), skyline.most, 1e-6 * skyline.most);
  EXPECT_NEAR(value_of(r, "T_max") / std::max(skyline.most, value_of(r, "mainline.T_max_envelope")), 1, 1e-9);
  // of each rope, not only of the one that is pulled most; so for what else is reported of all states
  EXPECT_NEAR(check_of(r, "mainline.T_max").value, value_of(r, "mainline.T_max_envelope"), 1e-6);
  EXPECT_NEAR(check_of(r, "skyline.T_max").value, value_of(r, "skyline.T_max_envelope"), 1e-6);
}

TEST(EnvelopeAnalysis, SaysWhereAndTheOrderDoesNotCount) {
  const Result a = run_text(skyline_deck(asked), {told});
  const Result b = run_text(skyline_deck(asked), {told, "analyses[0].envelope.loads=[2000 kg, 0.5 t]",
                                                  "analyses[0].envelope.motions=[out, in]",
                                                  "analyses[0].envelope.temperatures=[303.15 K, 253.15 K]",
                                                  "analyses[0].envelope.from=220 m", "analyses[0].envelope.to=140 m"});
  const Table &there = table_of(a, "envelope"), &back = table_of(b, "envelope");
  ASSERT_EQ(there.rows.size(), back.rows.size());
  const std::size_t i = row_of(there, "name", "skyline"), k = row_of(back, "name", "skyline");
  EXPECT_NEAR(cell(there, i, "max") / cell(back, k, "max"), 1, 1e-8);
  EXPECT_EQ(cell(there, i, "max_x"), cell(back, k, "max_x"));
  EXPECT_EQ(cell(there, i, "max_load"), 2000);
  EXPECT_EQ(text_cell(there, i, "max_motion"), text_cell(back, k, "max_motion"));
  EXPECT_NEAR(cell(there, i, "max_temperature"), 253.15, 1e-9);
}

// At a point of a body: as a load that the deck has there, not at the body's centre of mass.
TEST(EnvelopeAnalysis, PutsItsLoadsAtAPoint) {
  const auto boom = [](const std::string& load, const std::string& analysis) {
    return run_text(R"(taut: 1
machine:
  points: {tip: {body: boom, at: [8 m, 0 m, 0 m]}, head: [0 m, 0 m, 6 m]}
  ropes: {stay: {mass: 0 kg/m, stiffness: 20 MN}}
  bodies: {boom: {mass: 500 kg, at: [0 m, 0 m, 0 m], centre: [4 m, 0 m, 0 m], free: [ry]}}
  reevings: [{rope: stay, path: [{anchor: head}, {anchor: tip}], length: 10 m}]
)" + load + "analyses: [{" +
                    analysis + "}]\n");
  };
  const Result at_tip = boom("", "envelope: {load_at: tip, loads: [2 t]}");
  const Result hung = boom("  loads: [{at: tip, mass: 2 t}]\n", "equilibrium: {}");
  const Result in_it = boom("", "envelope: {load_at: boom, loads: [2 t]}");
  EXPECT_NEAR(value_of(at_tip, "stay.T_max_envelope") / value_of(hung, "stay.T_max"), 1, 1e-9);
  EXPECT_NEAR(value_of(in_it, "stay.T_max_envelope") / value_of(hung, "stay.T_max"), (250 + 1000) / (250 + 2000.0),
              1e-3);
}

TEST(EnvelopeAnalysis, TellsEachMistakeAtItsPlace) {
  const std::string good = skyline_deck(asked);
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"analyses[0].envelope.carriage=cra", "there is no carriage 'cra'"},
      {"analyses[0].envelope.motions=[inn]", "motions: 'inn' is not a choice"},
      {"analyses[0].envelope.loads=[5]", "loads: a mass needs its unit"},
      {"analyses[0].envelope.load_at=mast", "there is no body or carriage 'mast', and no point of one"},
      {"analyses[0].envelope.to=140 m", "is the same place as 'from'"},
      {"analyses[0].envelope={carriage: car}", "'carriage', 'from' and 'to' belong together"},
      {"analyses[0].envelope={loads: [1 t]}", "say where: 'load_at' a body, or a 'carriage'"},
  };
  for (const auto& [set, expected] : rows) expect_mistake(run_text(good, {set}), expected);
}

}  // namespace envelope_analysis_test
