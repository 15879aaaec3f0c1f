#include "taut/app/design/design_machine.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "taut/app/prepare_machine.hpp"
#include "taut/catalogue/section_search.hpp"
#include "taut/io/deck/deck.hpp"
#include "taut/study/deck/parameter.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::app::design_machine_test {

using design::Depth;
using testing::ElementsAre;
using testing::HasSubstr;

/// A rope `line` from the origin to a place 30 m away and 40 m up, and as a guy of a pole of 6 m to a stump 8 m away;
/// a rope `stay` of 10 m that is given.
std::string deck_with(const std::string& checks_and_design, const std::string& pole = "section: CHS 219.1x10") {
  return "taut: 1\n"
         "machine:\n"
         "  points:\n"
         "    low: [0 m, 0 m, 0 m]\n"
         "    high: [30 m, 0 m, 40 m]\n"
         "    foot: [0 m, 50 m, 0 m]\n"
         "    head: [0 m, 50 m, 6 m]\n"
         "    stump: [8 m, 50 m, 0 m]\n"
         "    near: [0 m, 90 m, 0 m]\n"
         "    far: [6 m, 98 m, 0 m]\n"
         "  ropes: {line: {}, stay: {mass: 2 kg/m, stiffness: 20 MN, breaking_force: 300 kN}}\n"
         "  beams: {pole: {from: foot, to: head, steel: S355, " +
         pole +
         "}}\n"
         "  reevings:\n"
         "    - {name: span, rope: line, path: [{anchor: low}, {anchor: high}], length: 50.1 m}\n"
         "    - {rope: stay, path: [{anchor: near}, {anchor: far}], length: 10.01 m}\n"
         "  guys: {tie: {rope: line, from: pole.top, to: stump, install: {tension: 1 kN, at: top}}}\n" +
         checks_and_design;
}

std::string without(std::string text, const std::string& part) { return text.erase(text.find(part), part.size()); }

const std::string checks = "checks: {ropes: {stay: {safety_factor: 3}}, guys: {line: {safety_factor: 3}}}\n";
const std::string line = "line: {construction: 6x36, core: IWRC, grade: 1960 MPa, modulus: 90 GPa}";
const std::string height = "unknowns: {height: {parameter: points.high.z, from: 40 m, to: 72 m}}";

std::optional<ReadMachine> try_read(const std::string& text, Diagnostics& mistakes) {
  const auto deck = io::read_deck(text, "deck.yaml", {}, {}, mistakes);
  return deck ? read_machine(deck->input, deck->display, mistakes) : std::nullopt;
}

ReadMachine read(const std::string& text) {
  Diagnostics mistakes;
  auto machine = try_read(text, mistakes);
  if (!machine) throw std::runtime_error(to_text(mistakes));
  return std::move(*machine);
}

std::string mistakes_of(const std::string& text) {
  Diagnostics mistakes;
  try_read(text, mistakes);
  return to_text(mistakes);
}

using Run = std::function<Result(const MachineDeck&, RunDepth)>;

/// The task of a deck, with `run` in place of the calculation of machines.
design::DesignTask task_of(
    const ReadMachine& read, const Run& run = [](const MachineDeck&, RunDepth) { return Result{}; }) {
  const auto door = [run](const MachineDeck& deck, RunDepth depth, const std::function<bool(const Progress&)>&,
                          const States&) { return run(deck, depth); };
  return machine_task(read.deck, read.space, {.run = door, .picture = [](const MachineDeck&, Result&) {}}, {});
}

Value tension(const std::string& name, double value) {
  return {.name = name, .value = value, .unit = si::N, .symbol = "", .label = "", .source = ""};
}

Result with_check(double utilisation, const std::string& name = "skyline.T_max") {
  Result r;
  r.checks = {
      make_check(name, utilisation, si::one, {.sense = Sense::at_most, .limit = 1, .rule = "", .trust = "user"})};
  return r;
}

TEST(DesignMachine, MistakesHaveTheirPathInTheDeck) {
  const auto expect = [](const std::string& text, const std::string& path, const std::string& words) {
    const std::string mistakes = mistakes_of(text);
    EXPECT_THAT(mistakes, HasSubstr(path + ": "));
    EXPECT_THAT(mistakes, HasSubstr(words));
  };
  expect(deck_with("design: {ropes: {" + line + "}}\n"), "design", "needs 'checks'");
  expect(deck_with(checks + "design: {ropes: {lin: {}}}\n"), "design.ropes.lin", "the machine has no rope 'lin'");
  expect(deck_with(checks + "design: {sections: {pol: {}}}\n"), "design.sections.pol", "did you mean 'pole'");
  expect(deck_with(checks + "design: {ropes: {" + line + "}, sections: {pole: {}}}\n",
                   "A: 60 cm^2, I: 3000 cm^4, W: 270 cm^3"),
         "design.sections.pole", "has its section by figures");
  expect(deck_with(checks + "design: {unknowns: {h: {parameter: points.hih.z, from: 1 m, to: 2 m}}}\n"),
         "design.unknowns.h.parameter", "did you mean 'high'");
}

TEST(DesignMachine, AChoiceStandsInTheDeckAndNotInTheOneItComesFrom) {
  const ReadMachine own = read(deck_with(checks + "design: {ropes: {" + line + "}, sections: {pole: {shape: chs}}, " +
                                         height + ", cases: {late: {guys.tie.install.tension: 5 kN}}}\n"));
  ASSERT_GT(own.space.ropes.at(0).rows.size(), 4U);
  const design::DesignPlace place{.choice = {3, 2}, .values = {72}};
  const MachineDeck made = with_design(*own.deck, own.space, place, &own.space.cases.at(0));
  const catalogue::RopeRow& row = own.space.ropes[0].rows[3];
  const auto& rope = made.machine.ropes.at(0);
  EXPECT_EQ(rope.mass, row.mass_per_length);
  EXPECT_EQ(rope.breaking_force, row.breaking_force);
  EXPECT_EQ(rope.diameter, row.diameter);
  EXPECT_DOUBLE_EQ(rope.stiffness.value(), 90e9 * row.area) << "the modulus of the block";
  EXPECT_EQ(made.chosen.at("line").id, row.id);
  EXPECT_EQ(made.machine.ropes.at(1).mass, 2) << "that is not free";
  EXPECT_EQ(made.machine.beams.at(0).section, own.space.sections.at(0).rows[2].name);
  EXPECT_EQ(made.machine.guys.at(0).install->tension, 5e3);
  const auto high = [](MachineDeck deck) {
    return study::find_parameter(machine::Machine::describe(), &deck.machine, "points.high.z")->value;
  };
  EXPECT_EQ(high(made), 72);
  EXPECT_EQ(high(*own.deck), 40);
  EXPECT_FALSE(own.deck->machine.ropes.at(0).mass.has_value());
  EXPECT_EQ(own.deck->machine.beams.at(0).section, "CHS 219.1x10");
  EXPECT_EQ(own.deck->machine.guys.at(0).install->tension, 1e3);
}

// "a value of the deck replaces that of the catalogue": a rope with cutters is heavier than its row.
TEST(DesignMachine, WhatTheDeckSaysOfAChosenRopeCounts) {
  const std::string free = "line: {construction: 6x36, core: IWRC, grade: 1960 MPa}";
  const auto text = [&](const std::string& rope, const std::string& choice) {
    std::string deck = deck_with(checks + "design: {ropes: {" + choice + "}}\n");
    return deck.replace(deck.find("line: {}"), 8, "line: {" + rope + "}");
  };
  const ReadMachine own = read(text("mass: 3 kg/m, stiffness: 4 MN", free));
  const MachineDeck made = with_design(*own.deck, own.space, {.choice = {3}, .values = {}});
  const auto& rope = made.machine.ropes.at(0);
  EXPECT_EQ(rope.mass, 3);
  EXPECT_EQ(rope.stiffness, 4e6);
  const design::RopeCandidates& candidates = own.space.ropes.at(0);
  EXPECT_EQ(rope.breaking_force, candidates.rows[3].breaking_force);
  EXPECT_DOUBLE_EQ(candidates.moduli[3] * candidates.rows[3].area, 4e6) << "as it is printed";
  const auto refused = [&](const std::string& place, const std::string& mistakes) {
    EXPECT_THAT(mistakes, HasSubstr(place + ": "));
  };
  refused("machine.ropes.line.breaking_force", mistakes_of(text("breaking_force: 130 kN", free)));
  refused("machine.ropes.line.diameter", mistakes_of(text("diameter: 14 mm", free)));
  refused("design.ropes.line.modulus", mistakes_of(text("stiffness: 4 MN", line)));
  EXPECT_THAT(mistakes_of(text("rope: \"EN 12385-4|6x36-IWRC|14|1960\"", free)), testing::IsEmpty());
}

// The checks take both from the row: the case, or the unknown, would count in part.
TEST(DesignMachine, NothingChangesTheStrengthOfAChosenRope) {
  const auto mistakes_with = [](const std::string& more) {
    return mistakes_of(deck_with(checks + "design: {ropes: {" + line + "}, " + more + "}\n"));
  };
  const auto refused = [&](const std::string& place, const std::string& more) {
    EXPECT_THAT(mistakes_with(more), HasSubstr(place + ": 'design' chooses this rope"));
  };
  refused("design.cases.worn.ropes.line.breaking_force", "cases: {worn: {ropes.line.breaking_force: 60 kN}}");
  refused("design.cases.thin.machine.ropes.line.diameter", "cases: {thin: {machine.ropes.line.diameter: 10 mm}}");
  refused("design.unknowns.m.parameter",
          "unknowns: {m: {parameter: ropes.line.breaking_force, from: 10 kN, to: 2000 kN}}");
  refused("design.unknowns.m.along_with[0]",
          "unknowns: {m: {parameter: ropes.stay.breaking_force, along_with: [ropes.line.breaking_force], "
          "from: 300 kN, to: 400 kN}}");
  EXPECT_THAT(mistakes_with("cases: {worn: {ropes.stay.breaking_force: 200 kN}}"), testing::IsEmpty())
      << "of a rope that is given";
}

// The search would report a number that no state has.
TEST(DesignMachine, WhatEveryAnalysisSetsAnewIsNoUnknown) {
  const std::string sweep = "analyses: [sweep: {parameter: points.high.z, from: 40 m, to: 50 m, steps: 2}]\n";
  const auto mistakes_with = [&](const std::string& unknown) {
    return mistakes_of(deck_with(sweep + checks + "design: {unknowns: {h: {" + unknown + "}}}\n"));
  };
  EXPECT_THAT(mistakes_with("parameter: machine.points.high.z, from: 40 m, to: 72 m"),
              HasSubstr("design.unknowns.h.parameter: every analysis sets this number anew"));
  EXPECT_THAT(mistakes_with("parameter: points.low.z, along_with: [\"points.high[2]\"], from: 0 m, to: 1 m"),
              HasSubstr("design.unknowns.h.along_with[0]: every analysis sets this number anew"));
  EXPECT_THAT(mistakes_with("parameter: points.low.z, from: 0 m, to: 1 m"),
              testing::Not(HasSubstr("sets this number anew")));
}

// Nothing would limit the choice: the lightest rope was "built", and broke.
TEST(DesignMachine, WhatIsExemptIsNotChosen) {
  const auto mistakes_with = [](const std::string& exempt) {
    const std::string own = "checks: {exempt: [" + exempt + "], ropes: {stay: {safety_factor: 3}}}\n";
    return mistakes_of(deck_with(own + "design: {ropes: {" + line + "}, sections: {pole: {shape: chs}}}\n"));
  };
  EXPECT_THAT(mistakes_with("span, tie, pole"), HasSubstr("design.ropes.line: 'checks.exempt' takes it out"));
  EXPECT_THAT(mistakes_with("span, tie, pole"), HasSubstr("design.sections.pole: 'checks.exempt' takes it out"));
  EXPECT_THAT(mistakes_with("tie, stay"), testing::IsEmpty()) << "the span limits the same rope";
}

// The rows set mass and stiffness of a rope: a case, or an unknown, that sets them too comes after them.
TEST(DesignMachine, ACaseSetsWhatTheChosenRopeHas) {
  const ReadMachine own =
      read(deck_with(checks + "design: {ropes: {" + line +
                     "}, unknowns: {soft: {parameter: ropes.line.stiffness, from: 5 MN, to: 9 MN}}, "
                     "cases: {iced: {ropes.line.mass: 30 kg/m}}}\n"));
  const MachineDeck made = with_design(*own.deck, own.space, {.choice = {3}, .values = {7e6}}, &own.space.cases.at(0));
  EXPECT_EQ(made.machine.ropes.at(0).mass, 30);
  EXPECT_EQ(made.machine.ropes.at(0).stiffness, 7e6);
  EXPECT_EQ(made.machine.ropes.at(0).diameter, own.space.ropes.at(0).rows[3].diameter);
}

// hypot(30, 40) = 50, hypot(30, 72) = 78; the guy has hypot(8, 6) = 10. What the deck gives a length has that one.
TEST(DesignMachine, WhatIsPaidByLengthFollowsTheUnknowns) {
  const std::string cut = ", length: 50.1 m";
  const auto lengths_of = [&](const std::string& design, double z, const std::string& span = "") {
    std::string text = deck_with(checks + "design: {" + design + "}\n");
    text.replace(text.find(cut), cut.size(), span.empty() ? ", tension_at_start: 1 kN" : span);
    return task_of(read(text)).lengths({z});
  };
  const std::string ropes = "ropes: {" + line + "}, ";
  const design::DesignLengths low = lengths_of(ropes + height, 40), high = lengths_of(ropes + height, 72);
  ASSERT_EQ(low.ropes.size(), 1U);
  EXPECT_NEAR(low.ropes[0], 50 + 10, 1e-9);
  EXPECT_NEAR(high.ropes[0], 78 + 10, 1e-9);
  const double pole = catalogue::find_section("CHS 219.1x10")->mass_per_length;
  EXPECT_NEAR(lengths_of(ropes + height, 40, cut).ropes[0], 50.1 + 10, 1e-9);
  EXPECT_NEAR(lengths_of(ropes + height, 72, cut).ropes[0], 50.1 + 10, 1e-9);
  EXPECT_NEAR(low.rest, 10.01 * 2 + 6 * pole, 1e-9) << "the stay and the pole are built all the same";
  const design::DesignLengths free = lengths_of(ropes + "sections: {pole: {shape: chs}}, " + height, 40);
  EXPECT_THAT(free.sections, ElementsAre(testing::DoubleNear(6, 1e-9)));
  EXPECT_NEAR(free.rest, 10.01 * 2, 1e-9);
  std::string given = deck_with(
      checks +
      "design: {seek: cheapest, unknowns: {height: {parameter: points.high.z, from: 40 m, to: 72 m, price: 3}}}\n");
  given.replace(given.find("line: {}"), 8, "line: {mass: 1 kg/m, stiffness: 10 MN, breaking_force: 100 kN}");
  EXPECT_NEAR(task_of(read(given)).lengths({60}).rest, 3 * 60, 1e-9) << "nothing else has a price";
  EXPECT_THAT(lengths_of("seek: smallest, " + ropes + height, 72).ropes, ElementsAre(1)) << "a diameter has no length";
}

TEST(DesignMachine, AChecksPartNamesTheListThatItJudges) {
  const auto task = task_of(
      read(without(deck_with(checks + "design: {ropes: {" + line + ", stay: {}}, sections: {pole: {shape: chs}}}\n"),
                   ", breaking_force: 300 kN")));
  const std::map<std::string, std::size_t> expected = {{"line", 0}, {"span", 0}, {"tie", 0}, {"stay", 1}, {"pole", 2}};
  EXPECT_EQ(task.list_of, expected);
}

TEST(DesignMachine, TheLeastTensionIsThatOfTheRopeInQuestion) {
  Result r = with_check(0.5);
  r.values = {tension("span.T_max", 7e3), tension("stay.T_max", 9e3), tension("tie.T_max", 8e3),
              tension("stay.T_max_2", 1e3), tension("span.not_T_max", 5e4)};
  const auto tension_with = [&](const std::string& seek, const Result& result) {
    const auto task = task_of(read(deck_with(checks + "design: {ropes: {" + line + "}, " + seek + "}\n")),
                              [&](const MachineDeck&, RunDepth) { return result; });
    return task.run({.choice = {0}, .values = {}}, Depth::checks, {}).tension;
  };
  EXPECT_EQ(tension_with("seek: least_tension", r), 9e3);
  EXPECT_EQ(tension_with("seek: least_tension, of: stay", r), 9e3);
  EXPECT_EQ(tension_with("seek: least_tension, of: line", r), 8e3) << "as it is rove and as a guy";
  EXPECT_EQ(tension_with("seek: least_tension, of: span", r), 7e3);
  EXPECT_TRUE(std::isnan(tension_with("seek: least_tension", Result{})));
}

/// A line with a load path and one more analysis, whose mainline is free.
ReadMachine skyline() {
  return read(
      without(taut_test::skyline_deck("  - equilibrium: {motion: at_rest}\n"
                                      "  - load_path: {carriage: car, from: 135 m, to: 230 m, steps: 5}\n"
                                      "  - payload: {carriage: car, from: 135 m, to: 230 m, steps: 5, motion: in, "
                                      "limits: {skyline: {safety_factor: 3}}}\n"
                                      "checks: {ropes: {skyline: {safety_factor: 3}, mainline: {safety_factor: 3}}}\n"
                                      "design: {ropes: {mainline: {}}, disregard: [car.sway]}\n"),
              "mass: 0.54 kg/m, stiffness: 7 MN, breaking_force: 110 kN"));
}

TEST(DesignMachine, AQuickLookBeginsWhereTheLastChoiceWasWorst) {
  Result failed = with_check(1.5);
  failed.tables = {{.name = "load_path",
                    .title = "",
                    .columns = {{.name = "x", .unit = si::m}, {.name = "skyline.T_max", .unit = si::N}},
                    .rows = {{135.0, 60e3}, {173.0, 90e3}, {230.0, 70e3}}}};
  const Result passed = with_check(0.5);
  std::vector<const Result*> answers;
  std::vector<std::size_t> analyses;
  std::vector<double> from, to;
  const auto task = task_of(skyline(), [&](const MachineDeck& deck, RunDepth depth) {
    EXPECT_EQ(depth, RunDepth::checks);
    analyses.push_back(deck.analyses.size());
    from.push_back(deck.analyses.at(1).load_path->from);
    to.push_back(deck.analyses.at(1).load_path->to);
    const Result* r = answers.front();
    answers.erase(answers.begin());
    return *r;
  });
  const design::DesignPlace place{.choice = {0}, .values = {}};
  answers = {&failed};
  EXPECT_FALSE(task.run(place, Depth::quick, {}).result.checks.at(0).passes);
  EXPECT_THAT(from, ElementsAre(135)) << "the whole path, as nothing is known yet";
  answers = {&failed};
  EXPECT_TRUE(std::isnan(task.run(place, Depth::quick, {}).tension)) << "the one place has told enough";
  EXPECT_THAT(from, ElementsAre(135, 173));
  EXPECT_THAT(to, ElementsAre(230, 173));
  answers = {&passed, &passed};
  EXPECT_TRUE(task.run(place, Depth::quick, {}).result.checks.at(0).passes);
  EXPECT_THAT(from, ElementsAre(135, 173, 173, 135)) << "what passes has passed the whole";
  EXPECT_THAT(analyses, ElementsAre(3, 2, 2, 3)) << "one place has no payload";
}

// A probe that can't answer, or has not made what is asked, says nothing of the whole.
TEST(DesignMachine, OnlyACheckThatFailsEndsAQuickLook) {
  Result failed = with_check(1.5);
  failed.tables = {{.name = "load_path",
                    .title = "",
                    .columns = {{.name = "x", .unit = si::m}, {.name = "skyline.T_max", .unit = si::N}},
                    .rows = {{135.0, 60e3}, {173.0, 90e3}, {230.0, 70e3}}}};
  Result unmade = with_check(0.5);
  unmade.unmade = {"a motion is asked"};
  Result none;
  none.status = Status::bad_deck;
  const Result passed = with_check(0.5);
  for (const Result& probe : {unmade, none}) {
    std::vector<const Result*> answers = {&failed, &probe, &passed};
    const auto task = task_of(skyline(), [&](const MachineDeck&, RunDepth) {
      const Result* r = answers.front();
      answers.erase(answers.begin());
      return *r;
    });
    const design::DesignPlace place{.choice = {0}, .values = {}};
    task.run(place, Depth::quick, {});
    const Result r = task.run(place, Depth::quick, {}).result;
    EXPECT_TRUE(answers.empty()) << "the whole has been asked";
    EXPECT_EQ(r.status, Status::ok);
    EXPECT_TRUE(r.unmade.empty());
  }
}

// A mast combines the equilibrium and the payload's states by their names: no deck has one without the other.
TEST(DesignMachine, AQuickLookKeepsWhatMastsCombine) {
  Result failed = with_check(1.5);
  failed.tables = {{.name = "load_path",
                    .title = "",
                    .columns = {{.name = "x", .unit = si::m}, {.name = "skyline.T_max", .unit = si::N}},
                    .rows = {{135.0, 60e3}, {173.0, 90e3}, {230.0, 70e3}}}};
  ReadMachine own = skyline();
  const auto deck = std::make_shared<MachineDeck>(*own.deck);
  checks::MastCheckRequest mast;
  mast.combinations = {{.name = "work", .terms = {{.name = "payload", .factor = 1.5}}}};
  deck->checks->masts = {mast};
  own.deck = deck;
  std::vector<std::size_t> analyses;
  const auto task = task_of(own, [&](const MachineDeck& one, RunDepth) {
    analyses.push_back(one.analyses.size());
    return failed;
  });
  const design::DesignPlace place{.choice = {0}, .values = {}};
  task.run(place, Depth::quick, {});
  task.run(place, Depth::quick, {});
  EXPECT_THAT(analyses, ElementsAre(3, 3));
}

// At -40 degC the rope of 15 degC is 12e-6 55 shorter than at 15 degC; without a case nothing is said of its reference.
TEST(DesignMachine, ALoadCaseOfAnotherTemperatureKeepsTheLengthsOfTheDeck) {
  const std::string design = "design: {ropes: {" + line + "}, cases: {cold: {temperature: -40 degC}, now: {}}}\n";
  const std::string plain = deck_with(checks + design);
  const std::string head = "machine:\n";
  std::string warm = plain;
  warm.insert(warm.find(head) + head.size(), "  temperature: 15 degC\n");
  const ReadMachine own = read(warm);
  const MachineDeck cold = with_design(*own.deck, own.space, {.choice = {0}, .values = {}}, &own.space.cases.at(0));
  ASSERT_EQ(cold.machine.ropes.size(), 2U);
  for (const auto& rope : cold.machine.ropes) EXPECT_DOUBLE_EQ(rope.reference_temperature.value(), 288.15) << rope.name;
  const MachineDeck now = with_design(*own.deck, own.space, {.choice = {0}, .values = {}}, &own.space.cases.at(1));
  EXPECT_FALSE(now.machine.ropes.at(0).reference_temperature.has_value());
  EXPECT_THAT(mistakes_of(plain), HasSubstr("the length of rope 'line' holds at no temperature that is reported"));
}

// As a rope of the catalogue has it without a stiffness: the middle of 95 to 120 GPa (data/rules/rope_modulus.csv).
TEST(DesignMachine, AChosenRopeHasTheModulusOfItsConstruction) {
  const ReadMachine own =
      read(deck_with(checks + "design: {ropes: {line: {construction: 6x36, core: IWRC, grade: 1960 MPa}}}\n"));
  const MachineDeck made = with_design(*own.deck, own.space, {.choice = {3}, .values = {}});
  EXPECT_DOUBLE_EQ(made.machine.ropes.at(0).stiffness.value(), 107.5e9 * own.space.ropes.at(0).rows[3].area);
  EXPECT_THAT(mistakes_of(deck_with(checks + "design: {ropes: {line: {}}}\n")), testing::IsEmpty())
      << "one is known for every rope of the catalogue";
}

TEST(DesignMachine, AReportHasWhatIsDisregardedAndNamesTheRope) {
  std::vector<RunDepth> depths;
  const ReadMachine own = skyline();
  const auto task = task_of(own, [&](const MachineDeck& deck, RunDepth depth) {
    depths.push_back(depth);
    Result r = with_check(2, "car.sway");
    r.given = given_of(MachineDeck::describe(), &deck);
    return r;
  });
  const design::DesignPlace place{.choice = {1}, .values = {}};
  EXPECT_TRUE(task.run(place, Depth::checks, {}).result.checks.empty()) << "it does not bind the design";
  const Result r = task.run(place, Depth::report, {}).result;
  EXPECT_THAT(depths, ElementsAre(RunDepth::checks, RunDepth::report));
  EXPECT_EQ(r.checks.size(), 1U);
  std::vector<std::string> of_rope;
  for (const Given& g : r.given) {
    if (g.key.starts_with("machine.ropes.mainline.")) of_rope.push_back(g.key);
  }
  ASSERT_GT(of_rope.size(), 1U);
  EXPECT_EQ(of_rope[0], "machine.ropes.mainline.rope") << "before the figures that it brings";
  const auto row = std::find_if(r.given.begin(), r.given.end(), [](const Given& g) { return g.chosen; });
  ASSERT_NE(row, r.given.end());
  EXPECT_EQ(row->text, own.space.ropes.at(0).rows[1].id);
}

/// Two ropes of the length L hold 3 t from points 6 m apart: T = m g L/(2 sqrt(L^2 - 9 m^2)). A thicker rope bears more
/// and may be shorter. 11 mm at 3.507 m, with its stretch, are lighter in all than 10 mm at 3.860 m.
TEST(DesignMachine, AThickerRopeMayBeLighterByItsLength) {
  const Result r = taut_test::run_text(R"(taut: 1
machine:
  points: {p: [0 m, 0 m, 20 m], q: [6 m, 0 m, 20 m]}
  ropes: {sl: {mass: 1 kg/m, breaking_force: 100 kN, stiffness: 10 MN, diameter: 14 mm}, tag: {}}
  bodies: {hook: {mass: 0 kg, at: [3 m, 0 m, 16 m], free: [x, z]}}
  reevings:
    - {rope: sl, path: [{anchor: p}, {anchor: hook}], length: 5 m}
    - {rope: tag, path: [{anchor: q}, {anchor: hook}], length: 5 m}
  loads: [{at: hook, mass: 3 t}]
analyses: [equilibrium: {}]
checks: {ropes: {sl: {safety_factor: 3, running: stands}, tag: {safety_factor: 3, running: stands}}}
design:
  seek: lightest
  unknowns: {L: {parameter: 'reevings[0].length', along_with: ['reevings[1].length'], from: 3.2 m, to: 8 m}}
  ropes: {tag: {construction: 6x36, core: IWRC, grade: 1960 MPa, most_diameter: 16 mm}}
)");
  ASSERT_NE(r.find_value("design_L"), nullptr) << r.message << to_text(r.errors);
  EXPECT_NEAR(r.find_value("design_L")->value, 3.507, 1e-3);
  EXPECT_NEAR(r.find_value("design_cost")->value, 5.242, 1e-3);
}

}  // namespace taut::app::design_machine_test
