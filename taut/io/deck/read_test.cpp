#include "taut/io/deck/read.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "taut/io/deck/document.hpp"
#include "taut/io/deck/sample_test.hpp"

namespace taut::io::read_test {

struct Reading {
  bool good = false;
  Sample sample;
  std::string text;
};

Reading read_sample(const std::string& text) {
  const auto d = parse(text, "deck.yaml");
  if (!d) return {.good = false, .sample = {}, .text = to_text(d.error())};
  Reading reported;
  Diagnostics mistakes = d->mistakes;
  reported.good = read(d->root, Sample::describe(), &reported.sample, "sample", mistakes);
  reported.text = to_text(mistakes);
  return reported;
}

TEST(Read, FillsEveryKindOfField) {
  const Reading t = read_sample(
      "span: 0.2 km\n"
      "positions: [1 m, \"50 cm\"]\n"
      "friction: 12 %\n"
      "stiffness: .inf\n"
      "uphill: true\n"
      "direction: outhaul\n"
      "note: 12\n"
      "sheaves: 3\n"
      "rope: {diameter: 12 mm}\n"
      "second_rope: {diameter: 10 mm, strength: 63 kN, construction: 8x19}\n"
      "cases:\n"
      "  - {name: a, angle: 30 deg}\n"
      "  - {name: b, falls: 8}\n");
  ASSERT_TRUE(t.good) << t.text;
  EXPECT_DOUBLE_EQ(t.sample.span, 200);
  EXPECT_EQ(t.sample.positions, (std::vector<double>{1, 0.5}));
  EXPECT_DOUBLE_EQ(t.sample.friction, 0.12);
  EXPECT_TRUE(std::isinf(t.sample.stiffness));
  EXPECT_TRUE(t.sample.uphill);
  EXPECT_EQ(t.sample.direction, Direction::outhaul);
  EXPECT_EQ(t.sample.note, "12");
  EXPECT_EQ(t.sample.sheaves, 3);
  EXPECT_DOUBLE_EQ(t.sample.rope.diameter, 0.012);
  ASSERT_TRUE(t.sample.second_rope.has_value());
  EXPECT_DOUBLE_EQ(t.sample.second_rope->strength.value(), 63000);
  ASSERT_EQ(t.sample.cases.size(), 2U);
  EXPECT_DOUBLE_EQ(t.sample.cases[0].angle, M_PI / 6);
  EXPECT_EQ(t.sample.cases[1].falls, 8);
}

TEST(Read, KeepsDefaultsAndMakesAListOfOne) {
  const Reading t = read_sample("span: 1 m\nrope: {diameter: 1 mm}\n");
  ASSERT_TRUE(t.good) << t.text;
  EXPECT_DOUBLE_EQ(t.sample.friction, 0.1);
  EXPECT_EQ(t.sample.positions, std::vector<double>{1.0});
  EXPECT_FALSE(t.sample.second_rope.has_value());
  EXPECT_EQ(read_sample("span: 1 m\npositions: 7 m\n").sample.positions, std::vector<double>{7.0});
}

TEST(Read, TellsEachMistakeAtItsPlaceWithWhatToDo) {
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"spann: 1 m",
       "deck.yaml:1:1: error: 'spann' is not a field of sample; did you mean 'span'?\n  spann: 1 m\n  ^~~~~\n"},
      {"rope: {diamter: 1 mm}", "deck.yaml:1:8: error: 'diamter' is not a field of rope; did you mean 'diameter'?"},
      {"colour: red", "'colour' is not a field of sample; it has span, positions"},
      {"note: x", "deck.yaml:1:1: error: sample lacks 'span' (horizontal span); write 'span: 1 m'"},
      {"rope: {}", "deck.yaml:1:7: error: rope lacks 'diameter' (nominal diameter); write 'diameter: 1 mm'"},
      {"rope:", "deck.yaml:1:1: error: rope lacks 'diameter'"},
      {"span: 200", "deck.yaml:1:7: error: span: a length needs its unit, such as '1 m'"},
      {"span: 200 kN", "deck.yaml:1:11: error: span: 'kN' is a unit of force; a length"},
      {"span: '200 kN'", "deck.yaml:1:12: error: span: 'kN'"},
      {"span: 0 m", "deck.yaml:1:7: error: span: must be above 0 m, not 0 m\n  span: 0 m\n        ^~~\n"},
      {"span: .inf", "a finite number is expected"},
      {"span: .nan", "does not begin with a number"},
      {"span: 1e999 m", "too large or too small"},
      {"span: {a: 1}", "deck.yaml:1:7: error: span: a length such as '1 m' is expected, not a map"},
      {"span: [1 m]", "deck.yaml:1:7: error: span: a length such as '1 m' is expected, not a list"},
      {"span:", "deck.yaml:1:1: error: span: there is no value"},
      {"span: ~", "deck.yaml:1:7: error: span: there is no value"},
      {"positions: []", "positions: the list is empty"},
      {"positions: [1 m, 2]", "deck.yaml:1:18: error: positions: a length needs its unit"},
      {"positions: [1 m, [2 m]]", "is expected, not a list"},
      {"positions: [1 m,, 2 m]", "there is no value"},
      {"positions: [1 m, -2 m]", "must be at least 0 m, not -2 m"},
      {"friction: 1", "friction: must be at least 0 and below 1, not 1"},
      {"friction: 0.1 m", "a plain number is expected"},
      {"friction: abc", "does not begin with a number"},
      {"stiffness: -.inf", "must be above 0 MN/m"},
      {"uphill: yes", "'yes' is neither true nor false"},
      {"uphill: 'true'", "leave the quotes away"},
      {"direction: inhual", "'inhual' is not a choice; did you mean 'inhaul'?"},
      {"direction: sideways", "write inhaul, outhaul"},
      {"direction: [inhaul]", "one of inhaul, outhaul is expected, not a list"},
      {"sheaves: 2.5", "a whole number is expected, not 2.5"},
      {"sheaves: 21", "must be at least 0 and at most 20, not 21"},
      {"sheaves: 3 m", "not a plain number"},
      {"sheaves: 1e12", "a whole number is expected"},
      {"note: {a: b}", "a text is expected, not a map"},
      {"rope: 12 mm", "rope: a map of fields is expected"},
      {"rope: [1]", "rope: a map of fields is expected"},
      {"cases: {name: a}", "a list is expected, not a map: begin each entry with '- '"},
      {"cases: a", "a list is expected, not a text"},
      {"cases: []", "the list is empty"},
      {"cases: [1]", "cases[0]: a map of fields is expected"},
      {"cases: [{name: ''}]", "name: the text is empty"},
      {"cases: [{name: a, angle: 90 deg}]", "must be at least 0 deg and at most 85 deg, not 90 deg"},
      {"cases: [{name: a}, {angle: 1 deg}]", "deck.yaml:1:20: error: cases[1] lacks 'name'"},
  };
  for (const auto& [text, expected] : rows) {
    const Reading t = read_sample(text);
    EXPECT_FALSE(t.good) << text;
    EXPECT_NE(t.text.find(expected), std::string::npos) << text << "\n-> " << t.text;
  }
}

struct ReadMachine {
  bool good = false;
  SampleMachine machine;
  std::string text;
};

ReadMachine read_machine(const std::string& text) {
  const auto d = parse(text, "deck.yaml");
  if (!d) return {.good = false, .machine = {}, .text = to_text(d.error())};
  ReadMachine reported;
  Diagnostics mistakes = d->mistakes;
  reported.good = read(d->root, SampleMachine::describe(), &reported.machine, "machine", mistakes);
  reported.text = to_text(mistakes);
  return reported;
}

TEST(Read, NamedStructsVectorsAndShortForms) {
  const ReadMachine t = read_machine(
      "pins:\n"
      "  head: [1 m, -2 m, 50 cm]\n"
      "  boom.top: {at: [0 m, 0 m, 1 km], colour: blue, free: [x, z]}\n"
      "path: [{over: head}, {anchor: boom.top, axis: [0, 1, 0]}]\n"
      "motion: out\n");
  ASSERT_TRUE(t.good) << t.text;
  ASSERT_EQ(t.machine.pins.size(), 2U);
  EXPECT_EQ(t.machine.pins[0].name, "head");
  EXPECT_EQ(t.machine.pins[0].at, (Triple{1, -2, 0.5}));
  EXPECT_EQ(t.machine.pins[0].colour, "red");
  EXPECT_EQ(t.machine.pins[1].name, "boom.top");
  EXPECT_EQ(t.machine.pins[1].free, (std::vector<std::string>{"x", "z"}));
  EXPECT_EQ(t.machine.path[0].over, "head");
  EXPECT_FALSE(t.machine.path[0].axis.has_value());
  EXPECT_EQ(t.machine.path[1].axis, (Triple{0, 1, 0}));
  EXPECT_FALSE(t.machine.path[1].tilted.has_value());
  const ReadMachine tilted = read_machine("path: [{over: head, axis: {tilt: 30 deg}}]\n");
  ASSERT_TRUE(tilted.good) << tilted.text;
  EXPECT_FALSE(tilted.machine.path[0].axis.has_value());
  EXPECT_NEAR(tilted.machine.path[0].tilted->tilt, std::numbers::pi / 6, 1e-15);
  ASSERT_EQ(t.machine.motion.size(), 1U);
  EXPECT_EQ(t.machine.motion[0].name, "");
  EXPECT_EQ(t.machine.motion[0].sense, "out");
  const ReadMachine each = read_machine("motion: {head: in, foot: {sense: out}}\n");
  ASSERT_TRUE(each.good) << each.text;
  EXPECT_EQ(each.machine.motion[1].name, "foot");
  EXPECT_EQ(each.machine.motion[1].sense, "out");
}

TEST(Read, TellsMistakesOfNamesVectorsAndShortForms) {
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"pins: {head: [1 m, 2 m]}",
       "deck.yaml:1:14: error: at: three components along x, y, z are expected, such as [1 m, 1 m, 1 m], not 2 of "
       "them"},
      {"pins: {head: [1 m, 2 m, 3]}", "deck.yaml:1:25: error: at: a length needs its unit, such as '1 m'"},
      {"pins: {head: [1 m, 2 m, 1001 m]}", "at: must be at most 1000 m, not 1001 m"},
      {"pins: {head: 3 m}", "not a text"},
      {"pins: {head: {}}", "pins.head lacks 'at' (place); write 'at: [1 m, 1 m, 1 m]'"},
      {"pins: {head: }", "deck.yaml:1:8: error: pins.head lacks 'at'"},
      {"pins: {head: {at: [0 m, 0 m, 0 m], coluor: red}}",
       "'coluor' is not a field of pins.head; did you mean 'colour'?"},
      {"pins: [[0 m, 0 m, 0 m]]", "pins: a map of names is expected ('name: ...' on each line), not a list"},
      {"pins: {head: {at: [0 m, 0 m, 0 m], free: [x, rz]}}", "free: 'rz' is not a choice"},
      {"path: [{over: a, axis: 3}]", "such as [1, 1, 1] (or a map of tilt), not a text"},
      {"path: [{over: a, axis: {tlit: 3 deg, tilt: 2 deg}}]", "'tlit' is not a field of axis; did you mean 'tilt'?"},
      {"path: [{over: a, axis: {}}]", "axis lacks 'tilt'"},
      {"path: [{axis: [0, 1, 0]}]", "path[0] needs one of over, anchor"},
      {"path: [{over: a, anchor: b}]",
       "deck.yaml:1:18: error: anchor: path[0] has 'over' already; give one of the two"},
      {"path: [{spring: a}]", "deck.yaml:1:9: error: 'spring' of path[0] is not computed yet: springs come with"},
      {"signals: {}", "'signals' of machine is not computed yet: signals come with the dynamics"},
      {"motion: [out]", "motion: a map of names is expected"},
  };
  for (const auto& [text, expected] : rows) {
    const ReadMachine t = read_machine(text);
    EXPECT_FALSE(t.good) << text;
    EXPECT_NE(t.text.find(expected), std::string::npos) << text << "\n-> " << t.text;
    EXPECT_EQ(t.text.find("error:"), t.text.rfind("error:")) << text << "\n-> " << t.text;
  }
}

TEST(Read, PlacesComplaintsAtNamesWithDots) {
  const auto d = parse("pins:\n  boom: [0 m, 0 m, 1 m]\n  boom.top: {at: [0 m, 0 m, 2 m]}\n", "deck.yaml");
  ASSERT_TRUE(d);
  Diagnostics mistakes;
  place(d->root,
        {{.path = "pins.boom.top.at", .message = "m1"},
         {.path = "pins.boom[1]", .message = "m2"},
         {.path = "pins.boom.tip", .message = "m3"}},
        mistakes);
  ASSERT_EQ(mistakes.size(), 3U);
  EXPECT_EQ(mistakes[0].place, (Place{3, 18}));
  EXPECT_EQ(mistakes[1].place, (Place{2, 15}));
  EXPECT_EQ(mistakes[2].place, (Place{2, 9}));
}

TEST(Read, TellsAllMistakesAtOnce) {
  const auto d = parse("span: 3\nfriction: 2\nrope: {diameter: 1 kN, x: 1}\n", "deck.yaml");
  ASSERT_TRUE(d);
  Sample s;
  Diagnostics mistakes;
  EXPECT_FALSE(read(d->root, Sample::describe(), &s, "sample", mistakes));
  EXPECT_EQ(mistakes.size(), 4U) << to_text(mistakes);
}

TEST(Read, StopsAtAHundredMistakesSoonEnough) {
  std::string text = "positions:\n";
  for (int i = 0; i < 100000; ++i) text += "- 1\n";
  const auto d = parse(text, "deck.yaml");
  ASSERT_TRUE(d);
  Sample s;
  Diagnostics mistakes;
  EXPECT_FALSE(read(d->root, Sample::describe(), &s, "sample", mistakes));
  EXPECT_EQ(mistakes.size(), most_mistakes);
  EXPECT_NE(mistakes.back().message.find("not shown"), std::string::npos);
  EXPECT_FALSE(read(d->root, Sample::describe(), &s, "sample", mistakes)) << "also when there is no room for more";
}

TEST(Read, PlacesComplaintsAtTheirPathOrTheNearestAboveIt) {
  const auto d =
      parse("span: 1 m\nrope:\n  diameter: 2 mm\ncases:\n  - name: a\n  - name: b\n    falls: 3\n", "deck.yaml");
  ASSERT_TRUE(d);
  Diagnostics mistakes;
  place(d->root,
        {{.path = "rope.diameter", .message = "m1"},
         {.path = "cases[1].falls", .message = "m2"},
         {.path = "cases[1].angle", .message = "m3"},
         {.path = "second_rope.strength", .message = "m4"},
         {.path = "", .message = "m5"},
         {.path = "cases[7].falls", .message = "m6"},
         {.path = "..", .message = "m7"},
         {.path = "span[0]", .message = "m8"}},
        mistakes);
  ASSERT_EQ(mistakes.size(), 8U);
  EXPECT_EQ(mistakes[0].place, (Place{3, 13}));
  EXPECT_EQ(mistakes[0].message, "rope.diameter: m1");
  EXPECT_EQ(mistakes[1].place, (Place{7, 12}));
  EXPECT_EQ(mistakes[2].place, (Place{6, 5})) << "its map, as the key is not there";
  EXPECT_EQ(mistakes[3].place, (Place{1, 1}));
  EXPECT_EQ(mistakes[4].message, "m5");
  EXPECT_EQ(mistakes[5].place, (Place{5, 3})) << "the list";
  EXPECT_EQ(mistakes[7].place, (Place{1, 7})) << "one value stands for a list of one";
}

TEST(Read, ExamplesAreAllowedByTheirOwnRange) {
  for (const Description* d : {&Sample::describe(), &SampleRope::describe(), &SampleCase::describe()}) {
    for (const Field& f : d->fields) {
      if (f.kind == FieldKind::record || f.kind == FieldKind::records || f.kind == FieldKind::text) continue;
      const auto node = parse(f.key + ": " + example_value(f), "d");
      ASSERT_TRUE(node);
      Diagnostics mistakes;
      const auto object = d->make_default();
      read(node->root, *d, object.get(), "x", mistakes);
      for (const Diagnostic& m : mistakes) EXPECT_NE(m.message.find("lacks"), std::string::npos) << m.message;
    }
  }
}

}  // namespace taut::io::read_test
