#include "taut/study/line/rope_sense.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "test/support/machine_decks.hpp"

/// Ropes that run against the motion that a deck declares for them.
namespace rope_sense_test {

using namespace taut_test;
using taut::Result;
using taut::Status;
using taut::study::contrary_senses;
using taut::study::RopeSense;
using taut::study::wrong_senses;

/// A running skyline: the haulback comes in where the carriage goes out.
std::string running_skyline(const std::string& analysis) {
  return R"(taut: 1
machine:
  points:
    tower: [0 m, 0 m, 12 m]
  ropes:
    haulback: {mass: 0.8 kg/m, stiffness: 9.8 MN}
    mainline: {mass: 0.6 kg/m, stiffness: 7.2 MN}
  sheaves:
    tower_sheave: {at: [0 m, 0 m, 13 m], diameter: 300 mm, efficiency: 0.97}
    tail_block: {at: [200 m, 0 m, 40 m], diameter: 300 mm, efficiency: 0.95}
    lead: {at: [1 m, 0 m, 12 m], diameter: 300 mm, efficiency: 0.95}
  drums:
    haulback_drum: {at: [-3 m, 0 m, 1 m], core_diameter: 400 mm, drive: {pull: 25 kN}}
    mainline_drum: {at: [-3 m, 0 m, 2 m], core_diameter: 400 mm}
  carriages:
    car: {mass: 250 kg, rides: haulback, hold: rolling, mainline: mainline, at: [100 m, 0 m, 22 m]}
  reevings:
    - {rope: haulback, path: [{drum: haulback_drum}, {over: tower_sheave}, {through: car}, {over: tail_block}, {anchor: car}]}
    - {rope: mainline, path: [{drum: mainline_drum}, {over: lead}, {anchor: car}], length: 112 m}
  loads:
    - {at: car, mass: 900 kg}
analyses:
)" + analysis;
}

std::string cycle(const std::string& out, const std::string& in) {
  return running_skyline(
      "  - cycle: {carriage: car, from: 60 m, to: 120 m, steps: 6, phases: [{name: out empty, motion: " + out +
      "}, {name: in loaded, motion: " + in + "}]}\n");
}

TEST(RopeSense, ACycleAgainstItsRopesIsRefusedWithTheRightSigns) {
  const Result wrong = run_text(cycle("{haulback: 1}", "{haulback: -1}"));
  EXPECT_EQ(wrong.status, Status::infeasible);
  EXPECT_NE(wrong.message.find("cycle, out empty: haulback runs "), std::string::npos) << wrong.message;
  EXPECT_NE(wrong.message.find("declare 'motion: {haulback: -1}'"), std::string::npos) << wrong.message;
  EXPECT_EQ(wrong.find_value("cycle_energy"), nullptr) << "no sum of what is wrong";
}

TEST(RopeSense, ACycleWithTheRightSignsCostsEnergy) {
  const Result right = run_text(cycle("{haulback: -1, mainline: 1}", "{haulback: 1, mainline: -1}"));
  ASSERT_EQ(right.status, Status::ok) << right.message << to_text(right.errors);
  EXPECT_TRUE(right.unsafe.empty()) << right.unsafe.front();
  EXPECT_GT(value_of(right, "cycle_energy"), 0);
  // the mainline draws the haulback off its winch, and the other way round: two words say it
  const Result words = run_text(cycle("out", "in"));
  ASSERT_EQ(words.status, Status::ok) << words.message << to_text(words.errors);
  EXPECT_NEAR(value_of(words, "cycle_energy"), value_of(right, "cycle_energy"), 1e-9 * value_of(right, "cycle_energy"));
}

TEST(RopeSense, ALoadPathWhoseRopesCannotBothRunSoIsUnsafe) {
  const std::string path = "  - load_path: {carriage: car, from: 60 m, to: 120 m, steps: 6, motion: ";
  for (const auto& [motion, contrary] : {std::pair{"out", false},
                                         {"in", false},
                                         {"{haulback: 1, mainline: 1}", true},
                                         {"{haulback: -1, mainline: -1}", true},
                                         {"{haulback: -1, mainline: 1}", false},
                                         {"{haulback: 1, mainline: -1}", false}}) {
    const Result r = run_text(running_skyline(path + motion + "}\n"));
    ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    EXPECT_EQ(!r.unsafe.empty(), contrary) << motion;
    const std::string first = r.unsafe.empty() ? "" : r.unsafe.front();
    EXPECT_EQ(first.find("can't both run as declared") != std::string::npos, contrary) << first;
  }
  const Result all =
      run_text(running_skyline("  - envelope: {carriage: car, from: 60 m, to: 120 m, steps: 6, motions: [out]}\n"));
  ASSERT_EQ(all.status, Status::ok) << all.message << to_text(all.errors);
  EXPECT_TRUE(all.unsafe.empty());
}

/// A gravity carriage with rolling friction: the skyline's ends lie still, and it passes the carriage the other way.
TEST(RopeSense, FrictionOfACarriageThatGivesEnergyIsRefused) {
  const auto deck = [](const std::string& motion) {
    return R"(taut: 1
machine:
  points: {low: [0 m, 0 m, 0 m], high: [300 m, 0 m, 60 m], winch: [300 m, 0 m, 58 m]}
  ropes: {sky: {mass: 2 kg/m, stiffness: 30 MN}, main: {mass: 0.5 kg/m, stiffness: 8 MN}}
  carriages: {car: {mass: 900 kg, rides: sky, hold: rolling, friction: 0.03, mainline: main}}
  reevings:
    - {rope: sky, path: [{anchor: low}, {through: car}, {anchor: high}], length: 309 m}
    - {rope: main, path: [{anchor: winch}, {anchor: car}], length: 100 m}
analyses:
  - cycle: {carriage: car, from: 200 m, to: 240 m, steps: 4, phases: [{name: up, motion: )" +
           motion + "}]}\n";
  };
  const Result against = run_text(deck("{car: 1}"));
  EXPECT_EQ(against.status, Status::infeasible) << to_text(against.errors);
  EXPECT_NE(against.message.find("sky over car"), std::string::npos) << against.message;
  EXPECT_NE(against.message.find("'motion: {car: -1}'"), std::string::npos) << against.message;
  const Result with = run_text(deck("{car: -1}")), none = run_text(deck("{car: 0}"));
  ASSERT_EQ(with.status, Status::ok) << with.message << to_text(with.errors);
  ASSERT_EQ(none.status, Status::ok) << none.message << to_text(none.errors);
  // the carriage goes to where its mainline is hauled: a word says both
  const Result in = run_text(deck("in"));
  ASSERT_EQ(in.status, Status::ok) << in.message;
  EXPECT_NEAR(value_of(in, "cycle_energy"), value_of(with, "cycle_energy"), 1e-9 * value_of(with, "cycle_energy"));
  EXPECT_EQ(run_text(deck("out")).status, Status::infeasible);
  EXPECT_GT(value_of(with, "cycle_energy"), 1.05 * value_of(none, "cycle_energy"));
}

TEST(RopeSense, RopeOnArcsBelongsToWhatRuns) {
  // as the carriage goes down, rope leaves the wide crest: the spans beside the jack become longer, and yet rope runs
  // over the jack towards the far end. The end of the crest's arc moves, and no rope runs over it: its sense is free
  const auto deck = [](const std::string& down, const std::string& up) {
    return R"(taut: 1
machine:
  points: {low: [0 m, 0 m, 0 m], far: [760 m, 0 m, -130 m], winch: [0 m, 0 m, 2 m]}
  ropes: {sky: {mass: 2.8 kg/m, stiffness: 28 MN}, main: {mass: 0.44 kg/m, stiffness: 4.5 MN}}
  supports:
    crest: {at: [71 m, 0 m, 19 m], diameter: 12 m, friction: 0.0085}
    jack: {at: [292 m, 0 m, -22 m], diameter: 400 mm, friction: 0.045}
  carriages: {car: {mass: 1.1 t, rides: sky, hold: rolling, mainline: main}}
  reevings:
    - rope: sky
      path: [{anchor: low}, {over: crest}, {through: car}, {over: jack}, {anchor: far}]
      tension_at_end: 89 kN
    - {rope: main, path: [{anchor: winch}, {anchor: car}], length: 185 m}
analyses:
  - cycle:
      carriage: car
      from: 176 m
      to: 192 m
      steps: 6
      phases: [{name: down, motion: )" +
           down + "}, {name: up, motion: " + up + "}]\n";
  };
  const Result against = run_text(deck("{sky: -1}", "{sky: 1}"));
  EXPECT_EQ(against.status, Status::infeasible) << "else the winches would gain energy";
  EXPECT_NE(against.message.find("cycle, down: sky runs 0.0"), std::string::npos) << against.message;
  EXPECT_NE(against.message.find("'motion: {jack: 1}'"), std::string::npos) << against.message;
  const Result with = run_text(deck("{sky: 1}", "{sky: -1}"));
  ASSERT_EQ(with.status, Status::ok) << with.message << to_text(with.errors);
  EXPECT_GT(value_of(with, "cycle_energy"), 5);
  const Result other = run_text(deck("{jack: 1, crest: -1}", "{jack: -1, crest: 1}"));
  ASSERT_EQ(other.status, Status::ok) << other.message << to_text(other.errors);
  EXPECT_NEAR(value_of(other, "cycle_energy"), value_of(with, "cycle_energy"), 1e-6);
}

TEST(RopeSense, AnArcThatGrowsFromBothSidesSlipsOneWay) {
  // as the carriage goes out, the saddle's arc grows by 33 mm at its near end: 23 mm come from the near side, and 10 mm
  // slip back over all of the saddle from the far one
  const auto deck = [](double friction) {
    return fmt::format(R"(taut: 1
machine:
  points: {{A: [0 m, 0 m, 10 m], B: [297.4733 m, 0 m, -136.88 m], winch: [0 m, 0 m, 8 m]}}
  ropes: {{sky: {{mass: 0.8355 kg/m, stiffness: 9.0657 MN}}, main: {{mass: 0.4263 kg/m, stiffness: 4.954 MN}}}}
  supports: {{S1: {{at: [120.0396 m, 0 m, -22.0268 m], diameter: 12 m, friction: {}, law: saddle, uplift: hold}}}}
  carriages: {{car: {{mass: 119.8 kg, rides: sky, hold: rolling, at: [24.4744 m, 0 m, -1.3314 m], mainline: main}}}}
  reevings:
    - {{rope: sky, path: [{{anchor: A}}, {{through: car}}, {{over: S1}}, {{anchor: B}}], length: 336.89 m}}
    - {{rope: main, path: [{{anchor: winch}}, {{anchor: car}}], length: 24.96 m}}
analyses:
  - cycle: {{carriage: car, from: 16.5 m, to: 32.5 m, steps: 24, phases: [{{name: a, motion: {{S1: -1}}}}, {{name: b, motion: {{S1: 1}}}}]}}
)",
                       friction);
  };
  const Result rough = run_text(deck(0.0889)), half = run_text(deck(0.04445));
  ASSERT_EQ(rough.status, Status::ok) << rough.message << to_text(rough.errors);
  ASSERT_EQ(half.status, Status::ok) << half.message << to_text(half.errors);
  // what friction takes out and back: its force, 24.6 kN (1 - exp(-mu wrap)), on 10 mm and on the turn
  EXPECT_NEAR(value_of(rough, "cycle_energy"), 25.9, 0.3);
  EXPECT_GT(value_of(rough, "cycle_energy"), 1.8 * value_of(half, "cycle_energy"));
  EXPECT_GT(value_of(half, "cycle_energy"), 5);
}

TEST(RopeSense, NamesTheRopeWhereAllOfItIsWrongElseTheContact) {
  const std::vector<RopeSense> one = {{.rope = "line", .contact = "a", .declared = 1, .with = 0, .against = 3},
                                      {.rope = "line", .contact = "b", .declared = 1, .with = 2, .against = 0}};
  EXPECT_NE(wrong_senses(one)->find("{a: -1}"), std::string::npos) << *wrong_senses(one);
  const std::vector<RopeSense> both = {{.rope = "line", .contact = "a", .declared = 1, .with = 0, .against = 3},
                                       {.rope = "line", .contact = "b", .declared = 1, .with = 0, .against = 2}};
  EXPECT_NE(wrong_senses(both)->find("{line: -1}"), std::string::npos) << *wrong_senses(both);
  const std::vector<RopeSense> in_part = {{.rope = "line", .contact = "a", .declared = 1, .with = 1, .against = 3}};
  EXPECT_FALSE(wrong_senses(in_part));
  EXPECT_FALSE(contrary_senses(in_part));
}

}  // namespace rope_sense_test
