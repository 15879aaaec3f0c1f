#include "taut/report/tables/inputs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "taut/report/tables/given.hpp"

namespace taut::report::inputs_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

Given number(const std::string& key, double x, const Unit& unit = si::one) {
  return {.key = key, .symbol = "x", .words = "words of " + key, .unit = unit, .numbers = {x}, .text = ""};
}
Given numbers(const std::string& key, std::vector<double> x) {
  return {.key = key, .symbol = "", .words = "", .unit = si::m, .numbers = std::move(x), .text = ""};
}
Given words(const std::string& key, const std::string& text) {
  return {.key = key, .symbol = "", .words = "", .unit = si::one, .numbers = {}, .text = text};
}
Given by_default(Given g) {
  g.is_default = true;
  return g;
}

std::vector<std::string> heads(const InputTable& t) {
  std::vector<std::string> all;
  for (const InputColumn& c : t.columns) all.push_back(c.name);
  return all;
}
std::vector<std::string> texts(const InputTable& t, std::size_t row) {
  std::vector<std::string> all;
  for (const InputCell& c : t.rows[row]) all.push_back(c.text);
  return all;
}

TEST(Inputs, KeysNameTheListThePartAndTheField) {
  const auto place = [](const char* key) {
    const InputPlace p = place_of(key);
    return std::vector<std::string>{p.list, p.record, p.field};
  };
  EXPECT_THAT(place("machine.points.stump.at"), ElementsAre("machine.points", "stump", "at"));
  EXPECT_THAT(place("machine.reevings[1].path[0].over"), ElementsAre("machine.reevings", "2", "path[0].over"));
  EXPECT_THAT(place("checks.ropes.saw.duty[0].load"), ElementsAre("checks.ropes", "saw", "duty[0].load"));
  EXPECT_THAT(place("cases[3].falls"), ElementsAre("cases", "4", "falls"));
  for (const char* key : {"span", "span.load", "machine.gravity", "machine.terrain.x", "a[", "a[]", "[0].x", "a[x].y",
                          "a[-1].y", "a[0]", "a].[0", ""}) {
    EXPECT_EQ(place_of(key).list, "") << key;
  }
}

TEST(Inputs, ANameMayHaveDots) {
  const auto tables =
      input_tables({numbers("machine.points.s1.rear.at", {0, 1, 2}), words("machine.points.s1.rear.body", "s1"),
                    number("machine.bodies.s1.mass", 4), number("machine.bodies.s1.motion.x", 5)},
                   {});
  ASSERT_EQ(tables.size(), 2U);
  EXPECT_THAT(texts(tables[0], 0), ElementsAre("s1.rear", "0", "1", "2", "s1"));
  EXPECT_THAT(texts(tables[1], 0), ElementsAre("s1", "4", "motion: {x: 5}"));
}

TEST(Inputs, PlacesHaveColumnsXYZ) {
  const auto tables =
      input_tables({numbers("machine.points.a.at", {0, 1, 2}), numbers("machine.points.b.at", {3, 4, 5})}, {});
  ASSERT_EQ(tables.size(), 1U);
  EXPECT_EQ(tables[0].title, "Points");
  EXPECT_THAT(heads(tables[0]), ElementsAre("", "x", "y", "z"));
  EXPECT_THAT(texts(tables[0], 1), ElementsAre("b", "3", "4", "5"));
  EXPECT_EQ(tables[0].columns[2].unit, "m");
}

TEST(Inputs, WhatFewPartsGiveStandsInTheLastColumn) {
  const auto tables = input_tables(
      {number("machine.ropes.a.mass", 1), number("machine.ropes.b.mass", 2), number("machine.ropes.c.mass", 3),
       number("machine.ropes.c.diameter", 0.02, si::m), number("machine.ropes.c.law.knee", 4)},
      {});
  ASSERT_EQ(tables.size(), 1U);
  EXPECT_THAT(heads(tables[0]), ElementsAre("", "mass", "also"));
  EXPECT_THAT(texts(tables[0], 0), ElementsAre("a", "1", ""));
  EXPECT_THAT(texts(tables[0], 2), ElementsAre("c", "3", "diameter: 0.02 m, law: {knee: 4}"));
}

TEST(Inputs, AnalysesAreLinesInTheDecksSpelling) {
  const auto tables = input_tables(
      {words("analyses[0].equilibrium.motion.sense", "in"), by_default(words("analyses[0].equilibrium.judge", "true")),
       number("analyses[1].load_path.from", 5, si::m), words("analyses[1].load_path.limits[0].rope", "a"),
       words("analyses[1].load_path.limits[1].rope", "b"), by_default(words("analyses[2].modes.judge", "true"))},
      {});
  ASSERT_EQ(tables.size(), 1U);
  EXPECT_THAT(heads(tables[0]), ElementsAre("", "as given"));
  EXPECT_EQ(tables[0].rows[0][1].text, "equilibrium: {motion: {sense: in}}");
  EXPECT_EQ(tables[0].rows[1][1].text, "load_path: {from: 5 m, limits: [{rope: a}, {rope: b}]}");
  EXPECT_EQ(tables[0].rows[2][1].text, "modes: {}");  // given, though nothing in it is
}

TEST(Inputs, DefaultsAreSaidOnceWithTheirParts) {
  const std::vector<Given> given{
      number("machine.sheaves.a.diameter", 1), by_default(number("machine.sheaves.a.drag", 0)),
      by_default(number("machine.sheaves.b.drag", 0)), by_default(number("machine.gravity", 9.81))};
  const auto defaults = input_defaults(given, {});
  ASSERT_EQ(defaults.size(), 2U);
  EXPECT_EQ(defaults[0].key, "machine.sheaves.*.drag");
  EXPECT_EQ(defaults[0].parts, "a, b");
  EXPECT_EQ(defaults[1].parts, "");
  Result r;
  r.given = given;
  EXPECT_THAT(given_html(r), Not(HasSubstr("drag")));
  EXPECT_THAT(defaults_html(r), HasSubstr("machine.sheaves.*.drag"));
}

TEST(Inputs, WhatADesignHasChosenIsMarked) {
  Result r;
  Given chosen = by_default(number("machine.ropes.a.diameter", 0.014, si::m));
  chosen.chosen = true;
  r.given = {chosen};
  EXPECT_THAT(given_html(r), HasSubstr("0.014 <em class=\"chosen\">chosen</em>"));
  EXPECT_EQ(defaults_html(r), "");
}

TEST(Inputs, AProfileIsWholeUpTo40Points) {
  std::vector<double> x(40), z(40);
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = 1000 + static_cast<double>(i);
    z[i] = 2000 + static_cast<double>(i);
  }
  Result r;
  r.given = {numbers("machine.terrain.x", x), numbers("machine.terrain.z", z)};
  const std::string html = given_html(r);
  for (const int number : {1000, 1019, 1039, 2000, 2039}) EXPECT_THAT(html, HasSubstr(std::to_string(number)));
  x.push_back(1040);
  z.push_back(2040);
  r.given = {numbers("machine.terrain.x", x), numbers("machine.terrain.z", z)};
  const std::string longer = given_html(r);
  EXPECT_THAT(longer, HasSubstr("41 numbers, 1000 … 1040, fingerprint "));
  EXPECT_THAT(longer, Not(HasSubstr("1019")));
  const std::string before = input_text(r.given[0], {});
  r.given[0].numbers[20] += 1e-9;
  EXPECT_NE(input_text(r.given[0], {}), before);
}

TEST(Inputs, EveryGivenValueIsOnThePage) {
  Result r;
  r.given = {number("span", 111), number("cases[0].a", 222), number("cases[1].a", 333), number("cases[1].b.c", 444)};
  for (const char* text : {"111", "222", "333", "444"}) EXPECT_THAT(given_html(r), HasSubstr(text));
}

}  // namespace taut::report::inputs_test
