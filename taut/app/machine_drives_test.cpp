#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "taut/app/job.hpp"

// Drives, rope loads and drums from decks.
namespace machine_drives_test {

using namespace taut;

Result run_text(const std::string& text, const std::vector<std::string>& set = {}) {
  return app::run(app::Job{.text = text, .name = "deck.yaml", .set = set});
}

double cell(const Result& r, const std::string& table, const std::string& column, std::size_t row = 0) {
  for (const Table& t : r.tables) {
    for (std::size_t i = 0; t.name == table && i < t.columns.size(); ++i) {
      if (t.columns[i].name == column) return std::get<double>(t.rows.at(row).at(i));
    }
  }
  ADD_FAILURE() << table << '.' << column << ' ' << r.message << to_text(r.errors);
  return std::nan("");
}

const Check* check_named(const Result& r, const std::string& name) {
  const auto at = std::find_if(r.checks.begin(), r.checks.end(), [&](const Check& c) { return c.name == name; });
  return at == r.checks.end() ? nullptr : &*at;
}

constexpr const char* saw = R"(taut: 1
machine:
  ropes: {saw: {mass: 0.8 kg/m, stiffness: 3 MN}}
  bodies: {slide: {at: [8 m, 0 m, 0.3 m], free: [x]}}
  sheaves:
    drive: {at: [0 m, 0 m, 0 m], diameter: 800 mm, friction: 0.3, motor: {speed: 12 m/s}}
    top: {at: [2 m, 0 m, 1.2 m], diameter: 400 mm, efficiency: 0.97}
    idler: {body: slide, at: [0 m, 0 m, 0 m], diameter: 700 mm, efficiency: 0.96}
  reevings: [{rope: saw, path: [{over: drive}, {over: top}, {over: idler}], closed: true, length: 19.6 m}]
  take_up: [{body: slide, screw: 14 kN, along: [1, 0, 0]}]
  rope_loads: [{name: cut, rope: saw, between: [top, idler], tangential: 2 kN}]
analyses: [equilibrium: {motion: in}]
)";

TEST(MachineDrives, ASawsTensionJumpsByTheCut) {
  const Result r = run_text(saw);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_NEAR(cell(r, "rope_loads", "T_out") - cell(r, "rope_loads", "T_in"), 2000, 1e-6);
  EXPECT_NEAR(cell(r, "rope_loads", "F"), -2000, 1e-6);
  EXPECT_NEAR(cell(r, "drives", "centrifugal"), 0.8 * 144, 1e-9);
  EXPECT_NEAR(cell(r, "drives", "torque"), 0.4 * (cell(r, "drives", "T_in") - cell(r, "drives", "T_out")), 1e-9);
  EXPECT_NEAR(cell(r, "drives", "slip_arc") + cell(r, "drives", "rest_arc"), cell(r, "drives", "wrap"), 1e-9);
  EXPECT_NEAR(r.find_value("drive.power")->value, cell(r, "drives", "power"), 0);
  const Check* grip = check_named(r, "drive.grip");
  ASSERT_NE(grip, nullptr);
  EXPECT_NEAR(grip->limit, std::exp(0.3 * cell(r, "drives", "wrap")), 1e-9);
}

TEST(MachineDrives, AWorkingArcIsTheGripThatCounts) {
  const Result r = run_text(saw, {"machine.sheaves.drive.motor.working_arc=90 deg"});
  EXPECT_NEAR(check_named(r, "drive.grip")->limit, std::exp(0.3 * M_PI / 2), 1e-9);
}

TEST(MachineDrives, ATorqueWithNothingLeftToSetIsALimit) {
  const std::vector<std::string> torque = {"machine.sheaves.drive.motor={torque: 900 N m}"};
  const Result r = run_text(saw, torque);
  const Check* limit = check_named(r, "drive.torque");
  ASSERT_NE(limit, nullptr) << r.message << to_text(r.errors);
  EXPECT_EQ(limit->limit, 900);
  EXPECT_FALSE(limit->passes);
  EXPECT_NEAR(limit->value, cell(r, "drives", "torque"), 1e-9);
}

TEST(MachineDrives, ATorqueByASignalIsALimitToo) {
  const std::vector<std::string> torque = {"machine.sheaves.drive.motor={torque: tq}",
                                           "machine.signals={tq: {table: {t: [0 s, 9 s], value: [0 N m, -700 N m]}}}"};
  const Result r = run_text(saw, torque);
  const Check* limit = check_named(r, "drive.torque");
  ASSERT_NE(limit, nullptr) << r.message << to_text(r.errors);
  EXPECT_EQ(limit->limit, 700);
  EXPECT_FALSE(limit->passes);
}

/// The saw with a screw that stays where it was set.
std::string fixed_saw(double screw, const std::string& more = "") {
  std::string text = saw;
  text.replace(text.find("screw: 14 kN"), 12, fmt::format("screw: {} kN, keeps: place", screw));
  return text + more;
}

TEST(MachineDrives, AScrewStaysWhereItWasSet) {
  // set: all tensions are equal, and their pull on the slide is that of the screw
  const Result set =
      run_text(fixed_saw(14), {"machine.rope_loads[0].tangential=0 kN", "analyses=[{equilibrium: {motion: at_rest}}]"});
  ASSERT_EQ(set.status, Status::ok) << set.message << to_text(set.errors);
  EXPECT_NEAR(cell(set, "bodies", "Rx"), 14e3, 1e-3);
  EXPECT_NEAR(cell(set, "drives", "T_in"), cell(set, "drives", "T_out"), 1) << "but for the weight of the rope";
  const double x = set.find_value("slide.x")->value;
  const Result cuts = run_text(fixed_saw(14));
  ASSERT_EQ(cuts.status, Status::ok) << cuts.message << to_text(cuts.errors);
  EXPECT_NEAR(cuts.find_value("slide.x")->value, x, 1e-12);
  EXPECT_TRUE(check_named(cuts, "drive.grip")->passes);
  // the other way round the idler is in the slack part: what the cut takes there a constant pull gives back
  const std::vector<std::string> out = {"analyses[0].equilibrium.motion=out", "machine.take_up[0].screw=4.8 kN"};
  const Result fixed = run_text(fixed_saw(14), out);
  std::vector<std::string> ram = out;
  ram.emplace_back("machine.take_up[0].keeps=force");
  const Result kept = run_text(saw, ram);
  EXPECT_LT(cell(fixed, "drives", "T_out"), cell(kept, "drives", "T_out") - 500);
  EXPECT_FALSE(check_named(fixed, "drive.grip")->passes);
  EXPECT_TRUE(check_named(kept, "drive.grip")->passes);
}

TEST(MachineDrives, AScrewIsNotSetAnewByLoads) {
  const double x = run_text(fixed_saw(14)).find_value("slide.x")->value;
  const Result swept =
      run_text(fixed_saw(14),
               {"analyses=[{sweep: {parameter: 'machine.rope_loads[0].tangential', from: 0 kN, to: 2 kN, steps: 2, "
                "motion: in}}, {equilibrium: {motion: in}}]"});
  ASSERT_EQ(swept.status, Status::ok) << swept.message << to_text(swept.errors);
  EXPECT_NEAR(swept.find_value("slide.x")->value, x, 1e-12);
  const Table* table = swept.find_table("sweep");
  ASSERT_NE(table, nullptr);
  const Result alone = run_text(fixed_saw(14), {"machine.rope_loads[0].tangential=1 kN"});
  for (std::size_t i = 0; i < table->columns.size(); ++i) {
    if (table->columns[i].name != "saw.T_max") continue;
    EXPECT_NEAR(std::get<double>(table->rows.at(1).at(i)), alone.find_value("saw.T_max")->value, 1e-6);
    return;
  }
  ADD_FAILURE() << "no saw.T_max";
}

TEST(MachineDrives, WhatAScrewKeepsHasToBeSaid) {
  const Result open = run_text(saw);
  ASSERT_EQ(open.unmade.size(), 1U);
  EXPECT_NE(open.unmade.front().find("Give its take_up 'keeps: place'"), std::string::npos);
  EXPECT_TRUE(run_text(saw, {"machine.take_up[0].keeps=force"}).unmade.empty());
  EXPECT_TRUE(run_text(fixed_saw(14)).unmade.empty());
  const auto mistake = [](const std::vector<std::string>& set) { return to_text(run_text(saw, set).errors); };
  const std::string place = "machine.take_up[0].keeps=place";
  EXPECT_NE(mistake({place, "machine.bodies.slide.free=[]"}).find("'slide' can't move"), std::string::npos);
  EXPECT_NE(mistake({place, "machine.bodies.slide.free=[x, z]"}).find("'slide' has 2"), std::string::npos);
  EXPECT_NE(mistake({"machine.take_up[0]={body: slide, weight: 1 t, keeps: place}"}).find("belongs to a screw"),
            std::string::npos);
  // a torque says how much rope the loaded machine has, nothing how much the unloaded one
  const Result gone = run_text(fixed_saw(14), {"machine.sheaves.drive.motor={torque: 900 N m}",
                                               "machine.reevings=[{rope: saw, path: [{over: drive}, {over: top}, "
                                               "{over: idler}], closed: true}]"});
  EXPECT_EQ(gone.status, Status::infeasible);
  EXPECT_NE(gone.message.find("'saw' needs its 'length'"), std::string::npos) << gone.message << to_text(gone.errors);
}

TEST(MachineDrives, ATorqueFindsTheForceItOvercomes) {
  const Result known = run_text(saw);
  std::string open = saw;
  open.replace(open.find(", tangential: 2 kN"), 18, "");
  const std::string torque = fmt::format("{{torque: {:.17g} N m}}", cell(known, "drives", "torque"));
  std::string text = open;
  text.replace(text.find("{speed: 12 m/s}"), 15, torque);
  const Result r = run_text(text);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  // without a speed there is no centrifugal tension, which the losses of the sheaves hardly see
  EXPECT_NEAR(cell(r, "rope_loads", "F"), -2000, 20);
  EXPECT_NEAR(cell(r, "drives", "torque"), cell(known, "drives", "torque"), 1e-6);
  EXPECT_NE(to_text(run_text(open).errors).find("needs 'tangential' or 'rate'"), std::string::npos);
}

TEST(MachineDrives, TheMotionTurnsTheCut) {
  const Result there = run_text(saw), back = run_text(saw, {"analyses[0].equilibrium.motion=out"});
  EXPECT_NEAR(cell(there, "rope_loads", "F"), -cell(back, "rope_loads", "F"), 1e-6);
  EXPECT_LT(cell(back, "drives", "torque"), 0);
  EXPECT_GT(cell(back, "drives", "power"), 0);
  EXPECT_NEAR(cell(run_text(saw, {"analyses[0].equilibrium.motion=at_rest"}), "rope_loads", "F"), -2000, 1e-6);
  const Result fixed =
      run_text(saw, {"analyses[0].equilibrium.motion=out", "machine.rope_loads[0].direction=against_path"});
  EXPECT_NEAR(cell(fixed, "rope_loads", "F"), -2000, 1e-6);
}

TEST(MachineDrives, ARopeThatRunsUpIsCalculatedAsItRuns) {
  std::string text = saw;
  text.replace(text.find("{speed: 12 m/s}"), 15, "{speed: run_up}");
  text.replace(text.find("  reevings:"), 0, "  signals: {run_up: {ramp: {to: 12 m/s, duration: 3 s}}}\n");
  EXPECT_NEAR(cell(run_text(text), "drives", "power"), cell(run_text(saw), "drives", "power"), 1e-9);
}

/// With half a turn on each sheave statics and motion mean the same loss of bearings, that of the driven one too.
TEST(MachineDrives, AMotionNeedsThePowerThatStaticsSays) {
  const std::string text = R"(taut: 1
machine:
  ropes: {saw: {mass: 0 kg/m, stiffness: 5 MN}}
  bodies: {slide: {at: [10 m, 0 m, 0 m], free: [x], mass: 50 kg}}
  signals: {up: {ramp: {to: 2 m/s, duration: 1 s, smooth: true}}}
  sheaves:
    drive: {at: [0 m, 0 m, 0 m], diameter: 1 m, inertia: 5 kg m^2, motor: {speed: up}, friction: 0.4, efficiency: 0.9}
    idler: {body: slide, at: [0 m, 0 m, 0 m], diameter: 1 m, efficiency: 0.95}
  reevings: [{rope: saw, path: [{over: drive, side: right}, {over: idler, side: right}], closed: true, length: 23.2 m}]
  take_up: [{body: slide, weight: 2 t, along: [1, 0, 0]}]
  observe: [drive.torque, drive.power]
analyses: [{equilibrium: {motion: in}}, {transient: {duration: 3 s, tolerance: 1e-6}}]
)";
  const Result r = run_text(text);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const double T_in = cell(r, "drives", "T_in"), T_out = cell(r, "drives", "T_out");
  EXPECT_NEAR(T_out, 0.95 * T_in, 1e-6 * T_in);
  EXPECT_NEAR(cell(r, "drives", "torque"), 0.5 * (T_in - T_out + (T_in + T_out) / 19), 1e-6);
  EXPECT_NEAR(cell(r, "drives", "power"), 2 * cell(r, "drives", "torque") / 0.5, 1e-6);
  EXPECT_NEAR(cell(r, "envelope", "end", 0), cell(r, "drives", "torque"), 1e-4 * cell(r, "drives", "torque"));
  EXPECT_NEAR(cell(r, "envelope", "end", 1), cell(r, "drives", "power"), 1e-4 * cell(r, "drives", "power"));
  // 0.5 s of the way for the start, then 2 s: what is not in the slide, the springs and the wheel is lost in bearings
  const auto row = [&](const std::string& form) {
    const Table& t = *r.find_table("energy");
    for (std::size_t i = 0; i < t.rows.size(); ++i) {
      if (std::get<std::string>(t.rows[i][0]) == form) return cell(r, "energy", "at_end", i);
    }
    ADD_FAILURE() << form;
    return std::nan("");
  };
  const double way = 5;
  EXPECT_NEAR(row("bearings of sheaves, brakes, drag"), way * (T_in - T_out + (T_in + T_out) / 19),
              0.01 * 5 * T_in / 19);
  EXPECT_NEAR(row("residual"), 0, 1e-4 * row("supplied by drives"));
}

constexpr const char* capstan = R"(taut: 1
machine:
  points: {tail: [1 m, 0 m, -3 m]}
  ropes: {line: {mass: 0 kg/m, stiffness: 5 MN}}
  bodies: {hook: {mass: 500 kg, at: [-0.3 m, 0 m, -6 m], free: [x, z]}}
  sheaves: {capstan: {at: [0 m, 0 m, 0 m], diameter: 600 mm, friction: 0.3, motor: {speed: 0.4 m/s}}}
  reevings: [{rope: line, path: [{anchor: hook}, {over: capstan}, {anchor: tail}], length: 11 m, tension_at_end: 2500 N}]
analyses: [equilibrium: {motion: in}]
)";

TEST(MachineDrives, ACapstanHoistsTowardsTheEndThatIsHeld) {
  const Result r = run_text(capstan);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_NEAR(cell(r, "drives", "T_in"), 500 * 9.80665, 1e-3);
  EXPECT_NEAR(cell(r, "drives", "T_out"), 2500, 1e-6);
  EXPECT_NEAR(cell(r, "drives", "power"), (500 * 9.80665 - 2500) * 0.4, 1e-3);
  std::string by_torque = capstan;
  by_torque.replace(by_torque.find("speed: 0.4 m/s"), 14, "torque: 750 N m");
  EXPECT_NE(to_text(run_text(by_torque).errors).find("has length and tension_at_end"), std::string::npos);
  by_torque.replace(by_torque.find(", tension_at_end: 2500 N"), 24, "");
  const Result driven = run_text(by_torque);
  EXPECT_NEAR(cell(driven, "drives", "T_out"), 500 * 9.80665 - 750 / 0.3, 1e-3);
}

constexpr const char* winch = R"(taut: 1
machine:
  ropes: {line: {mass: 0.9 kg/m, stiffness: 10 MN, diameter: 16 mm}}
  bodies: {hook: {mass: 2 t, at: [0 m, 0 m, -30 m], free: [x, z]}}
  drums:
    winch: {at: [0 m, 0 m, 0 m], core_diameter: 300 mm, layers: auto, length_on_drum: 60 m, face_width: 400 mm,
            flange_diameter: 500 mm, drive: {speed: 0.5 m/s}}
  reevings: [{rope: line, path: [{drum: winch}, {anchor: hook}], length: 30 m}]
analyses: [equilibrium: {motion: hoist}]
)";

TEST(MachineDrives, ADrumSaysItsLayerTorqueAndPower) {
  const Result r = run_text(winch);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const double T = 2000 * 9.80665 + 0.9 * 9.80665 * 30;
  EXPECT_EQ(cell(r, "drums", "layer"), 3);
  EXPECT_NEAR(cell(r, "drums", "radius"), 0.19, 1e-12);
  EXPECT_NEAR(cell(r, "drums", "pull"), T, 1e-3 * T);
  EXPECT_NEAR(cell(r, "drums", "torque"), 0.19 * cell(r, "drums", "pull"), 1e-9);
  EXPECT_NEAR(cell(r, "drums", "power"), 0.5 * cell(r, "drums", "pull"), 1e-9);
  // six layers within the flanges: (500 - 300)/2 mm of 16 mm ropes
  EXPECT_NEAR(cell(r, "drums", "pull_last_layer"), cell(r, "drums", "torque") / (0.15 + 5.5 * 0.016), 1e-9);
  EXPECT_TRUE(check_named(r, "winch.capacity")->passes);
  const double lowering = cell(run_text(winch, {"analyses[0].equilibrium.motion=lower"}), "drums", "power");
  EXPECT_NEAR(lowering, -cell(r, "drums", "power"), 1e-6);
}

TEST(MachineDrives, TooMuchRopeForADrumIsTold) {
  const Result r = run_text(winch, {"machine.drums.winch.length_on_drum=200 m"});
  ASSERT_NE(check_named(r, "winch.capacity"), nullptr);
  EXPECT_FALSE(check_named(r, "winch.capacity")->passes);
  EXPECT_EQ(exit_code(r), 4);
}

TEST(MachineDrives, ALoadPathWindsTheMainlineOnItsDrum) {
  const char* deck = R"(taut: 1
machine:
  points: {head: [0 m, 0 m, 18 m], tail: [250 m, 0 m, 60 m]}
  ropes:
    skyline: {mass: 1.7 kg/m, stiffness: 26 MN}
    mainline: {mass: 0.54 kg/m, stiffness: 5 MN, diameter: 12 mm}
  drums:
    winch: {at: [254 m, 0 m, 58 m], core_diameter: 260 mm, layers: auto, length_on_drum: 30 m, face_width: 240 mm, flange_diameter: 600 mm}
  carriages: {car: {mass: 1 t, rides: skyline, mainline: mainline}}
  reevings:
    - {rope: skyline, path: [{anchor: tail}, {through: car}, {anchor: head}], length: 262 m}
    - {rope: mainline, path: [{drum: winch}, {anchor: car}], length: 80 m}
analyses: [load_path: {carriage: car, from: 120 m, to: 220 m, steps: 4}]
)";
  const Result r = run_text(deck);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  double before = -HUGE_VAL;
  for (std::size_t i = 0; i < 5; ++i) {
    const double length = cell(r, "load_path", "winch.length", i), layer = cell(r, "load_path", "winch.layer", i);
    EXPECT_GT(length, before) << "what is hauled in lies on the drum";
    before = length;
    if (length < 0) continue;
    const double radius = 0.13 + (layer - 0.5) * 0.012;
    EXPECT_NEAR(cell(r, "load_path", "winch.torque", i), radius * cell(r, "load_path", "mainline.T_winch", i), 1e-6);
  }
  EXPECT_GT(cell(r, "load_path", "winch.layer", 4), cell(r, "load_path", "winch.layer", 1));
  const Check* left = check_named(r, "winch.length_on_drum");
  ASSERT_NE(left, nullptr) << "110 m of rope do not reach so far";
  EXPECT_FALSE(left->passes);
  // the same mainline drawn by the tension that it has as described
  std::string pulled = deck;
  const std::string length = "{drum: winch}, {anchor: car}], length: 80 m";
  pulled.replace(pulled.find(length), length.size(), "{drum: winch}, {anchor: car}]");
  pulled.replace(pulled.find("flange_diameter: 600 mm"), 23, "flange_diameter: 600 mm, drive: {pull: 5 kN}");
  const std::string at_rest = "analyses: [equilibrium: {}, load_path";
  pulled.replace(pulled.find("analyses: [load_path"), 20, at_rest);
  const Result fed = run_text(pulled);
  ASSERT_EQ(fed.status, Status::ok) << fed.message << to_text(fed.errors);
  const double described = cell(fed, "ropes", "unstretched", 1);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(cell(fed, "load_path", "winch.length", i),
                30 + described - cell(fed, "load_path", "mainline.unstretched", i), 1e-6);
  }
}

TEST(MachineDrives, ALineThatIsPutUpLeavesItsRestOnTheDrum) {
  const char* deck = R"(taut: 1
machine:
  points: {tail: [0 m, 0 m, 60 m], head: [300 m, 0 m, 18 m]}
  ropes: {skyline: {mass: 1.7 kg/m, stiffness: 26 MN, diameter: 20 mm}}
  drums:
    winch: {at: [304 m, 0 m, 2 m], core_diameter: 400 mm, layers: auto, length_on_drum: 150 m, face_width: 400 mm, flange_diameter: 900 mm}
  sheaves: {tower: {at: [300 m, 0 m, 18 m], diameter: 400 mm}}
  reevings:
    - {rope: skyline, path: [{anchor: tail}, {over: tower}, {drum: winch}], install: {tension: 40 kN, at: start}}
analyses: [equilibrium: {}]
)";
  const Result r = run_text(deck);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_NEAR(cell(r, "drums", "length"), 150, 1e-6);
}

TEST(MachineDrives, WholeTurnsOnACapstanGripAsTheirAngleSays) {
  const auto end_tension = [](const std::string& element) {
    const Result r = run_text(R"(taut: 1
machine:
  points: {hand: [6 m, 0 m, 0 m]}
  ropes: {line: {mass: 0 kg/m, stiffness: 10 MN, diameter: 16 mm}}
  bodies: {load: {mass: 2 t, at: [-0.2 m, 0 m, -8 m], free: [z]}}
  supports: {bollard: {at: [0 m, 0 m, 0 m], diameter: 400 mm, friction: 0.2}}
  reevings: [{rope: line, path: [{anchor: load}, )" +
                              element +
                              R"(, {anchor: hand}], length: 18 m}]
analyses: [equilibrium: {motion: out}]
)");
    EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    return std::pair{cell(r, "spans", "T_from", 1), cell(r, "sheaves", "wrap")};
  };
  const auto [once, wrap] = end_tension("{over: bollard}");
  EXPECT_NEAR(once, 2000 * 9.80665 * std::exp(0.2 * wrap), 1e-6 * once);
  for (const int turns : {1, 3}) {
    const auto [T, angle] = end_tension(fmt::format("{{over: bollard, turns: {}}}", turns));
    EXPECT_NEAR(angle, wrap + 2 * M_PI * turns, 0.02) << "the load hangs a little elsewhere";
    EXPECT_NEAR(T, 2000 * 9.80665 * std::exp(0.2 * angle), 1e-6 * T);
  }
}

// The load is a point of its rope, not a body that could leave it: the upper strand of this loop, whose sag takes it
// off its rounds, had no answer ("body 'cut' moves away along x"). T = EA (71.4 m / l - 1) without weight and load.
TEST(MachineDrives, ALoadStandsOnEitherStrandOfALoop) {
  const auto loop = [](const char* between, double position) {
    return run_text(fmt::format(R"(taut: 1
machine:
  ropes: {{r: {{mass: 1 kg/m, stiffness: 50 MN, breaking_force: 200 kN}}}}
  sheaves:
    a: {{at: [0 m, 0 m, 10 m], diameter: 10 m, friction: 0.3, motor: {{}}}}
    b: {{at: [20 m, 0 m, 10 m], diameter: 10 m, friction: 0.3}}
  reevings: [{{name: loop, rope: r, path: [{{over: a}}, {{over: b}}], closed: true, length: 71.40 m}}]
  rope_loads: [{{name: cut, rope: loop, between: {}, tangential: 0.5 kN, position: {}}}]
analyses: [{{equilibrium: {{}}}}]
)",
                                between, position));
  };
  const double middle = 50e6 * ((40 + 10 * std::numbers::pi) / 71.4 - 1);
  for (const char* between : {"[a, b]", "[b, a]"}) {
    for (const double position : {0.1, 0.5, 0.9}) {
      const Result r = loop(between, position);
      ASSERT_EQ(r.status, Status::ok) << between << position << r.message << to_text(r.errors);
      EXPECT_NEAR(r.find_value("loop.T_max")->value, middle, 0.1 * middle) << between << position;
    }
  }
}

}  // namespace machine_drives_test
