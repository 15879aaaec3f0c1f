#include "taut/checks/rope/rope_life.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "test/support/machine_decks.hpp"

namespace taut::checks::rope_life_test {

using taut_test::cell;
using taut_test::expect_mistake;
using taut_test::run_text;
using taut_test::table_of;
using taut_test::value_of;
using testing::HasSubstr;

/// A rope over one sheave from a drum to a load, and what is checked of it.
std::string lift(const std::string& checks) {
  return R"(taut: 1
machine:
  ropes: {hoist: {rope: "EN 12385-4|6x36-IWRC|16|1770", stiffness: 12 MN}}
  bodies: {load: {mass: 3 t, at: [0.2 m, 0 m, 5 m], free: [x, z]}}
  sheaves: {head: {at: [0 m, 0 m, 20 m], diameter: 400 mm}}
  drums: {winch: {at: [-8 m, 0 m, 2 m], core_diameter: 384 mm}}
  reevings: [{rope: hoist, path: [{drum: winch}, {over: head}, {anchor: load}], length: 36 m}]
analyses: [equilibrium: {motion: hoist}]
checks: {ropes: {hoist: )" +
         checks + "}}\n";
}

TEST(RopeLife, ASheaveOfNoKnownDiameterIsNotLeftOutInSilence) {
  std::string deck = lift("{duty: [{name: lifts, cycles: 20000}]}");
  const std::string diameter = ", diameter: 400 mm";
  deck.erase(deck.find(diameter), diameter.size());
  const Result r = run_text(deck);
  EXPECT_THAT(r.unmade, testing::ElementsAre(HasSubstr("hoist: its life leaves out the bends over 'head'")));
  EXPECT_TRUE(run_text(lift("{duty: [{name: lifts, cycles: 20000}]}")).unmade.empty());
}

// One bending at the sheave and half of one at the drum, both with D/d = 25 and nearly the same pull; f_C = 0.81.
TEST(RopeLife, by_hand) {
  const Result r = run_text(lift("{duty: [{name: lifts, cycles: 20000}]}"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const Table& t = table_of(r, "life_hoist");
  ASSERT_EQ(t.rows.size(), 2U);
  const auto sheave = taut_test::row_of(t, "bent_on", "head");
  const double S = cell(t, sheave, "pull");
  EXPECT_NEAR(S, value_of(r, "hoist.T_max"), 1e-6 * S);
  EXPECT_NEAR(cell(t, sheave, "D_over_d"), 25, 1e-12);
  const double lg =
      1.278 + (0.029 - 1.613 * std::log10(25)) * std::log10(S / 256) + 6.241 * std::log10(25) + std::log10(0.81);
  EXPECT_NEAR(std::log10(cell(t, sheave, "N")), lg, 1e-9);
  EXPECT_EQ(cell(t, sheave, "n"), 20000);
  EXPECT_EQ(cell(t, taut_test::row_of(t, "bent_on", "winch"), "n"), 10000);
  double damage = 0;
  for (std::size_t i = 0; i < t.rows.size(); ++i) damage += cell(t, i, "damage");
  EXPECT_NEAR(value_of(r, "hoist.life_damage"), damage, 1e-12);
  EXPECT_NEAR(value_of(r, "hoist.life_repeats"), 1 / damage, 1e-9);
  const auto life =
      std::find_if(r.checks.begin(), r.checks.end(), [](const Check& c) { return c.name == "hoist.life"; });
  ASSERT_NE(life, r.checks.end());
  EXPECT_THAT(life->trust, HasSubstr("UNVERIFIED"));
}

TEST(RopeLife, own_constants_and_the_worst_count) {
  const Result r =
      run_text(lift("{duty: [{name: lifts, cycles: 20000, over: [head]}], life: {core_factor: 1, constants: [{count: "
                    "discard, a: [5, 0, 0, "
                    "0]}, {count: mean_break, a: [6, 0, 0, 0]}]}}"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_NEAR(value_of(r, "hoist.life_damage"), 0.2, 1e-9);
  EXPECT_EQ(table_of(r, "life_hoist").rows.size(), 2U);
}

// At 2.5858 d the formula of the bent length has nearly its pole; a length below it is no number.
TEST(RopeLife, a_short_bent_length_counts_as_that_of_the_tests) {
  const auto damage = [](const std::string& life) {
    return value_of(run_text(lift("{duty: [{name: lifts, cycles: 2e6}]" + life + "}")), "hoist.life_damage");
  };
  const double tested = damage("");
  EXPECT_GT(tested, 1);
  for (const char* length : {"1 mm", "41.37 mm", "80 mm", "960 mm"}) {
    EXPECT_NEAR(damage(fmt::format(", life: {{bent_length: {}}}", length)), tested, 1e-9 * tested) << length;
  }
  EXPECT_GT(damage(", life: {bent_length: 20 m}"), tested);
}

// 10^400 and 10^-400 bendings: neither "passes" nor "fails" can rest on them.
TEST(RopeLife, no_finite_number_of_bendings_is_not_judged) {
  for (const char* a0 : {"400", "-400"}) {
    const Result r = run_text(lift(fmt::format(
        "{{duty: [{{name: lifts, cycles: 2e4}}], life: {{constants: [{{count: discard, a: [{}, 0, 0, 0]}}]}}}}", a0)));
    EXPECT_THAT(r.unmade, testing::ElementsAre(HasSubstr("the constants of 'discard' give no finite number"))) << a0;
    EXPECT_TRUE(std::none_of(r.checks.begin(), r.checks.end(), [](const Check& c) { return c.name == "hoist.life"; }));
  }
}

// The constants are the deck's own; that a bending in reverse counts twice is recalled.
TEST(RopeLife, what_is_recalled_besides_the_constants) {
  const std::string own = "{duty: [{name: lifts, cycles: 2e4}], life: {constants: [{count: discard, a: [5, 0, 0, 0]}]";
  const auto trust = [](const std::string& checks, const char* side) {
    const Result r = run_text(lift(checks), {fmt::format("machine.reevings[0].path[1].side={}", side)});
    return taut_test::check_of(r, "hoist.life").trust;
  };
  const std::string right = trust(own + "}}", "right");
  const std::string left = trust(own + "}}", "left");
  EXPECT_NE(right.starts_with("UNVERIFIED"), left.starts_with("UNVERIFIED"));  // one of them turns against the drum
  EXPECT_EQ(trust(own + ", reverse_weight: 2}}", "left"), "user");
  EXPECT_EQ(trust(own + ", reverse_weight: 2}}", "right"), "user");
  EXPECT_THAT(trust(own + ", reverse_weight: 2}, hoist: {class: HC2, speed: 1 m/s}}", "left"), HasSubstr("UNVERIFIED"));
}

/// A block of 1 t that hangs on the rope between two sheaves; begun at a height.
Result hung_between(const std::string& z, const std::string& analysis, bool reversed = false) {
  const std::string along = "[{anchor: a}, {over: s1}, {over: s2}, {over: s3}, {anchor: e}]",
                    back = "[{anchor: e}, {over: s3}, {over: s2}, {over: s1}, {anchor: a}]";
  return run_text(fmt::format(R"(taut: 1
machine:
  ropes: {{r: {{rope: "EN 12385-4|6x36-IWRC|16|1960", stiffness: 13 MN, damping_ratio: 0.1}}}}
  bodies: {{b: {{at: [3 m, 0 m, {}], free: [x, z], mass: 1000 kg}}}}
  sheaves:
    s1: {{at: [0 m, 0 m, 5 m], diameter: 400 mm}}
    s2: {{body: b, at: [0 m, 0 m, 0 m], diameter: 400 mm}}
    s3: {{at: [6 m, 0 m, 5 m], diameter: 300 mm}}
  points: {{a: [-1 m, 0 m, 0 m], e: [7 m, 0 m, 0 m]}}
  reevings: [{{rope: r, path: {}, length: 18 m}}]
analyses: [{}]
checks: {{ropes: {{r: {{duty: [{{name: d, cycles: 1e5}}], life: {{reverse_weight: 3, constants: [{{count: mean_break, a: [1.278, 0.029, 6.241, -1.613]}}]}}}}}}}}
)",
                              z, reversed ? back : along, analysis));
}

// Two reverse bends, whatever the first guess of the block's place and the direction of the path.
TEST(RopeLife, reverse_bends_are_those_of_the_states_found) {
  for (const char* analysis : {"equilibrium: {}", "transient: {duration: 0.1 s}"}) {
    const double damage = value_of(hung_between("3 m", analysis), "r.life_damage");
    EXPECT_NEAR(value_of(hung_between("6 m", analysis), "r.life_damage"), damage, 1e-3 * damage) << analysis;
    EXPECT_NEAR(value_of(hung_between("3 m", analysis, true), "r.life_damage"), damage, 1e-3 * damage) << analysis;
    const Table t = table_of(hung_between("6 m", analysis), "life_r");
    EXPECT_NEAR(cell(t, 0, "n") + cell(t, 1, "n") + cell(t, 2, "n"), 7e5, 1);  // 1 + 3 + 3
  }
}

/// A jib with a sheave and a drum that turn with it, and a load that hangs from it. `jib`: what moves it.
std::string slewing(const std::string& jib, const std::string& analysis) {
  return R"(taut: 1
machine:
  signals: {slew: {ramp: {to: 180 deg, start: 0.2 s, duration: 6 s, smooth: true}}}
  ropes: {h: {diameter: 16 mm, mass: 0.01 kg/m, stiffness: 13 MN, breaking_force: 161 kN, damping_ratio: 0.1}}
  bodies:
    jib: {at: [0 m, 0 m, 20 m])" +
         jib + R"(}
    load: {mass: 2000 kg, at: [1.2 m, 0 m, 15 m], free: [x, y, z]}
  sheaves: {head: {body: jib, at: [1 m, 0 m, 0 m], diameter: 400 mm, efficiency: 1}}
  drums: {winch: {body: jib, at: [0 m, 0 m, 1 m], core_diameter: 320 mm}}
  reevings: [{rope: h, path: [{drum: winch, side: right}, {over: head, side: right}, {anchor: load}], length: 6.5 m}]
analyses: [)" +
         analysis + R"(]
checks: {ropes: {h: {grade: 1770 MPa, running: stands, duty: [{name: a, cycles: 1e5}], life: {core_factor: 0.8,
  reverse_weight: 3}}}}
)";
}

// The jib turns by half a turn, and its sheave and drum with it: seen from the jib the rope bends as it did. It is not
// bent back, though its plane has turned against the ground's axes.
TEST(RopeLife, ASheaveThatSlewsWithItsJibBendsTheRopeOneWay) {
  const Result rest = run_text(slewing("", "equilibrium: {}"));
  const Result turned = run_text(slewing(", motion: {rz: slew}", "transient: {duration: 7 s, output_step: 0.25 s}"));
  for (const Result* r : {&rest, &turned}) {
    ASSERT_EQ(r->status, Status::ok) << r->message << to_text(r->errors);
    const Table& t = table_of(*r, "life_h");
    EXPECT_EQ(cell(t, taut_test::row_of(t, "bent_on", "head"), "n"), 100000);
    EXPECT_EQ(cell(t, taut_test::row_of(t, "bent_on", "winch"), "n"), 50000);
  }
}

// A rope from a drum round a tail sheave and back to the same drum. Every zone passes every round, as the page on rope
// life assumes: the sheave bends it once and the drum twice half, at the one end and at the other.
TEST(RopeLife, ADrumWithBothEndsOfARopeBendsItTwice) {
  const auto deck = [](const std::string& second) {
    return R"(taut: 1
machine:
  ropes: {h: {diameter: 16 mm, mass: 0.01 kg/m, stiffness: 13 MN, breaking_force: 161 kN}}
  bodies: {slide: {mass: 200 kg, at: [10 m, 0 m, 0 m], free: [z]}}
  sheaves: {tail: {body: slide, at: [0 m, 0 m, 0 m], diameter: 400 mm, efficiency: 0.98}}
  drums: {winch: {at: [10 m, 0 m, 8 m], core_diameter: 400 mm}, other: {at: [10 m, 0 m, 8 m], core_diameter: 400 mm}}
  reevings:
    - {rope: h, path: [{drum: winch, side: left}, {over: tail, side: left}, {drum: )" +
           second + R"(, side: left}], length: 16.5 m}
analyses: [equilibrium: {motion: at_rest}]
checks: {ropes: {h: {grade: 1770 MPa, duty: [{name: a, cycles: 1e5}], life: {core_factor: 0.8}}}}
)";
  };
  const Result one = run_text(deck("winch")), two = run_text(deck("other"));
  ASSERT_EQ(one.status, Status::ok) << one.message << to_text(one.errors);
  const Table& t = table_of(one, "life_h");
  double drums = 0;
  for (std::size_t i = 0; i < t.rows.size(); ++i) {
    if (std::get<std::string>(t.rows[i][2]) == "winch") drums += cell(t, i, "n");
  }
  EXPECT_EQ(drums, 100000) << "half of 100000 at each end";
  const double damage = value_of(two, "h.life_damage");
  EXPECT_NEAR(value_of(one, "h.life_damage"), damage, 1e-12 * damage) << "as on two drums in the same place";
}

TEST(RopeLife, donandt_and_discard) {
  const Result r = run_text(lift("{life: {donandt_force: 20 kN}, discard: true}"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_EQ(exit_code(r), 4);  // 29.4 kN
  const Table& t = table_of(r, "discard_hoist");
  EXPECT_EQ(t.rows.size(), 10U);
}

// 29.4 kN at the sheave. A duty pulls with its share of that, a smaller one does not lessen what the states have.
TEST(RopeLife, the_donandt_force_holds_for_every_duty) {
  const auto donandt = [](const std::string& duty, const std::string& more = "") {
    const Result r = run_text(
        lift(fmt::format("{{duty: [{{name: lifts, cycles: 1{}}}], life: {{donandt_force: 40 kN}}{}}}", duty, more)));
    return taut_test::check_of(r, "hoist.donandt");
  };
  const Check plain = donandt("");
  EXPECT_TRUE(plain.passes);
  EXPECT_EQ(plain.trust, "user");
  EXPECT_NEAR(donandt(", load: 0.5").value, plain.value, 1e-9 * plain.value);
  const Check more = donandt(", load: 1.5");
  EXPECT_NEAR(more.value, 1.5 * plain.value, 1e-9 * plain.value);
  EXPECT_FALSE(more.passes);
  EXPECT_THAT(more.rule, HasSubstr("in the duty 'lifts'"));
  const double at_drum = donandt(", load: 1.5, over: [winch]").value;
  EXPECT_NEAR(at_drum, 1.5 * plain.value, 0.01 * plain.value);  // the rope weighs 0.2 kN on its way down
  EXPECT_LT(at_drum, more.value);
}

// The pull has a recalled factor in it; of the deck's own factor the deck answers.
TEST(RopeLife, the_donandt_force_is_as_doubtful_as_the_dynamic_factor) {
  const auto donandt = [](const std::string& more) {
    return taut_test::check_of(run_text(lift("{life: {donandt_force: 90 kN}" + more + "}")), "hoist.donandt").trust;
  };
  EXPECT_THAT(donandt(", hoist: {class: HC2, speed: 0.5 m/s}"), HasSubstr("UNVERIFIED"));
  EXPECT_EQ(donandt(", dynamic_factor: 1.4"), "user");
}

TEST(RopeLife, a_donandt_force_over_a_sheave_of_no_known_diameter_is_not_judged) {
  std::string deck = lift("{life: {donandt_force: 90 kN}}");
  EXPECT_TRUE(run_text(deck).unmade.empty());
  const std::string diameter = ", diameter: 400 mm";
  deck.erase(deck.find(diameter), diameter.size());
  EXPECT_THAT(run_text(deck).unmade,
              testing::ElementsAre(HasSubstr("its Donandt force is not checked: no diameter is known of 'head'")));
}

TEST(RopeLife, mistakes) {
  expect_mistake(run_text(lift("{duty: [{name: lifts, cycles: 20000, over: [haed]}]}")), "did you mean 'head'");
  expect_mistake(run_text(lift("{life: {constants: [{count: discard, a: [1, 2]}]}}")), "four constants");
  expect_mistake(run_text(lift("{duty: [{name: lifts}]}")), "cycles");
}

// A life that leaves a sheave out is not the rope's life; a duty over another rope's sheave is a mistake.
TEST(RopeLife, every_sheave_of_the_duty_counts) {
  const auto deck = [](const std::string& over, const std::string& duty) {
    return R"(taut: 1
machine:
  ropes: {hoist: {rope: "EN 12385-4|6x36-IWRC|16|1770", stiffness: 12 MN}}
  points: {p: [0 m, 9 m, 2 m], q: [0.4 m, 9 m, 2 m]}
  bodies: {load: {mass: 3 t, at: [0.2 m, 0 m, 5 m], free: [x, z]}}
  sheaves:
    head: {at: [0 m, 0 m, 20 m], diameter: 400 mm}
    side: {at: [-4 m, 0 m, 20 m]}
    lone: {at: [0 m, 9 m, 20 m], diameter: 400 mm}
  drums: {winch: {at: [-8 m, 0 m, 2 m], core_diameter: 384 mm}}
  reevings:
    - {name: first, rope: hoist, path: [{drum: winch}, )" +
           over + R"({over: head}, {anchor: load}], length: 39 m}
    - {name: other, rope: hoist, path: [{anchor: p}, {over: lone}, {anchor: q}], tension_at_start: 9 kN}
checks: {ropes: {first: {safety_factor: 2, duty: [{name: lifts, cycles: 20000)" +
           duty + "}]}}}\n";
  };
  const Result whole = run_text(deck("", ""));
  ASSERT_EQ(whole.status, Status::ok) << whole.message << to_text(whole.errors);
  EXPECT_TRUE(whole.unmade.empty());
  EXPECT_THAT(run_text(deck("{over: side}, ", "")).unmade,
              testing::Contains(HasSubstr("life leaves out the bends over 'side'")));
  EXPECT_TRUE(run_text(deck("{over: side}, ", ", over: [head]")).unmade.empty());
  expect_mistake(run_text(deck("", ", over: [lone]")), "the rope runs over no 'lone' with a diameter");
}

// Of a core that nobody knows, or of which there is no row, the least f_C counts: 0.81 of 6 strands.
TEST(RopeLife, AnUnknownCoreHasTheLeastFactor) {
  const auto damage = [](const std::string& construction) {
    const Result r = run_text(R"(taut: 1
machine:
  ropes: {hoist: {mass: 1 kg/m, stiffness: 13 MN, diameter: 16 mm, breaking_force: 200 kN}}
  bodies: {load: {mass: 3 t, at: [0.2 m, 0 m, 5 m], free: [z]}}
  sheaves: {head: {at: [0 m, 0 m, 20 m], diameter: 400 mm}}
  drums: {winch: {at: [-8 m, 0 m, 2 m], core_diameter: 384 mm}}
  reevings: [{rope: hoist, path: [{drum: winch}, {over: head}, {anchor: load}], length: 35 m}]
checks:
  ropes: {hoist: {safety_factor: 3, construction: )" +
                              construction +
                              R"(, grade: 1960 MPa, duty: [{name: w, cycles: 4e5}],
                  life: {constants: [{count: discard_10, a: [1.278, 0.029, 6.241, -1.613]}]}}}
)");
    return taut_test::check_of(r, "hoist.life").value;
  };
  const double known = damage("6x36-IWRC");
  EXPECT_DOUBLE_EQ(damage("6x36"), known);
  EXPECT_DOUBLE_EQ(damage("6x36-WSC"), known);
  EXPECT_LT(damage("6x36-FC"), known);
}

// What a duty names and does not bend the rope adds nothing to the damage: that is no life.
TEST(RopeLife, a_duty_over_a_saddle_is_not_judged) {
  const auto deck = [](const std::string& duty) {
    return run_text(R"(taut: 1
machine:
  ropes: {hoist: {rope: "EN 12385-4|6x36-IWRC|16|1960"}}
  bodies: {hook: {mass: 2 t, free: [z]}}
  points: {eye: {body: hook, at: [5.2 m, 0 m, 0 m]}}
  sheaves: {head: {at: [5 m, 0 m, 10 m], diameter: 400 mm}}
  supports: {sad: {at: [2 m, 0 m, 5 m], diameter: 300 mm, law: saddle, friction: 0.1}}
  drums: {winch: {at: [0 m, 0 m, 0 m], core_diameter: 300 mm}}
  reevings: [{rope: hoist, path: [{drum: winch}, {over: sad}, {over: head}, {anchor: eye}], length: 20 m}]
analyses: [equilibrium: {}]
checks: {ropes: {hoist: {safety_factor: 3, duty: [)" +
                    duty + "]}}}\n");
  };
  const std::string over_winch = "{name: w, cycles: 10, over: winch}",
                    over_saddle = "{name: s, cycles: 5e9, over: sad}";
  EXPECT_TRUE(deck(over_winch).unmade.empty());
  EXPECT_THAT(deck(over_winch + ", " + over_saddle).unmade,
              testing::ElementsAre(HasSubstr("hoist: its life leaves out 'sad' of the duty 's'")));
  EXPECT_THAT(deck(over_saddle).unmade, testing::Contains(HasSubstr("hoist: its life is not computed")));
}

// A rope in two reevings: each has the damage of the duties over its own rounds.
TEST(RopeLife, a_duty_over_another_reeving_of_the_rope_is_that_ones) {
  const auto deck = [](const std::string& duty) {
    return run_text(R"(taut: 1
machine:
  ropes: {r: {rope: "EN 12385-4|6x36-IWRC|16|1960"}}
  bodies: {h1: {mass: 2 t, free: [z]}, h2: {mass: 6 t, free: [z]}}
  points:
    a: {at: [0 m, 0 m, 0 m]}
    e1: {body: h1, at: [2.2 m, 0 m, 0 m]}
    e2: {body: h2, at: [4.2 m, 3 m, 0 m]}
    a2: {at: [0 m, 3 m, 0 m]}
  sheaves: {s1: {at: [2 m, 0 m, 10 m], diameter: 400 mm}, s2: {at: [4 m, 3 m, 10 m], diameter: 400 mm}}
  reevings:
    - {name: one, rope: r, path: [{anchor: a}, {over: s1}, {anchor: e1}], length: 15 m}
    - {name: two, rope: r, path: [{anchor: a2}, {over: s2}, {anchor: e2}], length: 15 m}
analyses: [equilibrium: {}]
checks: {ropes: {r: {safety_factor: 2, duty: [{name: w, cycles: 1e4, over: s1})" +
                    duty + "]}}}\n");
  };
  EXPECT_THAT(deck("").unmade,
              testing::ElementsAre(HasSubstr("two: its life is not computed: no duty runs over 's2', which bends it")));
  const Result both = deck(", {name: v, cycles: 1e4, over: s2}");
  EXPECT_TRUE(both.unmade.empty());
  EXPECT_EQ(table_of(both, "life_one").rows.size(), 1U);
  EXPECT_EQ(table_of(both, "life_two").rows.size(), 1U);
}

// Data of a life ask for one. The Donandt force is a check of its own.
TEST(RopeLife, its_data_need_a_duty) {
  for (const char* life : {"core_factor: 2", "reverse_weight: 5", "bent_length: 20 m",
                           "donandt_force: 90 kN, core_factor: 2", "constants: [{count: discard, a: [5, 0, 0, 0]}]"}) {
    expect_mistake(run_text(lift(fmt::format("{{life: {{{}}}}}", life))),
                   "checks.ropes.hoist.life: a life needs a 'duty'");
  }
  EXPECT_EQ(run_text(lift("{life: {donandt_force: 90 kN}}")).status, Status::ok);
}

// Feyrer's table 3.14a has ropes of 6 and of 8 strands: 18x7 had the factor 1 of 8 strands, an unknown rope 0.81.
TEST(RopeLife, a_rope_of_other_strands_has_no_endurance_factor) {
  const auto judged = [](const std::string& construction, const std::string& life) {
    const std::string given = construction.empty() ? "" : "construction: " + construction + ", ";
    Result r =
        run_text(lift("{" + given + "grade: 1770 MPa, duty: [{name: lifts, cycles: 200}]" + life + "}"),
                 {"machine.ropes.hoist={mass: 1 kg/m, stiffness: 12 MN, breaking_force: 150 kN, diameter: 16 mm}"});
    EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    return r;
  };
  for (const char* name : {"18x7-WSC", "35x7", "3x19", "4x36WS-FC", "7x19", "1x19", ""}) {
    const Result r = judged(name, "");
    EXPECT_THAT(r.unmade, testing::Contains(HasSubstr("give 'life: core_factor' of the rope's maker"))) << name;
    EXPECT_EQ(r.find_value("hoist.life_damage"), nullptr) << name;
    EXPECT_GT(value_of(judged(name, ", life: {core_factor: 0.5}"), "hoist.life_damage"), 0) << name;
  }
  for (const char* name : {"6x36WS-IWRC", "8x19S-FC"}) {
    EXPECT_GT(value_of(judged(name, ""), "hoist.life_damage"), 0) << name;
  }
}

}  // namespace taut::checks::rope_life_test
