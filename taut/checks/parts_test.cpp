#include "taut/checks/parts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "taut/calc/verdict.hpp"
#include "taut/checks/judge.hpp"
#include "test/support/guyed_decks.hpp"
#include "test/support/machine_decks.hpp"

/// `exempt` takes out one part with all that is said of it, and nothing of another part that has its name.
namespace taut::checks::parts_test {

using taut_test::check_of;
using taut_test::has_check;
using taut_test::run_text;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

VerdictKind kind_of(const Result& r) {
  const auto verdict = verdict_of(r);
  EXPECT_TRUE(verdict) << r.message << to_text(r.errors);
  return verdict ? verdict->kind : VerdictKind::no_answer;
}

/// A load of 1 t hangs on the drum 'winch' by the rope 'winch', and one of 1 t on another rope. The drum has a brake of
/// 1 kN m and a radius of 200 mm and half a rope, 207 mm: 10 m/s^2 (1000 kg + 15 m 0.5 kg/m) 0.207 m = 2.09 kN m.
std::string two_winches(const std::string& exempt) {
  return R"(taut: 1
machine:
  gravity: 10 m/s^2
  points: {p: [0 m, 0 m, 0 m]}
  ropes:
    winch: {mass: 0.5 kg/m, stiffness: 10 MN, breaking_force: 200 kN, diameter: 14 mm}
    other: {mass: 0.5 kg/m, stiffness: 10 MN, breaking_force: 200 kN, diameter: 14 mm}
  bodies: {c: {mass: 1 t, at: [20.2 m, 0 m, -10 m], free: [z]}, e: {mass: 1 t, at: [0 m, 0 m, -10 m], free: [z]}}
  drums: {winch: {at: [20 m, 0 m, 5 m], core_diameter: 400 mm, brake_torque: 1 kN m}}
  reevings:
    - {rope: winch, path: [{drum: winch, side: right}, {anchor: c}], length: 14.998 m}
    - {rope: other, path: [{anchor: p}, {anchor: e}], length: 10 m}
analyses: [{equilibrium: {}}]
checks: {ropes: {other: {safety_factor: 3}}, exempt: [)" +
         exempt + "]}\n";
}

TEST(Parts, ANameOfSeveralPartsIsRefused) {
  const Result r = run_text(two_winches("winch"));
  EXPECT_EQ(r.status, Status::bad_deck);
  EXPECT_THAT(to_text(r.errors), HasSubstr("deck.yaml:14:55: error: checks.exempt[0]: several parts are called "
                                           "'winch': a rope, a drum; say which one: 'rope winch', 'drum winch'"));
}

TEST(Parts, ExemptingARopeLeavesTheBrakeOfItsDrum) {
  const Result rope = run_text(two_winches("rope winch"));
  EXPECT_EQ(kind_of(rope), VerdictKind::fails) << verdict_of(rope)->reason;
  EXPECT_NEAR(check_of(rope, "winch.brake_torque").value, 10 * (1000 + 15 * 0.5) * 0.207, 2);
  EXPECT_THAT(rope.exempt, ElementsAre("rope winch"));
  const Result drum = run_text(two_winches("drum winch"));
  EXPECT_EQ(verdict_of(drum)->verdict_class, "unasked") << verdict_of(drum)->reason;
  EXPECT_THAT(drum.unjudged, ElementsAre("winch"));
  EXPECT_FALSE(has_check(drum, "winch.brake_torque"));
  EXPECT_EQ(kind_of(run_text(two_winches("drum winch, rope winch"))), VerdictKind::passes);
}

/// A slack tag line to a stump, which no state pulls at.
TEST(Parts, ExemptTakesAnAnchorOut) {
  const auto with = [](const std::string& exempt) {
    return run_text(R"(taut: 1
machine:
  points: {a: [0 m, 0 m, 0 m], stump: [5 m, 0 m, -20 m]}
  ropes: {r: {mass: 0 kg/m, stiffness: 10 MN, breaking_force: 50 kN, diameter: 14 mm}}
  bodies: {load: {mass: 500 kg, at: [0 m, 0 m, -6 m], free: [x, y, z]}}
  reevings:
    - {rope: r, name: hoist, path: [{anchor: a}, {anchor: load}], length: 6 m}
    - {rope: r, name: tag, path: [{anchor: stump}, {anchor: load}], length: 25 m, may_slack: true}
analyses: [{equilibrium: {}}]
checks:
  ropes: {hoist: {safety_factor: 5}}
  anchors: {stump: {strength: 10 kN, safety_factor: 2}, a: {strength: 8 kN, safety_factor: 2}}
)" + exempt);
  };
  EXPECT_EQ(kind_of(with("")), VerdictKind::fails) << "a holds 8 kN against 4.9 kN";
  const Result one = with("  exempt: [a]\n");
  EXPECT_EQ(verdict_of(one)->verdict_class, "unmade") << verdict_of(one)->reason;
  EXPECT_THAT(one.unmade, ElementsAre(HasSubstr("stump is not checked")));
  const Result both = with("  exempt: [a, stump]\n");
  EXPECT_EQ(kind_of(both), VerdictKind::passes) << verdict_of(both)->reason;
  EXPECT_THAT(both.warnings, Not(Contains(HasSubstr("stump is not checked"))));
}

/// A drum that turns in the only state leaves its brake unmade.
TEST(Parts, ExemptTakesADrumOut) {
  const Result r = run_text(R"(taut: 1
machine:
  gravity: 10 m/s^2
  ropes: {r: {mass: 0.5 kg/m, stiffness: 10 MN, breaking_force: 200 kN, diameter: 14 mm}}
  bodies: {c: {mass: 1 t, at: [20.2 m, 0 m, -10 m], free: [z]}}
  drums:
    d: {at: [20 m, 0 m, 5 m], core_diameter: 400 mm, inertia: 10 kg m^2, drive: {speed: 0.3 m/s}, brake_torque: 5 kN m}
  reevings: [{rope: r, path: [{drum: d, side: right}, {anchor: c}], length: 14.998 m}]
analyses: [transient: {start: assembled, output_step: 10 ms, duration: 1 s}]
checks: {ropes: {r: {safety_factor: 2, sheave_weakening: covered}}, exempt: [d]}
)");
  ASSERT_TRUE(verdict_of(r)) << r.message << to_text(r.errors);
  EXPECT_THAT(r.unmade, IsEmpty()) << r.unmade.front();
  EXPECT_THAT(r.warnings, Not(Contains(HasSubstr("d.brake_torque"))));
  EXPECT_THAT(r.unsafe, ElementsAre(HasSubstr("r goes slack"))) << "the rope is not exempt";
}

/// A rope that is pulled up off its support.
TEST(Parts, WarningsOfAnExemptSupportAreNotUnsafe) {
  const auto with = [](const std::string& exempt) {
    return run_text(R"(taut: 1
machine:
  gravity: 10 m/s^2
  points: {a: [-100 m, 0 m, 20 m], b: [100 m, 0 m, 20 m]}
  ropes: {r: {mass: 0.5 kg/m, stiffness: 10 MN, breaking_force: 200 kN, diameter: 14 mm}}
  supports: {S: {at: [0 m, 0 m, 10 m], friction: 0}}
  reevings: [{rope: r, path: [{anchor: a}, {over: S}, {anchor: b}], tension_at_end: 40 kN}]
analyses: [{equilibrium: {}}]
checks: {ropes: {r: {safety_factor: 2, sheave_weakening: covered}})" +
                    exempt + "}\n");
  };
  EXPECT_EQ(kind_of(with("")), VerdictKind::passes_with_warnings);
  for (const char* name : {"S", "support S"}) {
    const Result r = with(", exempt: [" + std::string(name) + "]");
    EXPECT_EQ(kind_of(r), VerdictKind::passes) << verdict_of(r)->reason;
    EXPECT_THAT(r.warnings, Contains(HasSubstr("the rope pulls 'S' upwards")));
  }
}

/// The stress of a mast without W_t leaves its torsion out.
TEST(Parts, ExemptTakesABeamOut) {
  const Result r = run_text(R"(taut: 1
machine:
  gravity: 10 m/s^2
  points: {foot: [0 m, 0 m, 0 m], head: [0 m, 0 m, 6 m], tip: [2 m, 0 m, 6 m], t: [30 m, 0 m, 6 m]}
  ropes: {r: {rope: "EN 12385-4|6x36-IWRC|18|1770", stiffness: 12 MN}}
  beams:
    mast: {from: foot, to: head, A: 40 cm^2, I: 2000 cm^4, W: 200 cm^3, steel: S355}
    arm: {from: mast.top, to: tip, section: CHS 219.1x10, steel: S355}
  reevings: [{rope: r, path: [{anchor: t}, {anchor: mast.top}], tension_at_start: 1 kN}]
  loads: [{at: arm.top, force: [0 kN, 2 kN, -1 kN]}]
checks:
  exempt: [mast]
  confirmed: [EN 1993-1-1]
  ropes: {r: {safety_factor: 3}}
  masts: {arm: {load_factor: 1.5}}
analyses: [{equilibrium: {}}]
)");
  ASSERT_TRUE(verdict_of(r)) << r.message << to_text(r.errors);
  EXPECT_THAT(r.unmade, IsEmpty()) << r.unmade.front();
  EXPECT_FALSE(has_check(r, "mast.stress_max"));
  EXPECT_TRUE(has_check(r, "arm.stress_max"));
}

/// A mast that no combination judges in one analysis is no part without a limit where it is exempt.
TEST(Parts, AnExemptMastNeedsNoCombination) {
  const auto with = [](const std::string& exempt) {
    return run_text(taut_test::guyed("  masts: {mast: {combinations: {A: {equilibrium: 1.5}}}}\n" + exempt +
                                     "analyses:\n  - equilibrium: {}\n"
                                     "  - sweep: {name: one, parameter: points.a1.z, from: 0 m, to: 1 m, steps: 1}\n"));
  };
  const Result told = with(""), exempt = with("  exempt: [mast]\n");
  ASSERT_TRUE(verdict_of(told) && verdict_of(exempt)) << to_text(told.errors) << to_text(exempt.errors);
  EXPECT_THAT(told.unjudged, Contains(HasSubstr("mast in 'one'")));
  EXPECT_THAT(exempt.unjudged, Not(Contains(HasSubstr("mast"))));
}

/// What lifts off in a motion is a support, whatever the name of a rope.
TEST(Parts, LiftOffIsOfTheSupport) {
  machine::Model model;
  machine::Reeving& rope = model.reevings.emplace_back();
  rope.name = "S";
  rope.nodes.resize(3);
  rope.nodes[1].name = "S";
  rope.nodes[1].kind = machine::NodeKind::contact;
  machine::Machine machine;
  machine.reevings.emplace_back().rope = "S";
  machine.supports.emplace_back().name = "S";
  solve::TransientResult motion;
  motion.events = {{.t = 1, .what = "lift_off", .where = "S", .values = {}}};
  const auto judged = [&](const std::string& exempt) {
    const std::vector<study::AnalysisRequest> analyses;
    std::optional<ChecksRequest> checks;
    checks.emplace().exempt = {exempt};
    const AskedChecks asked;
    const std::map<std::string, catalogue::RopeRow> chosen;
    const Display display;
    Judge judge({.machine = machine,
                 .analyses = analyses,
                 .checks = checks,
                 .asked = asked,
                 .chosen = chosen,
                 .display = display},
                model);
    judge.take(model, motion, "transient");
    Result r;
    judge.add_values(r);
    judge.add_scope(r);
    return r;
  };
  EXPECT_THAT(judged("rope S").unsafe, ElementsAre("transient: S lifts off at t = 1 s"));
  EXPECT_THAT(judged("support S").unsafe, IsEmpty());
  EXPECT_THAT(judged("S").unsafe, ElementsAre("transient: S lifts off at t = 1 s")) << "which one is not said";
}

/// A contact has the name of its point: it is taken out with that.
TEST(Parts, AContactIsThatOfItsPoint) {
  machine::Machine machine;
  machine.points.emplace_back().name = "heel";
  machine.contacts.emplace_back().point = "heel";
  machine.contacts.emplace_back().point = "heel";
  machine.contacts.back().name = "side";
  ChecksRequest request;
  request.exempt = {"heel", "contact side", "contact heel"};
  const Part point{.kind = PartKind::point, .name = "heel"}, heel{.kind = PartKind::contact, .name = "heel"},
      side{.kind = PartKind::contact, .name = "side"};
  EXPECT_THAT(exempt_parts(request, machine), ElementsAre(point, heel, side));
  std::vector<Complaint> complaints;
  complain_of_exempt(request, machine, complaints);
  ASSERT_EQ(complaints.size(), 1U);
  EXPECT_THAT(complaints[0].message, HasSubstr("the machine has no part 'contact heel'"));
}

/// Whatever is called "bollard": only the part that is named goes out.
TEST(Parts, EachKindIsNamedByItsWord) {
  machine::Machine machine;
  machine.reevings.emplace_back().rope = "bollard";
  machine.guys.emplace_back().name = "stay";
  machine.beams.emplace_back().name = "pole";
  machine.drums.emplace_back().name = "bollard";
  machine.sheaves.emplace_back().name = "stay";
  machine.supports.emplace_back().name = "bollard";
  machine.points.emplace_back().name = "pole";
  machine.bodies.emplace_back().name = "bollard";
  machine.carriages.emplace_back().name = "pole";
  ChecksRequest request;
  request.masts.emplace_back().name = "bollard";
  request.anchors.emplace_back().name = "pole";
  request.yarders.emplace_back().name = "stay";
  const auto part_of = [&](const std::string& text) {
    request.exempt = {text};
    return exempt_parts(request, machine);
  };
  const auto is = [](PartKind kind, const char* name) { return ElementsAre(Part{.kind = kind, .name = name}); };
  for (const char* name : {"bollard", "stay", "pole"}) EXPECT_THAT(part_of(name), IsEmpty()) << name;
  EXPECT_THAT(part_of("rope bollard"), is(PartKind::rope, "bollard"));
  EXPECT_THAT(part_of("drum bollard"), is(PartKind::drum, "bollard"));
  EXPECT_THAT(part_of("support bollard"), is(PartKind::sheave, "bollard"));
  EXPECT_THAT(part_of("body bollard"), is(PartKind::body, "bollard"));
  EXPECT_THAT(part_of("mast bollard"), is(PartKind::mast, "bollard"));
  EXPECT_THAT(part_of("guy stay"), is(PartKind::rope, "stay"));
  EXPECT_THAT(part_of("sheave stay"), is(PartKind::sheave, "stay"));
  EXPECT_THAT(part_of("yarder stay"), is(PartKind::yarder, "stay"));
  EXPECT_THAT(part_of("beam pole"), is(PartKind::beam, "pole"));
  EXPECT_THAT(part_of("point pole"), is(PartKind::point, "pole"));
  EXPECT_THAT(part_of("carriage pole"), is(PartKind::carriage, "pole"));
}

}  // namespace taut::checks::parts_test
