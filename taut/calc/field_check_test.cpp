#include "taut/calc/field_check.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace taut::field_check_test {

struct Inner {
  std::string name;
  double mass = 1;
  std::optional<double> length, tension;
  static const Description& describe() {
    static const Description d = Describe<Inner>()
                                     .field(&Inner::mass, "mass", "m", si::kg, "a mass")
                                     .at_least(0)
                                     .field(&Inner::length, "length", "L", si::m, "a length")
                                     .above(0)
                                     .may_be_infinite()
                                     .field(&Inner::tension, "tension", "T", si::N, "a tension")
                                     .above(0)
                                     .exactly_one({"length", "tension"});
    return d;
  }
};

struct Place {
  double height = 0;
  static const Description& describe() {
    static const Description d = Describe<Place>().field(&Place::height, "height", "h", si::m, "a height").at_least(0);
    return d;
  }
};

struct Outer {
  std::vector<Inner> parts;
  std::vector<Inner> list;
  std::string text = "x";
  std::vector<double> numbers = {1};
  std::vector<std::string> ways;
  int count = 1;
  Triple at{};
  std::optional<Place> place;
  static const Description& describe() {
    static const Description d = Describe<Outer>()
                                     .named_records(&Outer::parts, "parts", "named")
                                     .record(&Outer::list, "list", "one after the other")
                                     .field(&Outer::text, "text", "a text")
                                     .required()
                                     .field(&Outer::numbers, "numbers", "", si::m, "numbers")
                                     .required()
                                     .at_least(0)
                                     .field(&Outer::ways, "ways", "ways")
                                     .of({"x", "y"})
                                     .field(&Outer::count, "count", "n", si::one, "a count")
                                     .at_least(1)
                                     .at_most(64)
                                     .field(&Outer::at, "at", "", si::m, "a place")
                                     .at_most(100)
                                     .or_map(&Outer::place);
    return d;
  }
};

std::vector<std::string> told(const Outer& o) {
  std::vector<std::string> all;
  for (const Complaint& c : broken_fields(Outer::describe(), &o)) all.push_back(c.path + ": " + c.message);
  return all;
}

using Texts = std::vector<std::string>;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

Inner part(const std::string& name) {
  Inner one;
  one.name = name;
  one.length = 2;
  return one;
}

TEST(BrokenFields, AreNoneWhereAllIsInRange) {
  Outer o;
  o.parts = {part("a"), part("b")};
  o.list = {part("")};
  EXPECT_EQ(told(o), Texts{});
  o.list[0].length = infinite;
  EXPECT_EQ(told(o), Texts{});
}

TEST(BrokenFields, AreToldWithTheirPlaces) {
  Outer o;
  o.text.clear();
  o.numbers = {1, -2};
  o.ways = {"x", "q"};
  o.count = 2000000000;
  o.at = {0, 0, 1000};
  o.parts = {part("a"), part("b"), part("a")};
  o.parts[1].mass = nan;
  o.list = {part(""), part(""), part("")};
  o.list[0].mass = infinite;
  o.list[1].tension = 3;
  o.list[2].length.reset();
  EXPECT_EQ(told(o),
            (Texts{"parts.b.mass: is not a number",
                   "parts.a: another of 'parts' is called so too: give this one another name",
                   "list[0].mass: must be finite", "list[1]: give one of length, tension, not several",
                   "list[2]: needs one of length, tension", "text: the text is empty",
                   "numbers[1]: must be at least 0 m, not -2 m", "ways[1]: 'q' is not a choice; write x, y",
                   "count: must be at least 1 and at most 64, not 2e9", "at: must be at most 100 m, not 1000 m"}));
}

TEST(BrokenFields, AMapStandsInPlaceOfThreeComponents) {
  Outer o;
  o.at = {0, 0, 1000};
  o.place = Place{.height = -1};
  EXPECT_EQ(told(o), Texts{"at.height: must be at least 0 m, not -1 m"});
}

TEST(BrokenFields, RequiredListsAreNotEmpty) {
  Outer o;
  o.numbers.clear();
  EXPECT_EQ(told(o), Texts{"numbers: the list is empty"});
}

}  // namespace taut::field_check_test
