#include "taut/app/design/design_space.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "taut/io/deck/document.hpp"
#include "taut/io/deck/read.hpp"
#include "test/support/scratch_folder.hpp"

namespace taut::app::design_space_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// What a design may change here.
struct Numbers {
  double length = 20, other_length = 5, force = 1e3;  // m, m, N
  std::optional<double> sag;                          // m
  static const Description& describe() {
    static const Description d = Describe<Numbers>()
                                     .field(&Numbers::length, "length", "", si::m, "")
                                     .above(0)
                                     .field(&Numbers::other_length, "other_length", "", si::m, "")
                                     .at_least(-20)
                                     .field(&Numbers::force, "force", "", si::N, "")
                                     .field(&Numbers::sag, "sag", "", si::m, "");
    return d;
  }
};

FindParameter parameters_of(Numbers& numbers) {
  return [&numbers](const std::string& path) { return study::find_parameter(Numbers::describe(), &numbers, path); };
}

struct Made {
  design::DesignSpace space;
  std::string mistakes;
};

/// The space of a block `design: {...}` in a deck of that name.
Made space_of(const std::string& block, const std::string& name = "deck.yaml") {
  Made made;
  const auto document = io::parse("design: {" + block + "}\n", name);
  if (!document) return {.space = {}, .mistakes = to_text(document.error())};
  design::DesignRequest request;
  Diagnostics mistakes;
  io::read(*document->root.find("design"), design::DesignRequest::describe(), &request, "design", mistakes);
  Numbers numbers;
  const DesignParts parts{.owner = "the machine",
                          .ropes = {"skyline", "mainline"},
                          .tensions = {"skyline", "mainline"},
                          .sections = {},
                          .parameter = parameters_of(numbers),
                          .modulus = [](const std::string&, const catalogue::RopeRow& row) -> std::optional<double> {
                            return row.core == "IWRC" ? std::optional(107.5e9) : std::nullopt;
                          }};
  made.space = design_space(document->root, request, parts, mistakes);
  made.mistakes = to_text(mistakes);
  return made;
}

std::vector<double> grid_of(const std::string& range) {
  const Made made = space_of("unknowns: {l: {parameter: length, " + range + "}}");
  EXPECT_THAT(made.mistakes, IsEmpty()) << range;
  return made.space.unknowns.at(0).values;
}

TEST(DesignSpace, AnUnknownIsTriedAtEqualStepsAndAtItsStart) {
  EXPECT_THAT(grid_of("from: 2 m, to: 10 m"), ElementsAre(2, 4, 6, 8, 10)) << "four steps where none are named";
  EXPECT_THAT(grid_of("from: 1000 cm, to: 2 m, steps: 2"), ElementsAre(10, 6, 2)) << "from one end to the other";
  EXPECT_THAT(grid_of("from: 2 m, to: 10 m, start: 7 m"), ElementsAre(7));
  EXPECT_THAT(grid_of("from: 10 m, to: 2 m, start: 7 m, steps: 2"), ElementsAre(10, 7, 6, 2));
  EXPECT_THAT(grid_of("from: 2 m, to: 10 m, start: 6 m, steps: 2"), ElementsAre(2, 6, 10)) << "not tried twice";
  const Made falling = space_of("unknowns: {l: {parameter: length, from: 10 m, to: 2 m}}");
  EXPECT_EQ(falling.space.unknowns.at(0).low, 2);
  EXPECT_EQ(falling.space.unknowns.at(0).high, 10);
}

TEST(DesignSpace, MistakesHaveTheirPathInTheDeck) {
  const auto expect = [](const std::string& block, const std::string& path, const std::string& words) {
    const std::string mistakes = space_of(block).mistakes;
    EXPECT_THAT(mistakes, HasSubstr("deck.yaml:1:")) << block;
    EXPECT_THAT(mistakes, HasSubstr(path + ": ")) << block;
    EXPECT_THAT(mistakes, HasSubstr(words)) << block;
  };
  const std::string range = ", from: 2 m, to: 10 m";
  expect("seek: lightest", "design", "says nothing that is free");
  expect("unknowns: {l: {parameter: lenght" + range + "}}", "design.unknowns.l.parameter", "did you mean 'length'");
  expect("unknowns: {l: {parameter: length, from: 2 kN, to: 10 m}}", "design.unknowns.l.from", "");
  expect("unknowns: {l: {parameter: length, from: 3 m, to: 300 cm}}", "design.unknowns.l.to", "the same");
  expect("unknowns: {l: {parameter: length, from: 0 m, to: 3 m}}", "design.unknowns.l.from", "");
  expect("unknowns: {l: {parameter: length, start: 11 m" + range + "}}", "design.unknowns.l.start",
         "11 m is not between 2 m and 10 m");
  expect("unknowns: {cost: {parameter: length" + range + "}}", "design.unknowns.cost", "another name");
  expect("unknowns: {l: {parameter: length, along_with: [other_length, force]" + range + "}}",
         "design.unknowns.l.along_with[1]", "no quantity of the same kind");
  expect("seek: cheapest, unknowns: {l: {parameter: length" + range + "}}", "design.seek", "'price'");
  expect("of: skyline, unknowns: {l: {parameter: length" + range + "}}", "design.of", "least_tension");
  expect("seek: least_tension, of: skylin, unknowns: {l: {parameter: length" + range + "}}", "design.of",
         "did you mean 'skyline'");
  expect("ropes: {skylin: {}}", "design.ropes.skylin", "did you mean 'skyline'");
  expect("ropes: {skyline: {least_diameter: 3 m}}", "design.ropes.skyline", "drop a condition");
  // 28 * 28 * 28 = 21952 places
  const std::string steps = range + ", steps: 27}";
  expect("unknowns: {a: {parameter: length" + steps + ", b: {parameter: other_length" + steps + ", c: {parameter: sag" +
             steps + "}",
         "design.unknowns", "2.2e+04 places");
}

TEST(DesignSpace, ALoadCaseSetsNumbersThatAreNotFree) {
  const std::string free = "unknowns: {l: {parameter: length, along_with: [other_length], from: 2 m, to: 10 m}}, ";
  const Made made = space_of(free + "cases: {full: {force: 2 kN, sag: 30 cm}, empty: {}}");
  ASSERT_THAT(made.mistakes, IsEmpty());
  ASSERT_EQ(made.space.cases.size(), 2U);
  EXPECT_EQ(made.space.cases[0].name, "full");
  EXPECT_THAT(made.space.cases[0].settings, ElementsAre(testing::Pair("force", 2e3), testing::Pair("sag", 0.3)));
  EXPECT_TRUE(made.space.cases[1].settings.empty());
  for (const char* own : {"length", "other_length"}) {
    const std::string mistakes = space_of(free + "cases: {full: {" + own + ": 3 m}}").mistakes;
    EXPECT_THAT(mistakes, HasSubstr(std::string("design.cases.full.") + own + ": ")) << "it moves with the unknown";
    EXPECT_THAT(mistakes, HasSubstr("is free by the unknown 'l'"));
  }
  EXPECT_THAT(space_of(free + "cases: {full: {force: 2 m}}").mistakes, HasSubstr("design.cases.full.force: "));
}

TEST(DesignSpace, ANumberIsFreeOnceInWhateverSpelling) {
  const std::string range = ", from: 2 m, to: 10 m}";
  const auto mistakes = [](const std::string& block) { return space_of(block).mistakes; };
  EXPECT_THAT(
      mistakes("unknowns: {a: {parameter: length" + range + ", b: {parameter: machine.length" + range + "}"),
      HasSubstr("design.unknowns.b.parameter: 'machine.length' is the same number as 'length', which is free by "
                "the unknown 'a'"));
  EXPECT_THAT(mistakes("unknowns: {a: {parameter: length, along_with: [machine.length]" + range + "}"),
              HasSubstr("design.unknowns.a.along_with[0]: "));
  const std::string free = "unknowns: {a: {parameter: length" + range + "}, ";
  EXPECT_THAT(mistakes(free + "cases: {full: {machine.length: 3 m}}"), HasSubstr("is free by the unknown 'a'"));
  EXPECT_THAT(mistakes(free + "cases: {full: {force: 3 kN, machine.force: 2 kN}}"),
              HasSubstr("'machine.force' is the same number as 'force'"));
}

// From 5 m and 20 m: the length is 15 m more.
TEST(DesignSpace, WhatMovesAlongStaysInItsRange) {
  const auto mistakes = [](const std::string& from) {
    return space_of("unknowns: {a: {parameter: other_length, along_with: [length], from: " + from + ", to: 8 m}}")
        .mistakes;
  };
  EXPECT_THAT(mistakes("-10 m"), IsEmpty()) << "length goes to 5 m";
  EXPECT_THAT(mistakes("-16 m"),
              HasSubstr("design.unknowns.a.along_with[0]: 'length' would go with it to -1 m, and must be above 0 m"));
}

class Catalogue : public testing::Test {
 protected:
  Made made(const std::string& rows, const std::string& block) const {
    std::ofstream(scratch_.path() / "mine.csv")
        << "id,standard,construction,core,d_mm,area_mm2,mass_kg_per_m,grade_MPa,mbf_kN,trust,price_per_m\n" + rows;
    return space_of("catalogue: mine.csv, ropes: {skyline: {construction: 6x36, modulus: 90 GPa}}" + block,
                    (scratch_.path() / "deck.yaml").string());
  }
  static std::vector<std::string> ids(const Made& made) {
    std::vector<std::string> all;
    for (const auto& row : made.space.ropes.at(0).rows) all.push_back(row.id);
    return all;
  }

  taut_test::ScratchFolder scratch_;
};

TEST_F(Catalogue, RopesComeInTheOrderOfWhatIsSought) {
  const std::string rows =
      "cheap,mine,6x36,IWRC,28,360,3.2,1770,500,verified,7\n"
      "light,mine,6x36,IWRC,27,311,2.8,1960,480,verified,9\n"
      "other,mine,6x19,IWRC,8,29,0.26,1960,45,verified,1\n"
      "thin,mine,6x36,IWRC,26,330,3.0,1960,490,verified,12\n";
  const Made lightest = made(rows, "");
  ASSERT_THAT(lightest.mistakes, IsEmpty());
  EXPECT_THAT(ids(lightest), ElementsAre("light", "thin", "cheap"));
  EXPECT_THAT(lightest.space.ropes[0].costs, ElementsAre(2.8, 3.0, 3.2));
  EXPECT_THAT(lightest.space.ropes[0].moduli, ElementsAre(90e9, 90e9, 90e9));
  EXPECT_THAT(ids(made(rows, ", seek: smallest")), ElementsAre("thin", "light", "cheap"));
  const Made cheapest = made(rows, ", seek: cheapest");
  EXPECT_THAT(ids(cheapest), ElementsAre("cheap", "light", "thin"));
  EXPECT_THAT(cheapest.space.ropes[0].costs, ElementsAre(7, 9, 12));
}

TEST_F(Catalogue, TheModulusIsThatOfTheConstructionWhereNoneIsGiven) {
  const std::string rows =
      "a,mine,6x36,IWRC,28,360,3.2,1770,500,verified,\nb,mine,6x36,odd,27,311,2.8,1960,480,verified,\n";
  EXPECT_THAT(made(rows, "").mistakes, IsEmpty()) << "given for both";
  const std::string deck = (scratch_.path() / "deck.yaml").string();
  const Made known = space_of("catalogue: mine.csv, ropes: {skyline: {core: IWRC}}", deck);
  ASSERT_THAT(known.mistakes, IsEmpty());
  EXPECT_THAT(known.space.ropes.at(0).moduli, ElementsAre(107.5e9));
  const Made unknown = space_of("catalogue: mine.csv, ropes: {skyline: {construction: 6x36}}", deck);
  EXPECT_THAT(unknown.mistakes, HasSubstr("design.ropes.skyline: no modulus is known for the construction of 'b'"));
}

TEST_F(Catalogue, ThatCannotBeReadIsAMistakeAtItsPlace) {
  const std::string heavy =
      "a,mine,6x36,IWRC,28,360,3.2,1770,500,verified,7\nb,mine,6x36,IWRC,28,360,x,1770,500,verified,\n";
  const Made broken = made(heavy, "");
  EXPECT_THAT(broken.mistakes, HasSubstr("mine.csv:3:"));
  EXPECT_TRUE(broken.space.ropes.empty());
  const std::string unpriced = "a,mine,6x36,IWRC,28,360,3.2,1770,500,verified,\n";
  EXPECT_THAT(made(unpriced, ", seek: cheapest").mistakes, HasSubstr("price_per_m"));
  EXPECT_THAT(space_of("catalogue: none.csv, ropes: {skyline: {}}", (scratch_.path() / "deck.yaml").string()).mistakes,
              HasSubstr("none.csv"));
}

design::UnknownValues unknown(const std::string& parameter, const std::vector<std::string>& along_with,
                              double price = 0) {
  design::UnknownValues own;
  own.parameter = parameter;
  own.along_with = along_with;
  own.price = price;
  return own;
}

TEST(DesignSpace, WhatMovesAlongKeepsItsDistance) {
  design::DesignSpace space;
  space.unknowns = {unknown("length", {"other_length", "sag"}), unknown("force", {"nothing"})};
  Numbers numbers;  // 20 m and 5 m, and no sag
  put_values(space, {26, 3e3}, parameters_of(numbers));
  EXPECT_EQ(numbers.length, 26);
  EXPECT_EQ(numbers.other_length, 11);
  EXPECT_EQ(numbers.sag, 26) << "what has no value yet has no distance either";
  EXPECT_EQ(numbers.force, 3e3);
  put_values(space, {20}, parameters_of(numbers));
  EXPECT_EQ(numbers.other_length, 5) << "there and back";
  EXPECT_EQ(numbers.sag, 20);
  put_case({.name = "full", .settings = {{"force", 7e3}, {"nothing", 1}}}, parameters_of(numbers));
  EXPECT_EQ(numbers.force, 7e3);
  EXPECT_EQ(numbers.length, 20);
}

TEST(DesignSpace, UnknownsCostWhereTheCheapestIsSought) {
  design::DesignSpace space;
  space.ropes.resize(2);
  space.sections.resize(1);
  space.unknowns = {unknown("length", {}, 12), unknown("force", {}, 0.5)};
  design::DesignRequest request;
  request.seek = design::Seek::cheapest;
  const design::DesignLengths cheapest = by_the_metre(request, space, {3, 100});
  EXPECT_EQ(cheapest.rest, 3 * 12 + 100 * 0.5);
  EXPECT_THAT(cheapest.ropes, ElementsAre(1, 1));
  EXPECT_THAT(cheapest.sections, ElementsAre(1));
  request.seek = design::Seek::lightest;
  EXPECT_EQ(by_the_metre(request, space, {3, 100}).rest, 0) << "money has no mass";
}

}  // namespace taut::app::design_space_test
