#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "test/support/machine_decks.hpp"

/// Which way ropes run that others draw along: tensions by hand, whichever way a path is written.
namespace hauled_sense_test {

using namespace taut_test;
using taut::Result;
using taut::Status;

Result solved(const std::string& text) {
  Result r = run_text(text);
  EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  return r;
}

struct Band {
  double answer = 0, least = 0, most = 0;
};

/// Of a rope beside a node at one of its ends.
Band at_node(const Result& r, const std::string& rope, const std::string& node) {
  const taut::Table& t = table_of(r, "spans");
  for (std::size_t i = 0; i < t.rows.size(); ++i) {
    if (text_cell(t, i, "rope") != rope) continue;
    for (const std::string end : {"from", "to"}) {
      if (text_cell(t, i, end) != node) continue;
      const std::string T = "T_" + end;
      const double answer = cell(t, i, T);
      const bool band =
          std::any_of(t.columns.begin(), t.columns.end(), [&](const auto& c) { return c.name == T + "_max"; });
      return {.answer = answer,
              .least = band ? cell(t, i, T + "_min") : answer,
              .most = band ? cell(t, i, T + "_max") : answer};
    }
  }
  ADD_FAILURE() << rope << " at " << node;
  return {};
}

/// A load on a winch rope, and on a rope to a counterweight over two sheaves.
std::string hoist(bool turned, const std::string& motion) {
  return fmt::format(R"(taut: 1
machine:
  gravity: 10 m/s^2
  ropes: {{wire: {{mass: 0 kg/m, stiffness: 20 MN}}}}
  bodies:
    load: {{mass: 5 t, at: [0 m, 0 m, 5 m], free: [z]}}
    weight: {{mass: 4 t, at: [4 m, 0 m, 5 m], free: [z]}}
  sheaves:
    s1: {{at: [0.3 m, 0 m, 20 m], diameter: 600 mm, efficiency: 0.9}}
    s2: {{at: [3.7 m, 0 m, 20 m], diameter: 600 mm, efficiency: 0.9}}
    head: {{at: [-0.3 m, 0 m, 20 m], diameter: 600 mm, efficiency: 0.9}}
  drums: {{winch: {{at: [-3 m, 0 m, 1 m], core_diameter: 600 mm}}}}
  reevings:
    - {{rope: wire, name: hoist, path: [{{drum: winch}}, {{over: head}}, {{anchor: load}}], length: 34.6 m}}
    - {{rope: wire, name: counter, path: [{}], length: 34.3 m}}
analyses: [{{equilibrium: {{motion: {}}}}}]
)",
                     turned ? "{anchor: weight}, {over: s2}, {over: s1}, {anchor: load}"
                            : "{anchor: load}, {over: s1}, {over: s2}, {anchor: weight}",
                     motion);
}

TEST(HauledSense, ACounterweightRunsAsTheLoadIsHauled) {
  const double eta = 0.9, load = 50e3, weight = 40e3;
  for (const bool turned : {false, true}) {
    const Band up = at_node(solved(hoist(turned, "hoist")), "hoist", "winch");
    EXPECT_NEAR(up.answer, (load - weight * eta * eta) / eta, 1e-3) << turned;
    EXPECT_NEAR(up.most, up.answer, 1e-6) << "one winch says all";
    const Band down = at_node(solved(hoist(turned, "lower")), "hoist", "winch");
    EXPECT_NEAR(down.answer, (load - weight / (eta * eta)) * eta, 1e-3) << turned;
    // at rest the counterweight's rope may hold the other way too; at the winch the motions are the extremes
    const Band rest = at_node(solved(hoist(turned, "at_rest")), "hoist", "winch");
    EXPECT_NEAR(rest.most, up.answer, 1e-3);
    EXPECT_NEAR(rest.least, down.answer, 1e-3);
  }
}

/// A tackle of two parts pulls the end of another: its winch, and its dead end on the floor.
std::string compound(bool turned, const std::string& motion) {
  return fmt::format(R"(taut: 1
machine:
  gravity: 10 m/s^2
  points: {{ceiling: [-0.3 m, 0 m, 12 m], floor: [0.9 m, 0 m, 0 m]}}
  ropes: {{wire: {{mass: 0 kg/m, stiffness: 50 MN}}}}
  bodies:
    hook: {{mass: 1 t, at: [0 m, 0 m, 4 m], free: [x, z]}}
    runner: {{mass: 0 kg, at: [0.6 m, 0 m, 8 m], free: [x, z]}}
  sheaves:
    lead: {{at: [0.3 m, 0 m, 0 m], efficiency: 0.9}}
    hook_sheave: {{body: hook, at: [0 m, 0 m, 0 m], efficiency: 0.9}}
    head: {{at: [0.3 m, 0 m, 12 m], efficiency: 0.9}}
    runner_sheave: {{body: runner, at: [0 m, 0 m, 0 m], efficiency: 0.9}}
  drums: {{winch: {{at: [-5 m, 0 m, 0 m]}}}}
  reevings:
    - {{rope: wire, name: first, path: [{{drum: winch}}, {{over: lead}}, {{over: runner_sheave}}, {{anchor: floor}}],
       length: 21 m}}
    - {{rope: wire, name: second, path: [{}], length: 20 m}}
analyses: [{{equilibrium: {{motion: {}}}}}]
)",
                     turned ? "{anchor: runner}, {over: head}, {over: hook_sheave}, {anchor: ceiling}"
                            : "{anchor: ceiling}, {over: hook_sheave}, {over: head}, {anchor: runner}",
                     motion);
}

TEST(HauledSense, ATackleOnATackle) {
  std::vector<double> pulls;
  for (const bool turned : {false, true}) {
    const Result up = solved(compound(turned, "hoist"));
    const double at_ceiling = at_node(up, "second", "ceiling").answer,
                 at_runner = at_node(up, "second", "runner").answer;
    EXPECT_NEAR(at_ceiling / at_runner, 0.9 * 0.9, 1e-6) << "drawn towards the runner";
    pulls.push_back(at_node(up, "first", "winch").answer);
    // hauled, then let out a little: the second tackle holds its runner up, and the floor bears more than while
    // hoisting
    const Result rest = solved(compound(turned, "at_rest"));
    const double floor = at_node(rest, "first", "floor").most;
    EXPECT_NEAR(floor * 0.9 / at_node(up, "first", "floor").answer, 1, 5e-3) << turned;
    EXPECT_NEAR(at_node(rest, "first", "winch").most / pulls.back(), 1, 1e-6);
  }
  EXPECT_NEAR(pulls[0] / pulls[1], 1, 1e-9);
}

/// A truck on a level track between a winch and one that holds it back with a given pull; a force draws it to the
/// latter.
std::string truck(const std::string& motion) {
  return R"(taut: 1
machine:
  gravity: 10 m/s^2
  ropes: {wire: {mass: 0 kg/m, stiffness: 50 MN, breaking_force: 200 kN}}
  bodies: {truck: {mass: 100 kg, at: [0 m, 0 m, 1 m], guide: [1, 0, 0]}}
  sheaves:
    sa: {at: [-20 m, 0 m, 1.16 m], diameter: 320 mm, efficiency: 0.9}
    sb: {at: [20 m, 0 m, 1.16 m], diameter: 320 mm, efficiency: 0.9}
  drums:
    wa: {at: [-20 m, 0 m, 8 m], core_diameter: 320 mm}
    wb: {at: [20 m, 0 m, 8 m], core_diameter: 320 mm, drive: {pull: 40 kN}}
  reevings:
    - {rope: wire, name: A, path: [{drum: wa}, {over: sa}, {anchor: truck}], length: 26 m}
    - {rope: wire, name: B, path: [{drum: wb}, {over: sb}, {anchor: truck}]}
  loads: [{at: truck, force: [20 kN, 0 N, 0 N]}]
analyses: [{equilibrium: {motion: )" +
         motion + "}}]\n";
}

TEST(HauledSense, WinchesThatPullAgainstEachOtherCountBothWays) {
  const double most = (40e3 / 0.9 + 20e3) / 0.9, least = (40e3 * 0.9 + 20e3) * 0.9;
  EXPECT_NEAR(at_node(solved(truck("{sa: -1, sb: 1}")), "A", "wa").answer, most, 2);
  for (const char* motion : {"hoist", "lower", "at_rest"}) {
    const Result r = solved(truck(motion));
    const Band pull = at_node(r, "A", "wa");
    EXPECT_NEAR(pull.most, most, 2) << motion;
    EXPECT_NEAR(pull.least, least, 2) << motion;
    EXPECT_NEAR(value_of(r, "A.T_max"), most, 2) << motion << ": checks take the worst";
  }
}

/// A load on a block between two winches at the ends of its rope.
TEST(HauledSense, OfARopeWithTwoDrumsEachHaulsItsEnd) {
  const Result r = solved(R"(taut: 1
machine:
  gravity: 10 m/s^2
  ropes: {wire: {mass: 0 kg/m, stiffness: 20 MN}}
  bodies: {load: {mass: 5 t, at: [0 m, 0 m, 2 m], free: [x, z]}}
  sheaves:
    block: {body: load, at: [0 m, 0 m, 0 m], diameter: 0.4 m, efficiency: 0.9}
    s1: {at: [-0.4 m, 0 m, 12 m], diameter: 0.4 m, efficiency: 0.9}
    s2: {at: [0.4 m, 0 m, 12 m], diameter: 0.4 m, efficiency: 0.9}
    s3: {at: [8 m, 0 m, 12 m], diameter: 0.4 m, efficiency: 0.9}
  drums: {d1: {at: [-0.8 m, 0 m, 0 m], core_diameter: 0.4 m}, d2: {at: [8.4 m, 0 m, 0 m], core_diameter: 0.4 m}}
  reevings:
    - {rope: wire, name: r, path: [{drum: d1}, {over: s1}, {over: block}, {over: s2}, {over: s3}, {drum: d2}],
       length: 53 m}
analyses: [{equilibrium: {motion: hoist}}]
)");
  const double larger = 50e3 / 1.9;  // of the two parts at the block
  EXPECT_NEAR(at_node(r, "r", "d1").most / (larger / 0.9), 1, 1e-3);
  EXPECT_NEAR(at_node(r, "r", "d2").most / (larger / 0.81), 1, 1e-3);
}

/// A skyline over two saddles, from its tail to the block of a tackle with a given pull.
std::string tackled(bool turned, const std::string& motion) {
  return fmt::format(R"(taut: 1
machine:
  points: {{tail: [-20 m, 0 m, 0 m], pin: [232 m, 0 m, 2 m]}}
  ropes:
    sky: {{mass: 1.5 kg/m, stiffness: 20 MN, breaking_force: 300 kN}}
    tackle: {{mass: 0 kg/m, stiffness: 8 MN, breaking_force: 60 kN}}
  bodies: {{block: {{mass: 0 kg, at: [222 m, 0 m, 2 m], free: [x, z]}}}}
  supports:
    k1: {{at: [0 m, 0 m, 15 m], diameter: 400 mm, friction: 0.15}}
    k2: {{at: [200 m, 0 m, 15 m], diameter: 400 mm, friction: 0.15}}
  sheaves:
    b: {{body: block, at: [0 m, 0 m, 0 m], diameter: 240 mm, efficiency: 0.95}}
    h: {{at: [232 m, 0 m, 2 m], diameter: 240 mm, efficiency: 0.95}}
  drums: {{winch: {{at: [225 m, 0 m, -4 m], core_diameter: 240 mm, drive: {{pull: 14 kN}}}}}}
  reevings:
    - {{rope: sky, path: [{}], length: 250 m}}
    - {{rope: tackle, path: [{{drum: winch}}, {{over: h, parts: 4, between: [h, b]}}, {{anchor: pin}}]}}
analyses: [{{equilibrium: {{motion: {}}}}}]
)",
                     turned ? "{anchor: block}, {over: k2}, {over: k1}, {anchor: tail}"
                            : "{anchor: tail}, {over: k1}, {over: k2}, {anchor: block}",
                     motion);
}

TEST(HauledSense, AtRestTheOrderOfAPathDoesNotCount) {
  const Band ahead = at_node(solved(tackled(false, "at_rest")), "sky", "tail");
  const Band back = at_node(solved(tackled(true, "at_rest")), "sky", "tail");
  EXPECT_NEAR(ahead.least / back.least, 1, 1e-8);
  EXPECT_NEAR(ahead.most / back.most, 1, 1e-8);
  // the tackle hauls the skyline to its block, over both saddles, or lets it out
  const Band in = at_node(solved(tackled(false, "in")), "sky", "tail");
  const Band out = at_node(solved(tackled(false, "out")), "sky", "tail");
  EXPECT_NEAR(ahead.least / in.answer, 1, 1e-8);
  EXPECT_NEAR(ahead.most / out.answer, 1, 1e-8);
  EXPECT_NEAR(in.answer, 41.7e3, 100);
  EXPECT_NEAR(out.answer, 75.1e3, 100);
}

/// A carriage between its mainline and a rope that pulls it back, which the carriage names as its haulback or not.
TEST(HauledSense, ARopeThatHoldsACarriageBackNeedsNoKey) {
  const auto deck = [](bool named, const std::string& motion) {
    return fmt::format(R"(taut: 1
machine:
  points: {{a: [0 m, 0 m, 20 m], b: [200 m, 0 m, 20 m]}}
  ropes:
    sky: {{mass: 1.5 kg/m, stiffness: 20 MN, breaking_force: 300 kN}}
    wire: {{mass: 0.5 kg/m, stiffness: 20 MN, breaking_force: 120 kN}}
  carriages:
    car: {{mass: 1800 kg, rides: sky, hold: rolling, mainline: main, {}at: [100 m, 0 m, 12 m]}}
  sheaves:
    lm: {{at: [0 m, 0 m, 19 m], diameter: 300 mm, efficiency: 0.9}}
    lh: {{at: [200 m, 0 m, 19 m], diameter: 300 mm, efficiency: 0.9}}
  drums:
    wm: {{at: [-5 m, 0 m, 1 m], core_diameter: 300 mm}}
    wh: {{at: [205 m, 0 m, 1 m], core_diameter: 300 mm, drive: {{pull: 25 kN}}}}
  reevings:
    - {{rope: sky, path: [{{anchor: a}}, {{through: car}}, {{anchor: b}}], length: 201.5 m}}
    - {{rope: wire, name: main, path: [{{drum: wm}}, {{over: lm}}, {{anchor: car}}], length: 110 m}}
    - {{rope: wire, name: back, path: [{{drum: wh}}, {{over: lh}}, {{anchor: car}}]}}
analyses: [{{equilibrium: {{carriage: car, x: 80 m, motion: {}}}}}]
)",
                       named ? "haulback: back, " : "", motion);
  };
  for (const char* motion : {"in", "out", "at_rest"}) {
    const Band with = at_node(solved(deck(true, motion)), "main", "wm");
    const Band without = at_node(solved(deck(false, motion)), "main", "wm");
    EXPECT_NEAR(without.answer / with.answer, 1, 1e-8) << motion;
    EXPECT_NEAR(without.most / with.most, 1, 1e-8) << motion;
    EXPECT_NEAR(without.least / with.least, 1, 1e-8) << motion;
  }
}

}  // namespace hauled_sense_test
