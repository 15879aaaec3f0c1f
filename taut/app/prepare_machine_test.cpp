#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "taut/app/job.hpp"
#include "taut/results/machine_run.hpp"
#include "test/paths.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::app::machine_run_test {

namespace fs = std::filesystem;

using taut_test::run_text;
using taut_test::value_of;

double cell(const Table& t, std::size_t row, const std::string& column) {
  for (std::size_t i = 0; i < t.columns.size(); ++i) {
    if (t.columns[i].name == column) return std::get<double>(t.rows.at(row).at(i));
  }
  ADD_FAILURE() << t.name << " has no column " << column;
  return std::nan("");
}

std::string tackle(double efficiency, const std::string& motion) {
  return fmt::format(R"(taut: 1
machine:
  points: {{pin: [0 m, 0 m, 10 m], lead: [-40 m, 0 m, 10 m]}}
  ropes: {{line: {{mass: 0 kg/m, stiffness: 1000 MN}}}}
  bodies: {{hook: {{at: [0 m, 0 m, 2 m], free: [x, z]}}}}
  sheaves:
    head: {{at: [0 m, 0 m, 10 m], efficiency: {0}}}
    block: {{body: hook, at: [0 m, 0 m, 0 m], efficiency: {0}}}
  reevings:
    - {{rope: line, path: [{{anchor: lead}}, {{over: head, parts: 6, between: [head, block]}}, {{anchor: pin}}], length: 90 m}}
  loads: [{{at: hook, force: [0 N, 0 N, -60 kN]}}]
analyses:
  - equilibrium: {{motion: {1}}}
)",
                     efficiency, motion);
}

TEST(MachineRun, TheLeadLineOfATackleFollowsTheTextbook) {
  // S = Q K^n (K - 1)/(K^n - 1), where the rope leaves over a sixth sheave; lowering: K -> 1/K
  for (const double eta : {0.9, 0.97}) {
    for (const bool hoists : {true, false}) {
      const Result r = run_text(tackle(eta, hoists ? "hoist" : "lower"));
      ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
      const double K = hoists ? 1 / eta : eta;
      const double S = 60e3 * std::pow(K, 6) * (K - 1) / (std::pow(K, 6) - 1);
      EXPECT_NEAR(value_of(r, "line.T_start") / S, 1, 1e-9);
    }
  }
  EXPECT_NEAR(value_of(run_text(tackle(1, "hoist")), "line.T_start"), 10e3, 1e-4);
}

TEST(MachineRun, UnitsAndOrderDoNotCount) {
  const std::string text = tackle(0.95, "hoist");
  const Result a = run_text(text);
  const Result b = run_text(text, {"machine.reevings[0].length=9000 cm", "machine.points.pin=[0 mm, 0 mm, 1000 cm]"});
  EXPECT_EQ(value_of(a, "line.T_start"), value_of(b, "line.T_start"));
  const Result c = run_text(
      text,
      {"machine.reevings[0].path=[{anchor: pin}, {over: block, parts: 6, between: [head, block]}, {anchor: lead}]",
       "machine.reevings[0].haul=to_end"});
  EXPECT_NEAR(value_of(a, "line.T_start") / value_of(c, "line.T_end"), 1, 1e-9);
}

TEST(MachineRun, ASignForEachSheave) {
  const std::string text = tackle(0.95, "{head: -1, block: 0}");
  const Result r = run_text(text);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const Table* t = r.find_table("sheaves");
  ASSERT_NE(t, nullptr);
  for (std::size_t i = 0; i < t->rows.size(); ++i) {
    const double ratio = cell(*t, i, "T_in") / cell(*t, i, "T_out");
    EXPECT_NEAR(ratio, i % 2 == 0 ? 1 / 0.95 : 1, 1e-9);
  }
}

TEST(MachineRun, ARopeHangsOverWhatTheDeckSays) {
  // a level catenary with its closed answer: L = 100 m, span 80 m, EA = 10 MN, 1 kg/m, g = 9.81
  const Result r = run_text(
      "taut: 1\nmachine:\n  gravity: 9.81 m/s^2\n  points: {a: [0 m, 0 m, 0 m], b: [80 m, 0 m, 0 m]}\n"
      "  ropes: {r: {mass: 1 kg/m, stiffness: 10 MN}}\n"
      "  reevings: [{rope: r, path: [{anchor: a}, {anchor: b}], length: 100 m}]\n");
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const Table* t = r.find_table("spans");
  ASSERT_NE(t, nullptr);
  EXPECT_NEAR(cell(*t, 0, "H"), 331.73013818, 1e-7);
  EXPECT_NEAR(cell(*t, 0, "T_to"), 592.144521698, 1e-7);
  EXPECT_NEAR(cell(*t, 0, "sag"), 26.547034967, 1e-7);
  // the report writes the same answer
  for (const Step& s : r.steps) {
    const std::map<std::string, double> known = {{"T_1", 592.144521698}, {"x", 80}, {"z", 0}};
    const auto at = known.find(s.symbol);
    if (at == known.end()) continue;
    EXPECT_NEAR(s.value, at->second, 1e-7) << s.symbol;
  }
  const Table* anchors = r.find_table("anchors");
  ASSERT_NE(anchors, nullptr);
  EXPECT_NEAR(cell(*anchors, 0, "Fz") + cell(*anchors, 1, "Fz"), -100 * 9.81, 1e-6);
  EXPECT_NEAR(cell(*anchors, 0, "Fx"), 331.73013818, 1e-7) << "the rope pulls its start towards its end";
}

TEST(MachineRun, ALoadPathPassesTheSupports) {
  // mirrored about its support: the same tensions on both sides
  for (const char* hold : {"rolling", "clamped"}) {
    const std::string text = fmt::format(R"(taut: 1
machine:
  points: {{a: [0 m, 0 m, 0 m], b: [200 m, 0 m, 0 m]}}
  ropes: {{r: {{mass: 2 kg/m, stiffness: 20 MN}}}}
  supports: {{jack: {{at: [100 m, 0 m, 10 m], friction: 0}}}}
  carriages: {{car: {{mass: 800 kg, rides: r, hold: {}}}}}
  reevings: [{{rope: r, path: [{{anchor: a}}, {{through: car}}, {{over: jack}}, {{anchor: b}}], length: 203 m}}]
analyses:
  - load_path: {{carriage: car, from: 15 m, to: 185 m, steps: 34, held: true}}
)",
                                         hold);
    const Result r = run_text(text);
    ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    const Table* t = r.find_table("load_path");
    ASSERT_EQ(t->rows.size(), 36U) << "on the support itself there is no span, beside it are two places";
    ASSERT_EQ(r.warnings.size(), 1U);
    EXPECT_NE(r.warnings[0].find("x = 100 m"), std::string::npos);
    const Result at_end = run_text(text, {"analyses[0].load_path.from=0 m", "analyses[0].load_path.steps=4"});
    ASSERT_EQ(at_end.status, Status::ok) << at_end.message << to_text(at_end.errors);
    EXPECT_NE(at_end.warnings[0].find("the carriage is on 'a'"), std::string::npos);
    const Result on = run_text(text, {"analyses=[{equilibrium: {carriage: car, x: 200 m}}]"});
    EXPECT_NE(to_text(on.errors).find("the carriage would be on 'b', in no span"), std::string::npos);
    for (std::size_t i = 0; i < 17; ++i) {
      EXPECT_NEAR(cell(*t, i, "r.T_a") / cell(*t, t->rows.size() - 1 - i, "r.T_b"), 1, 1e-9);
      EXPECT_NEAR(cell(*t, i, "z"), cell(*t, t->rows.size() - 1 - i, "z"), 1e-7);
      EXPECT_NEAR(cell(*t, i, "r.jack.T_in") / cell(*t, t->rows.size() - 1 - i, "r.jack.T_out"), 1, 1e-9);
    }
  }
}

TEST(MachineRun, AnEndlessRopeIsKeptTightByItsTakeUp) {
  const std::string text = R"(taut: 1
machine:
  ropes: {saw: {mass: 0 kg/m, stiffness: 5 MN}}
  bodies: {slide: {at: [10 m, 0 m, 0 m], free: [x]}}
  sheaves:
    drive: {at: [0 m, 0 m, 0 m], diameter: 1 m, motor: {speed: saw_speed}, friction: 0.2}
    idler: {body: slide, at: [0 m, 0 m, 0 m], diameter: 1 m, efficiency: 0.9}
  reevings: [{rope: saw, path: [{over: idler, side: right}, {over: drive, side: right}], closed: true, length: 23 m}]
  take_up: [{body: slide, screw: 20 kN, along: [1, 0, 0]}]
analyses: [{equilibrium: {motion: at_rest}}, {equilibrium: {motion: in}}]
)";
  const Result r = run_text(text);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const Table* t = r.find_table("spans");
  ASSERT_NE(t, nullptr);
  ASSERT_EQ(t->rows.size(), 2U);
  EXPECT_NEAR(cell(*t, 0, "T_from"), 10e3, 1e-5);
  // 23 m of rope, two straight sides and two half circles of 0.5 m, stretched by T/EA
  EXPECT_NEAR(value_of(r, "slide.x"), (23 * (1 + 10e3 / 5e6) - M_PI) / 2, 1e-6);
  const Table* moving = r.find_table("spans_2");
  ASSERT_NE(moving, nullptr);
  EXPECT_NEAR(cell(*moving, 1, "T_from") / cell(*moving, 0, "T_from"), 1 / 0.9, 1e-9) << "over the idler";
  EXPECT_NEAR(cell(*moving, 0, "T_from") + cell(*moving, 1, "T_from"), 20e3, 1e-4);
  ASSERT_EQ(r.checks.size(), 1U);
  EXPECT_NEAR(r.checks[0].value, 1 / 0.9, 1e-9);
  EXPECT_NEAR(r.checks[0].limit, std::exp(0.2 * M_PI), 1e-9);
  EXPECT_NE(run_text(text, {"machine.sheaves.idler.motor={}"}).message.find("give all motors but one a 'torque'"),
            std::string::npos);
  // two grooves of one driven wheel: no torque says how long the rope is
  EXPECT_NE(to_text(run_text(text, {"machine.sheaves.drive.motor={torque: 2 kN m}",
                                    "machine.reevings=[{rope: saw, path: [{over: drive}, {over: idler}, {over: drive}, "
                                    "{over: idler}], closed: true}]"})
                        .errors)
                .find("runs over 'drive' 2 times"),
            std::string::npos);
  // a given torque is met: 2 kN m at the radius of 0.5 m
  const Result helped = run_text(text, {"machine.sheaves.idler.motor={torque: 2 kN m}"});
  ASSERT_EQ(helped.status, Status::ok) << helped.message << to_text(helped.errors);
  EXPECT_NEAR(value_of(helped, "idler.torque"), 2e3, 1e-6);
  EXPECT_NEAR(value_of(helped, "drive.torque"), -2e3, 1e-6);
}

TEST(MachineRun, ChecksTheBreakingForceAndSaysInfeasibleWithAReason) {
  const std::string head = "taut: 1\nmachine:\n  points: {a: [0 m, 0 m, 0 m], b: [80 m, 0 m, 0 m]}\n";
  const std::string path = "  reevings: [{rope: r, path: [{anchor: a}, {anchor: b}], length: ";
  const Result weak =
      run_text(head + "  ropes: {r: {mass: 1 kg/m, stiffness: 10 MN, breaking_force: 500 N}}\n" + path + "100 m}]\n");
  EXPECT_EQ(exit_code(weak), 4);
  EXPECT_NEAR(value_of(weak, "r.safety_factor"), 500 / 592.0, 0.01);
  const Result shorter = run_text(head + "  ropes: {r: {mass: 1 kg/m, stiffness: .inf}}\n" + path + "79 m}]\n");
  EXPECT_EQ(exit_code(shorter), 3);
  EXPECT_NE(shorter.message.find('r'), std::string::npos);
  EXPECT_TRUE(shorter.tables.empty()) << "no number without closure";
}

TEST(MachineRun, GuysKeepTheLengthOfTheirInstallation) {
  const std::string deck = R"(taut: 1
machine:
  ropes: {g: {mass: 1 kg/m, stiffness: 10 MN}}
  bodies: {mast: {at: [0 m, 0 m, 0 m], free: [rx, ry, rz]}}
  points:
    top: {body: mast, at: [0 m, 0 m, 20 m]}
    east: [20 m, 0 m, 0 m]
    west: [-20 m, 0 m, 0 m]
    north: [0 m, 20 m, 0 m]
    south: [0 m, -20 m, 0 m]
    low: {body: mast, at: [0 m, 1 m, 0 m]}
    foot: [0 m, 1 m, -1 m]
  guys:
    e: {rope: g, from: top, to: east, install: {tension: 30 kN, at: top}}
    w: {rope: g, from: top, to: west, install: {tension: 30 kN, at: top}}
    n: {rope: g, from: top, to: north, install: {tension: 30 kN, at: top}}
    s: {rope: g, from: top, to: south, install: {tension: 30 kN, at: top}}
)";
  const std::string fixed = "machine.bodies.mast.free=[rx]";
  const Result still = run_text(deck, {fixed});
  ASSERT_EQ(still.status, Status::ok) << still.message << to_text(still.errors);
  EXPECT_NEAR(value_of(still, "e.T_start"), 30e3, 1e-3);
  const Result pulled = run_text(deck, {fixed, "machine.loads=[{at: top, force: [0 kN, 10 kN, 0 kN]}]"});
  ASSERT_EQ(pulled.status, Status::ok) << pulled.message << to_text(pulled.errors);
  EXPECT_GT(value_of(pulled, "s.T_start"), 31e3);
  EXPECT_LT(value_of(pulled, "n.T_start"), 29e3);
  EXPECT_NEAR(value_of(pulled, "s.unstretched"), value_of(still, "s.unstretched"), 1e-9);
}

TEST(MachineRun, TellsEachMistakeAtItsPlace) {
  const std::string good = tackle(0.95, "hoist");
  const auto replaced = [&](const std::string& from, const std::string& to) {
    const std::string& text = good;
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return fmt::format("{}{}{}", text.substr(0, at), to, at < text.size() ? text.substr(at + from.size()) : "");
  };
  const std::vector<std::pair<std::string, std::string>> rows = {
      {replaced("anchor: pin", "anchor: pim"),
       "deck.yaml:10:100: error: machine.reevings[0].path[2].anchor: there is no point"},
      {replaced("motion: hoist", "name: ../up"), "name: a name of letters, digits, _ and - is expected"},
      {replaced("motion: hoist", "motion: hoits"), "there is no motion 'hoits'; did you mean 'hoist'?"},
      {replaced("motion: hoist", "motion: {had: 1}"),
       "there is no sheave, support or rope of this name; did you mean 'head'?"},
      {replaced("equilibrium: {", "modal: {"), "'modal' is not a field of analyses[0]"},
      {replaced("  ropes:", "  actuators: {ram: {from: pin, to: hook, force: 3 kN}}\n  ropes:"),
       "machine.actuators: are computed in motion alone"},
      {replaced("  ropes:", "  signals: {v: {ramp: {to: 3 m/s}}}\n  ropes:"), "ramp lacks 'duration'"},
      {replaced("  ropes:", "  signals: {v: 3 furlongz}\n  ropes:"), "machine.signals.v"},
      {replaced("  ropes:", "  terrain: {file: none.csv}\n  ropes:"), "'none.csv' can't be read"},
      {replaced("stiffness", "stifness"), "did you mean 'stiffness'?"},
      {replaced("equilibrium: {", "load_path: {carriage: car, from: 0 m, to: 1 m, "), "there is no carriage 'car'"},
      {replaced("analyses:", "method: mast_section\nanalyses:"), "'method' belongs to a published method"},
  };
  for (const auto& [text, expected] : rows) {
    const Result r = run_text(text);
    EXPECT_EQ(exit_code(r), 2) << expected;
    EXPECT_NE(to_text(r.errors).find(expected), std::string::npos) << expected << "\n" << to_text(r.errors);
  }
}

TEST(MachineRun, TheExamplesRunAndClose) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(taut_test::source_dir() / "examples" / "machines")) {
    if (entry.path().extension() != ".yaml") continue;
    SCOPED_TRACE(entry.path().filename().string());
    const auto job = read_job(entry.path().string());
    ASSERT_TRUE(job);
    const Result r = run(*job);
    EXPECT_EQ(exit_code(r), 0) << r.message << to_text(r.errors);
    EXPECT_FALSE(r.figures.empty());
    EXPECT_FALSE(r.steps.empty());
    // the winch of the loop's return rope holds its pull, which the machine has no drum for
    const bool held = entry.path().stem() == "two_section_loop";
    EXPECT_EQ(r.warnings.size(), held ? 1U : 0U) << r.warnings.front();
    for (const Table& t : r.tables) {
      if (t.name.starts_with("closure")) {
        EXPECT_LT(cell(t, 0, "rope_closure"), 1e-7);
      }
      if (t.name != "load_path") continue;
      for (std::size_t i = 0; i < t.rows.size(); ++i) EXPECT_LT(cell(t, i, "closure"), 1e-7);
    }
    ++count;
  }
  EXPECT_EQ(count, 16);
}

/// A spar that is fixed and carries a rope to an anchor: its place is where the sweep has it, not where it was first.
TEST(MachineRun, ASweepOfAFixedBodyMovesIt) {
  const auto at = [](const std::string& place, const std::string& analyses) {
    return taut_test::run_text(R"(taut: 1
machine:
  ropes: {g: {mass: 1 kg/m, stiffness: 20 MN, breaking_force: 900 kN}}
  points: {stump: [-30 m, 0 m, 0 m], top: {body: spar, at: [0 m, 0 m, 20 m]}}
  bodies: {spar: {mass: 100 kg, at: [)" +
                               place + R"(, 0 m, 0 m], free: []}}
  reevings: [{rope: g, path: [{anchor: stump}, {anchor: top}], length: 36.1 m}]
checks: {ropes: {g: {safety_factor: 3}}}
analyses: [)" + analyses + "]\n");
  };
  const Result swept = at("0 m", "{sweep: {parameter: 'bodies.spar.at[0]', from: 0 m, to: 0.4 m, steps: 2}}");
  ASSERT_EQ(swept.status, Status::ok) << swept.message << to_text(swept.errors);
  const double alone = at("0.4 m", "{equilibrium: {motion: at_rest}}").find_value("g.T_max")->value;
  EXPECT_NEAR(swept.find_value("g.T_max")->value, alone, 1e-6 * alone);
}

}  // namespace taut::app::machine_run_test
