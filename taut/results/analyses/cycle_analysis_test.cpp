#include <fmt/format.h>

#include <array>
#include <vector>

#include "test/support/machine_decks.hpp"

namespace cycle_analysis_test {

using namespace taut_test;
using taut::Result;
using taut::Status;
using taut::Table;

/// A carriage drawn up a rope by a rope without weight, without losses: the winch's work is the change of energy.
std::string incline(const std::string& phases, int steps, const std::string& speed = "") {
  return fmt::format(R"(taut: 1
machine:
  points: {{low: [0 m, 0 m, 0 m], high: [200 m, 0 m, 60 m]}}
  ropes:
    track: {{mass: 2 kg/m, stiffness: 30 MN}}
    pull: {{mass: 0 kg/m, stiffness: 4 MN}}
  drums: {{winch: {{at: [200 m, 0 m, 60 m], core_diameter: 1 mm}}}}
  carriages: {{car: {{mass: 300 kg, rides: track, hold: rolling, mainline: pull}}}}
  reevings:
    - {{rope: track, path: [{{anchor: low}}, {{through: car}}, {{anchor: high}}], length: 211 m}}
    - {{rope: pull, path: [{{drum: winch}}, {{anchor: car}}], length: 100 m}}
analyses:
  - cycle: {{carriage: car, from: 60 m, to: 150 m, steps: {}{}, phases: [{}]}}
)",
                     steps, speed, phases);
}

/// Energy of the incline in a state: weights, the track's own, and what both ropes store, J.
double energy_at(double x, double load) {
  const std::string deck = incline("{name: a}", 1);
  const Result r = run_text(deck, {fmt::format("analyses=[{{equilibrium: {{carriage: car, x: {:.17g} m}}}}]", x),
                                   fmt::format("machine.loads=[{{at: car, mass: {} kg}}]", load)});
  EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  double energy = (300 + load) * 9.80665 * value_of(r, "car.z");
  const Table& spans = table_of(r, "spans");
  for (std::size_t i = 0; i < spans.rows.size(); ++i) {
    const bool track = text_cell(spans, i, "rope") == "track";
    const double w = track ? 2 * 9.80665 : 0, EA = track ? 30e6 : 4e6;
    const double L = cell(spans, i, "unstretched"), H = cell(spans, i, "H"), V = cell(spans, i, "V_from");
    // by summation along the rope: height from the start, and T^2/2EA
    const double start = text_cell(spans, i, "from") == "low"     ? 0
                         : text_cell(spans, i, "from") == "winch" ? 60
                                                                  : value_of(r, "car.z");
    constexpr int pieces = 20000;
    double z = start;
    for (int k = 0; k < pieces; ++k) {
      const double ds = L / pieces, V_mid = V + w * (k + 0.5) * ds, T = std::hypot(H, V_mid);
      const double rise = V_mid / T * (1 + T / EA) * ds;
      energy += w * ds * (z + rise / 2) + T * T / (2 * EA) * ds;
      z += rise;
    }
  }
  return energy;
}

TEST(CycleAnalysis, TheWinchsWorkIsTheChangeOfEnergy) {
  // what is wound up takes its own stored energy T^2/2EA along: the winch gives T (1 + T/EA) dL, of which T + T^2/2EA
  // stays in the machine
  const Result r = run_text(incline("{name: up, motion: in, load: 1200 kg}", 180));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const Table& positions = table_of(r, "cycle");
  double wound = 0;
  for (std::size_t i = 1; i < positions.rows.size(); ++i) {
    const double T = (cell(positions, i, "winch.pull") + cell(positions, i - 1, "winch.pull")) / 2;
    const double way =
        cell(table_of(r, "cycle_work"), 0, "rope_taken_in") / (static_cast<double>(positions.rows.size()) - 1);
    wound += T * T / (2 * 4e6) * way;
  }
  const double change = energy_at(150, 1200) - energy_at(60, 1200);
  const double energy = value_of(r, "winch.energy");
  EXPECT_GT(wound, 0);
  EXPECT_NEAR((energy - wound) / change, 1, 2e-5);
  EXPECT_NEAR(energy, cell(table_of(r, "cycle_work"), 0, "energy"), 1e-9 * energy);
  // the trapezoids converge with the square of the step
  const double coarse = value_of(run_text(incline("{name: up, motion: in, load: 1200 kg}", 10)), "winch.energy");
  const double finer = value_of(run_text(incline("{name: up, motion: in, load: 1200 kg}", 20)), "winch.energy");
  EXPECT_NEAR((coarse - energy) / (finer - energy), 4, 0.5);
}

TEST(CycleAnalysis, UpAndDownAgainWithoutLossIsNothing) {
  const Result r =
      run_text(incline("{name: up, motion: in, load: 800 kg}, {name: down, motion: out, load: 800 kg}", 24));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_NEAR(value_of(r, "cycle_energy") / value_of(r, "winch.pull_max"), 0, 1e-5);
  const Table& t = table_of(r, "cycle_work");
  EXPECT_NEAR(cell(t, 0, "energy") + cell(t, 1, "energy"), 0, 1e-3);
  EXPECT_NEAR(cell(t, 0, "pull_mean") / cell(t, 1, "pull_mean"), 1, 1e-8);
  EXPECT_NEAR(cell(table_of(r, "cycle"), 0, "x"), 60, 0);
  EXPECT_NEAR(cell(table_of(r, "cycle"), 25, "x"), 150, 0) << "the second phase goes back";
}

TEST(CycleAnalysis, PowerIsPullTimesSpeedOfTheRope) {
  const Result r = run_text(incline("{name: up, motion: in, load: 800 kg}", 90, ", speed: 2 m/s"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const Table& t = table_of(r, "cycle");
  const double way = cell(t, 90, "way");
  EXPECT_NEAR(value_of(r, "cycle_time"), way / 2, 1e-9);
  EXPECT_NEAR(cell(table_of(r, "cycle_work"), 0, "duration"), way / 2, 1e-9);
  // mean power times time is the energy, and the largest is between the largest pull with and without the rope's way
  const double P = value_of(r, "winch.power_max"), F = value_of(r, "winch.pull_max");
  EXPECT_GT(P, value_of(r, "winch.energy") / (way / 2));
  EXPECT_NEAR(P / (2 * F), 1, 0.02);
}

TEST(CycleAnalysis, AClosedCycleEndsWithTheRopeThatItBeganWith) {
  // 150.3 + (60.1 - 150.3) is not 60.1 in its last digit: the way back ends at its last place all the same
  for (const char* way : {"from: 60 m, to: 150 m", "from: 60.1 m, to: 150.3 m"}) {
    for (const double load_down : {800.0, 200.0}) {
      std::string deck = incline(fmt::format("{{name: up, motion: {{track: -1}}, load: 800 kg}}, "
                                             "{{name: down, motion: {{track: 1}}, load: {} kg}}",
                                             load_down),
                                 24);
      deck.replace(deck.find("length: 211 m"), 13, "tension_at_end: 60 kN");
      deck.replace(deck.find("from: 60 m, to: 150 m"), 21, way);
      const Result r = run_text(deck, {"machine.carriages.car.friction=0.2"});
      ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
      const Table& t = table_of(r, "cycle_work");
      double taken = 0, energy = 0;
      for (std::size_t i = 0; i < t.rows.size(); ++i) {
        if (text_cell(t, i, "winch") != "high") continue;
        taken += cell(t, i, "rope_taken_in");
        energy += cell(t, i, "energy");
      }
      EXPECT_EQ(std::abs(taken) < 1e-6, load_down == 800) << way << ": " << taken;
      EXPECT_NEAR(energy / (60e3 * (1 + 60e3 / 30e6)), taken / (1 + 60e3 / 30e6), 1e-6);
    }
  }
}

/// A line over one support that loses tension, at a place: {T before it, T behind it, rope between start and support}.
std::array<double, 3> at_support(const std::string& deck, double x, const std::string& motion) {
  const std::string state =
      fmt::format("analyses=[{{equilibrium: {{carriage: car, x: {:.17g} m, motion: {}}}}}]", x, motion);
  const Result r = run_text(deck, {state});
  EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const Table& spans = table_of(r, "spans");
  return {cell(spans, 1, "T_to"), cell(spans, 2, "T_from"),
          cell(spans, 0, "unstretched") + cell(spans, 1, "unstretched")};
}

TEST(CycleAnalysis, TheWinchGivesInACycleWhatFrictionTakes) {
  // from single states at rest: what the tension loses over the support, times the rope that runs over it, both turns
  // counted, where the carriage stands and friction changes its sense
  const std::string deck = R"(taut: 1
machine:
  points: {low: [0 m, 0 m, 10 m], high: [385 m, 0 m, 117 m], winch: [385 m, 0 m, 115 m]}
  ropes: {sky: {mass: 0.96 kg/m, stiffness: 8.8 MN}, main: {mass: 0.3 kg/m, stiffness: 4.5 MN}}
  supports: {jack: {at: [140.6 m, 0 m, 65 m], diameter: 2 mm, efficiency: 0.914, law: sheave, uplift: hold}}
  carriages: {car: {mass: 272 kg, rides: sky, hold: rolling, mainline: main}}
  reevings:
    - {rope: sky, path: [{anchor: low}, {through: car}, {over: jack}, {anchor: high}], length: 402.5 m, haul: to_start}
    - {rope: main, path: [{anchor: winch}, {anchor: car}], length: 366 m}
analyses:
  - cycle:
      {carriage: car, from: 23.8 m, to: 39.7 m, steps: 24, phases: [{name: up, motion: in}, {name: down, motion: out}]}
)";
  const Result r = run_text(deck);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  constexpr int steps = 16;
  constexpr double from = 23.8, to = 39.7;
  std::vector<std::array<double, 3>> states;
  for (int i = 0; i <= steps; ++i) states.push_back(at_support(deck, from + (to - from) * i / steps, "in"));
  for (int i = steps; i >= 0; --i) states.push_back(at_support(deck, from + (to - from) * i / steps, "out"));
  states.push_back(states.front());
  double taken = 0;
  for (std::size_t i = 1; i < states.size(); ++i) {
    const auto& [T0, U0, L0] = states[i - 1];
    const auto& [T1, U1, L1] = states[i];
    taken += (T0 - U0 + T1 - U1) / 2 * (L1 - L0);
  }
  EXPECT_GT(taken, 50);
  EXPECT_NEAR(value_of(r, "cycle_energy"), taken, 0.02 * taken);
  // a place in another unit, and one on the support, where both phases end beside it
  const Result other =
      run_text(deck, {"analyses[0].cycle.phases[1].from=3970 cm", "analyses[0].cycle.phases[1].to=0.0238 km"});
  EXPECT_NEAR(value_of(other, "cycle_energy"), value_of(r, "cycle_energy"), 1e-6);
  const Result on_jack = run_text(
      deck, {"analyses[0].cycle.from=130.6 m", "analyses[0].cycle.to=140.6 m", "machine.reevings[0].haul=to_end"});
  const Table& works = table_of(on_jack, "cycle_work");
  EXPECT_GT(value_of(on_jack, "cycle_energy"), 0);
  EXPECT_NEAR(cell(works, 0, "rope_taken_in") + cell(works, 1, "rope_taken_in"), 0, 1e-3);
}

TEST(CycleAnalysis, LossesCostEnergyBothWays) {
  const std::string loss = "machine.carriages.car.friction=0.2";
  const std::string phases = "{name: up, motion: in, load: 800 kg}, {name: down, motion: out, load: 800 kg}";
  const Result r = run_text(incline(phases, 24), {loss});
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const double without = value_of(run_text(incline(phases, 24)), "winch.pull_max");
  EXPECT_GT(value_of(r, "winch.pull_max"), 1.1 * without);
  EXPECT_GT(value_of(r, "cycle_energy"), 0.1 * without * 90) << "both ways cost";
}

TEST(CycleAnalysis, TellsEachMistakeAtItsPlace) {
  const std::string good = incline("{name: up, motion: in}", 10);
  expect_mistake(run_text(good, {"analyses[0].cycle.carriage=cat"}), "there is no carriage 'cat'; did you mean 'car'?");
  expect_mistake(run_text(good, {"analyses[0].cycle.phases[0].motion=inn"}),
                 "phases[0].motion: there is no motion 'inn'");
  expect_mistake(run_text(good, {"analyses[0].cycle.to=60 m"}), "phases[0]: its carriage does not move");
  expect_mistake(run_text(good, {"analyses[0].cycle.speed=2"}), "speed");
  expect_mistake(run_text(good, {"analyses[0].cycle.phases[0]={motion: in}"}), "lacks 'name'");
}

TEST(CycleAnalysis, CountsOneMotorForEachEndlessRope) {
  const std::vector<std::string> endless = {
      "machine.sheaves={drive: {at: [0 m, 0 m, -2 m], diameter: 1 m, friction: 0.3, motor: {}}, back: {at: [200 m, 0 "
      "m, 58 m], "
      "diameter: 1 m, friction: 0.3, motor: {torque: 1 kN m}}}",
      "machine.reevings[1]={rope: pull, path: [{over: drive}, {through: car}, {over: back}], closed: true, length: 422 "
      "m}",
      "machine.carriages.car={mass: 300 kg, rides: track, hold: fixed_to, fixed_to: pull}", "machine.drums={}"};
  const Result r = run_text(incline("{name: a}", 4), endless);
  EXPECT_NE(to_text(r.errors).find("a cycle counts one motor"), std::string::npos) << to_text(r.errors) << r.message;
}

/// One rope, or two of half the mass and stiffness; along x, or turned in plan: the winch does the same work on the
/// same way in the same time.
TEST(CycleAnalysis, TheWorkOfAllCopiesAndTheWayInSpace) {
  const auto cycle =
      [](const std::string& line, const std::string& rope, const std::string& copies, const std::string& ways) {
        return taut_test::run_text(R"(taut: 1
machine:
  points: {tail: [0 m, 0 m, 20 m], tower: [)" +
                                   line + R"(, 80 m]}
  ropes: {sky: {mass: 2 kg/m, stiffness: 20 MN, breaking_force: 500 kN}, main: {breaking_force: 100 kN, )" +
                                   rope + R"(}}
  carriages: {car: {mass: 2000 kg, rides: sky, mainline: main}}
  drums: {win: {at: [)" + line + R"(, 79 m], core_diameter: 0 mm}}
  reevings:
    - {rope: sky, path: [{anchor: tail}, {through: car}, {anchor: tower}], tension_at_start: 120 kN}
    - {rope: main, path: [{drum: win}, {anchor: car}], length: 200 m)" +
                                   copies + R"(}
analyses: [{cycle: {carriage: car, )" +
                                   ways + R"(, steps: 8, speed: 2 m/s, phases: [{name: in, motion: in, load: 1 t}]}}]
)");
      };
  const std::string one = "mass: 1 kg/m, stiffness: 8 MN", half = "mass: 0.5 kg/m, stiffness: 4 MN";
  const Result alone = cycle("300 m, 0 m", one, "", "from: 60 m, to: 240 m");
  const Result two = cycle("300 m, 0 m", half, ", copies: 2", "from: 60 m, to: 240 m");
  const Result turned = cycle("180 m, 240 m", one, "", "from: 36 m, to: 144 m");  // by x
  ASSERT_EQ(alone.status, Status::ok) << alone.message << to_text(alone.errors);
  for (const Result& r : {two, turned}) {
    ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    for (const char* name : {"cycle_time", "cycle_energy", "win.power_max"}) {
      const double x = taut_test::value_of(alone, name);
      EXPECT_NEAR(taut_test::value_of(r, name), x, 1e-6 * std::abs(x)) << name;
    }
  }
}

/// A skyline under a tension held by its winch gives where the carriage takes rope, and brakes where it lets rope go:
/// by P = -T d(chords)/ds v. The largest power given is not lost behind a larger one that is braked.
TEST(CycleAnalysis, TheLargestPowerGivenStandsBesideALargerOneBraked) {
  const Result r = run_text(R"(taut: 1
machine:
  points: {a: [0 m, 0 m, 30 m], c: [0 m, 0 m, 29 m], b: [200 m, 0 m, 30 m]}
  ropes: {sky: {mass: 0 kg/m, stiffness: .inf}, main: {mass: 0 kg/m, stiffness: .inf}, hb: {mass: 0 kg/m, stiffness: .inf}}
  carriages: {car: {mass: 500 kg, rides: sky, hold: rolling, mainline: main, haulback: hb}}
  reevings:
    - {rope: sky, path: [{anchor: a}, {through: car}, {anchor: b}], tension_at_start: 60 kN}
    - {rope: main, path: [{anchor: b}, {anchor: car}], length: 100 m}
    - {rope: hb, path: [{anchor: c}, {anchor: car}], tension_at_start: 5 kN}
analyses:
  - cycle: {carriage: car, from: 180 m, to: 40 m, steps: 100, phases: [{name: fast, motion: at_rest, speed: 5 m/s, load: 1000 kg},
      {name: slow, motion: at_rest, speed: 0.5 m/s, load: 1000 kg}]}
)");
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const Table& steps = table_of(r, "cycle");
  double given = 0, braked = 0;
  for (std::size_t i = 1; i < steps.rows.size(); ++i) {
    if (text_cell(steps, i, "phase") != "fast" || text_cell(steps, i - 1, "phase") != "fast") continue;
    const auto chords = [&](std::size_t k) {
      const double x = cell(steps, k, "x"), down = 30 - cell(steps, k, "z");
      return std::hypot(x, down) + std::hypot(200 - x, down);
    };
    const double way = cell(steps, i, "way") - cell(steps, i - 1, "way");
    const double power = -60e3 * (chords(i) - chords(i - 1)) / way * 5;
    given = std::max(given, power);
    braked = std::min(braked, power);
  }
  EXPECT_GT(given, 4e3);
  EXPECT_LT(braked, -given);
  EXPECT_NEAR(value_of(r, "a.power_max"), given, 1e-6 * given);
}

/// Two ropes that end in one place are two winches: each has its own pull, energy and power.
TEST(CycleAnalysis, TwoRopesAtOnePlaceAreTwoWinches) {
  const Result r = run_text(R"(taut: 1
machine:
  points: {a: [0 m, 0 m, 30 m], b: [200 m, 0 m, 30 m]}
  ropes: {sky: {mass: 0 kg/m, stiffness: 20 MN}, main: {mass: 0 kg/m, stiffness: 8 MN}}
  carriages: {car: {mass: 500 kg, rides: sky, hold: rolling, mainline: main}}
  reevings:
    - {rope: sky, path: [{anchor: a}, {through: car}, {anchor: b}], tension_at_start: 60 kN}
    - {rope: main, path: [{anchor: a}, {anchor: car}], length: 100 m}
analyses:
  - cycle: {carriage: car, from: 20 m, to: 90 m, steps: 7, speed: 2 m/s, phases: [{name: out, motion: at_rest}]}
)");
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_NEAR(value_of(r, "a.sky.pull_max"), 60e3, 1);
  EXPECT_LT(value_of(r, "a.main.pull_max"), 20e3);
  EXPECT_NEAR(value_of(r, "a.sky.energy") + value_of(r, "a.main.energy"), value_of(r, "cycle_energy"), 1e-6);
  EXPECT_LT(cell(table_of(r, "cycle"), 1, "a.main.pull"), 20e3);
  EXPECT_EQ(r.find_value("a.power_max"), nullptr) << "no drum: nothing turns them together";
}

/// A mainline and a haulback on one drum: what one brakes drives the other, and the drum has to give the rest. Ropes
/// without weight or stretch are as long as their chords, so the power of a step is -(T dL)/ds v of both, T the mean of
/// its ends. The largest one is neither that of the mainline nor the sum of both largest ones.
TEST(CycleAnalysis, RopesOnOneDrumHaveANetPower) {
  const Result r = run_text(R"(taut: 1
machine:
  points: {a: [0 m, 0 m, 30 m], b: [200 m, 0 m, 30 m]}
  ropes: {sky: {mass: 0 kg/m, stiffness: 20 MN}, main: {mass: 0 kg/m, stiffness: .inf}, hb: {mass: 0 kg/m, stiffness: .inf}}
  drums: {winch: {at: [200 m, 0 m, 29 m], core_diameter: 0 mm}}
  sheaves: {tail: {at: [0 m, 0 m, 29 m], diameter: 0 mm}}
  carriages: {car: {mass: 500 kg, rides: sky, hold: rolling, mainline: main, haulback: hb}}
  reevings:
    - {rope: sky, path: [{anchor: a}, {through: car}, {anchor: b}], length: 201 m}
    - {rope: main, path: [{drum: winch}, {anchor: car}], length: 100 m}
    - {rope: hb, path: [{drum: winch}, {over: tail}, {anchor: car}], tension_at_start: 5 kN}
analyses:
  - cycle: {carriage: car, from: 60 m, to: 150 m, steps: 20, speed: 2 m/s, phases: [{name: in, motion: at_rest, load: 1000 kg}]}
)");
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const Table& steps = table_of(r, "cycle");
  double most = 0, at = 0;
  for (std::size_t i = 1; i < steps.rows.size(); ++i) {
    const auto chord = [&](std::size_t k, double x) {
      return std::hypot(cell(steps, k, "x") - x, 29 - cell(steps, k, "z"));
    };
    const double T = (cell(steps, i, "winch.main.pull") + cell(steps, i - 1, "winch.main.pull")) / 2;
    const double way = cell(steps, i, "way") - cell(steps, i - 1, "way");
    const double power = -2 * (T * (chord(i, 200) - chord(i - 1, 200)) + 5e3 * (chord(i, 0) - chord(i - 1, 0))) / way;
    if (power <= most) continue;
    most = power;
    at = cell(steps, i, "x");
  }
  EXPECT_NEAR(value_of(r, "winch.power_max"), most, 1e-6 * most);
  EXPECT_LT(most, 0.3 * value_of(r, "winch.main.power_max"));
  EXPECT_LT(value_of(r, "winch.hb.power_max"), -9e3);
  EXPECT_EQ(r.find_value("winch.power_max")->label,
            fmt::format("largest net power of winch: winch.main and winch.hb together (in, x = {:g} m to {:g} m)",
                        at - 4.5, at));
}

}  // namespace cycle_analysis_test
