// Decks of carriages, run as a user would: the same machine put in other words has the same numbers.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "taut/app/job.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::app::machine_carriages_test {

using taut_test::run_text;
using taut_test::value_of;

/// The closed loop of the published example, by its place alone.
const char* const closed_loop = R"(taut: 1
machine:
  points: {A: [0 m, 0 m, 0 m]}
  ropes: {traction: {mass: 1.5 kg/m, stiffness: .inf}, return: {mass: 1 kg/m, stiffness: .inf}}
  sheaves: {B: {at: [200 m, 0 m, 0 m], efficiency: 0.9}}
  carriages: {car: {rides: return, mainline: traction}}
  reevings:
    - {rope: traction, path: [{anchor: A}, {anchor: car}], length: 100 m}
    - {rope: return, path: [{anchor: car}, {over: B}, {through: car}, {anchor: A}], length: 300 m}
  loads: [{at: car, force: [14709.975 N, 0 N, -25478.42408 N]}]
analyses:
  - equilibrium: {motion: in, carriage: car, x: 100 m, z: -10 m}
)";

TEST(MachineCarriages, TheClosedLoopOfThePaperByItsPlace) {
  const Result r = run_text(closed_loop);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const double kgf = 9.80665;
  EXPECT_NEAR(value_of(r, "traction.T_start") / kgf, 8587.9, 0.0005 * 8587.9);
  EXPECT_NEAR(value_of(r, "return.T_max") / kgf, 7077.8, 0.0005 * 7077.8);
  EXPECT_NEAR(value_of(r, "traction.unstretched") + value_of(r, "return.unstretched"), 401.999, 0.001);
}

/// A line of 220 m with a carriage of two rollers and a dragged bunch, turned by an angle in plan.
std::string turned_line(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const auto at = [&](double x, double y, double z) {
    return fmt::format("[{:.17g} m, {:.17g} m, {:.17g} m]", c * x - s * y, s * x + c * y, z);
  };
  const std::string along = fmt::format("[{:.17g}, {:.17g}]", c, s);
  return fmt::format(R"(taut: 1
machine:
  points: {{tail: {}, tower: {}, winch: {}}}
  ropes: {{sky: {{mass: 1.7 kg/m, stiffness: 20 MN}}, main: {{mass: 0.6 kg/m, stiffness: 7 MN}}}}
  supports: {{jack: {{at: {}, diameter: 400 mm, axis: [{:.17g}, {:.17g}, 0], friction: 0.1}}}}
  carriages: {{car: {{mass: 300 kg, rides: sky, rollers: 2, wheelbase: 0.9 m, height: 0.3 m, mainline: main}}}}
  reevings:
    - {{rope: sky, path: [{{anchor: tail}}, {{through: car}}, {{over: jack}}, {{anchor: tower}}], length: 240 m}}
    - {{rope: main, path: [{{anchor: winch}}, {{anchor: car}}], length: 120 m}}
  loads: [{{at: car, mass: 1.5 t, dragged: {{ground_angle: 15 deg, friction: 0.5, share: 0.6, along: {}}}}}]
  terrain: {{x: [-5 m, 60 m, 130 m, 225 m], z: [-3 m, 2 m, 25 m, 60 m], along: {}}}
analyses:
  - equilibrium: {{carriage: car, x: 70 m, along: {}}}
  - load_path: {{carriage: car, from: 30 m, to: 200 m, steps: 17, along: {}}}
)",
                     at(0, 0, 9), at(220, 0, 80), at(221, 0, 78), at(140, 0, 45), -s, c, along, along, along, along);
}

TEST(MachineCarriages, ALineTurnedInPlanHasTheSameNumbers) {
  const Result a = run_text(turned_line(0));
  ASSERT_EQ(a.status, Status::ok) << a.message << to_text(a.errors);
  for (const double angle : {0.4, M_PI / 2, -2.2}) {
    const Result b = run_text(turned_line(angle));
    ASSERT_EQ(b.status, Status::ok) << b.message << to_text(b.errors);
    for (const char* name : {"sky.T_max", "main.T_max", "car.z", "clearance_min", "rope_clearance_min", "main.T_start"})
      EXPECT_NEAR(value_of(b, name) / value_of(a, name), 1, 1e-9) << name << " at " << angle;
    const Table *ta = a.find_table("load_path"), *tb = b.find_table("load_path");
    ASSERT_TRUE(ta != nullptr && tb != nullptr);
    for (std::size_t i = 0; i < ta->rows.size(); ++i) {
      for (std::size_t k = 0; k < ta->columns.size(); ++k) {
        if (ta->columns[k].name.ends_with("Fx") || ta->columns[k].name == "closure") continue;
        const double x = std::get<double>(ta->rows[i][k]), y = std::get<double>(tb->rows[i][k]);
        if (std::isnan(x) && std::isnan(y)) continue;
        EXPECT_NEAR(x, y, 1e-8 * std::max(1.0, std::abs(x))) << ta->columns[k].name << " in row " << i;
      }
    }
  }
}

TEST(MachineCarriages, TheLowestRopeByHand) {
  // a level parabola-like span of 100 m over a hill of 10 m in its middle and a plain: 5 m of sag from 20 m
  const char* const text = R"(taut: 1
machine:
  points: {a: [0 m, 0 m, 20 m], b: [100 m, 0 m, 20 m]}
  ropes: {r: {mass: 1 kg/m, stiffness: .inf}}
  reevings: [{rope: r, path: [{anchor: a}, {anchor: b}], length: 100.662281 m}]
  terrain: {x: [-10 m, 30 m, 40 m, 110 m], z: [0 m, 0 m, 10 m, 0 m]}
)";
  const Result r = run_text(text);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  // catenary z = a cosh((x - 50)/a): over the hilltop at x = 40, and the deepest point at 50
  const Table* spans = r.find_table("spans");
  ASSERT_NE(spans, nullptr);
  double H = 0;
  for (std::size_t k = 0; k < spans->columns.size(); ++k) {
    if (spans->columns[k].name == "H") H = std::get<double>(spans->rows[0][k]);
  }
  const double a = H / 9.80665;
  const auto z = [&](double x) { return 20 + a * (std::cosh((x - 50) / a) - std::cosh(50 / a)); };
  double least = 1e9;
  for (int i = 1; i < 200000; ++i) {
    const double x = 100.0 * i / 200000;
    const double ground = x < 30 ? 0 : x < 40 ? x - 30 : 10 - (x - 40) / 7;
    least = std::min(least, z(x) - ground);
  }
  EXPECT_NEAR(value_of(r, "rope_clearance_min"), least, 1e-6);
}

TEST(MachineCarriages, MistakesAreToldAtTheirPlace) {
  const std::string two_lengths = R"(taut: 1
machine:
  points: {a: [0 m, 0 m, 20 m], b: [100 m, 0 m, 40 m]}
  ropes: {r: {mass: 1 kg/m, stiffness: 10 MN}}
  carriages: {car: {mass: 100 kg, rides: sky, mainline: main, haulback: back}}
  reevings:
    - {name: sky, rope: r, path: [{anchor: a}, {through: car}, {anchor: b}], length: 104 m}
    - {name: main, rope: r, path: [{anchor: b}, {anchor: car}], length: 50 m}
    - {name: back, rope: r, path: [{anchor: a}, {anchor: car}], length: 56 m}
analyses:
  - load_path: {carriage: car, from: 20 m, to: 80 m}
)";
  const Result r = run_text(two_lengths);
  EXPECT_EQ(exit_code(r), 2);
  EXPECT_NE(to_text(r.errors).find("deck.yaml:5:"), std::string::npos) << to_text(r.errors);
  EXPECT_NE(to_text(r.errors).find("give the pull of 'back' or of 'main'"), std::string::npos) << to_text(r.errors);
  for (const char* bad : {"along: [0, 0]", "along: [1]", "along: [1, 0, 0]"}) {
    const Result wrong =
        run_text(closed_loop, {fmt::format("analyses[0].equilibrium.{}", "along=" + std::string(bad + 7))});
    EXPECT_EQ(exit_code(wrong), 2) << bad;
  }
  EXPECT_EQ(exit_code(run_text(closed_loop, {"machine.carriages.car.rollers=2"})), 2);
}

TEST(MachineCarriages, AFreeCarriageThatRunsAwayIsAnAnswerOfThePhysics) {
  const std::string text = R"(taut: 1
machine:
  points: {head: [0 m, 0 m, 20 m], tail: [100 m, 0 m, 80 m]}
  ropes: {r: {mass: 1.5 kg/m, stiffness: 20 MN}}
  carriages: {car: {mass: 50 kg, rides: r}}
  reevings: [{rope: r, path: [{anchor: head}, {through: car}, {anchor: tail}], length: 116.3 m}]
)";
  const Result r = run_text(text);
  EXPECT_EQ(exit_code(r), 3);
  EXPECT_NE(r.message.find("carriage 'car'"), std::string::npos) << r.message;
  EXPECT_NE(r.message.find("runs to the end at 'head'"), std::string::npos) << r.message;
}

}  // namespace taut::app::machine_carriages_test
