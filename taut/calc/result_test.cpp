#include "taut/calc/result.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "taut/calc/verdict.hpp"

namespace taut::result_test {

struct Part {
  double falls = 8;
  static const Description& describe() {
    static const Description d = Describe<Part>().field(&Part::falls, "falls", "K", si::one, "parts of line");
    return d;
  }
};
struct Input {
  double force = 0;
  double friction = 0.12;
  std::optional<double> angle;
  std::vector<Part> parts;
  std::string name;
  static const Description& describe() {
    static const Description d = Describe<Input>()
                                     .field(&Input::force, "force", "F", si::N, "force")
                                     .required()
                                     .field(&Input::friction, "friction", "f", si::one, "friction")
                                     .field(&Input::angle, "angle", "alpha", si::rad, "angle")
                                     .record(&Input::parts, "parts", "parts")
                                     .field(&Input::name, "name", "a name");
    return d;
  }
};
struct Output {
  double r = std::numeric_limits<double>::quiet_NaN();
  double n = std::numeric_limits<double>::quiet_NaN();
  static const Description& describe() {
    static const Description d = Describe<Output>()
                                     .field(&Output::r, "R", "R", si::N, "resultant")
                                     .from("(4)")
                                     .field(&Output::n, "N", "", si::N, "axial force");
    return d;
  }
};

TEST(Check, PassesUpToTheLimitIncluded) {
  EXPECT_TRUE(make_check("c", 2, si::one, {Sense::at_most, 2, "r", "verified"}).passes);
  EXPECT_FALSE(make_check("c", 2.1, si::one, {Sense::at_most, 2, "r", "verified"}).passes);
  // 300 kN over the given tension of 100 kN comes out as 2.9999999999999996
  const Check on = make_check("c", 3 * (1 - 1e-12), si::one, {Sense::at_least, 3, "r", "verified"});
  EXPECT_TRUE(on.passes);
  EXPECT_LE(on.utilisation, 1);
  EXPECT_FALSE(make_check("c", 3 * (1 - 1e-8), si::one, {Sense::at_least, 3, "r", "verified"}).passes);
  EXPECT_FALSE(make_check("c", 1e-12, si::one, {Sense::at_most, 0, "r", "verified"}).passes);
  const Check c =
      make_check("c", 22, si::one, {.sense = Sense::at_least, .limit = 20, .rule = "D/d", .trust = "verified"});
  EXPECT_TRUE(c.passes);
  EXPECT_DOUBLE_EQ(c.utilisation, 20.0 / 22.0);
  EXPECT_FALSE(make_check("c", std::nan(""), si::one, {Sense::at_most, 2, "r", "t"}).passes);
}

/// A share of kelvins would be 0.79 for every rope in a room, and none would be far from its limit.
TEST(Check, TemperaturesCountFromZeroDegC) {
  const auto at = [](double celsius) {
    return make_check("t", 273.15 + celsius, si::K.in("degC"),
                      {Sense::at_most, 373.15, "by core", "UNVERIFIED: recalled"});
  };
  EXPECT_NEAR(at(20).utilisation, 0.2, 1e-12);
  EXPECT_FALSE(decides(at(20)));
  EXPECT_TRUE(decides(at(90))) << "an unverified limit that is near is told";
  EXPECT_TRUE(at(-30).passes);
  EXPECT_FALSE(decides(at(-30)));
  EXPECT_GT(at(101).utilisation, 1);
  EXPECT_FALSE(at(101).passes);
}

TEST(Result, ValuesLeaveOutWhatWasNotComputed) {
  Output out;
  out.r = 5;
  const auto values = values_of(Output::describe(), &out);
  ASSERT_EQ(values.size(), 1U);
  EXPECT_EQ(values[0].name, "R");
  EXPECT_EQ(values[0].source, "(4)");
}

TEST(Result, GivenListsWhatWasUsedAndMarksDefaults) {
  Input in;
  in.force = 7;
  in.parts.resize(2);
  in.parts[1].falls = 6;
  const auto given = given_of(Input::describe(), &in);
  ASSERT_EQ(given.size(), 4U);
  EXPECT_EQ(given[0].key, "force");
  EXPECT_FALSE(given[0].is_default);
  EXPECT_TRUE(given[1].is_default);
  EXPECT_EQ(given[2].key, "parts[0].falls");
  EXPECT_TRUE(given[2].is_default);
  EXPECT_FALSE(given[3].is_default);
}

TEST(Result, FindsByName) {
  Result r;
  r.values.push_back({"N", 1, si::N, "N", "", ""});
  r.tables.push_back({"positions", "", {}, {}});
  EXPECT_NE(r.find_value("N"), nullptr);
  EXPECT_EQ(r.find_value("M"), nullptr);
  EXPECT_NE(r.find_table("positions"), nullptr);
  EXPECT_EQ(r.find_table("x"), nullptr);
}

struct Pin {
  std::string name;
  Triple at{1, 2, 3};
  std::optional<Triple> axis;
  std::vector<std::string> free;
  static const Description& describe() {
    static const Description d = Describe<Pin>()
                                     .field(&Pin::at, "at", "", si::m, "place")
                                     .field(&Pin::axis, "axis", "", si::one, "axis")
                                     .field(&Pin::free, "free", "directions");
    return d;
  }
};
struct Pins {
  std::vector<Pin> pins;
  static const Description& describe() {
    static const Description d = Describe<Pins>().named_records(&Pins::pins, "pins", "pins");
    return d;
  }
};

TEST(Result, GivenOfNamedStructsCarriesTheirNames) {
  const Pins in{{{.name = "head", .at = {1, 2, 3}, .axis = {}, .free = {}},
                 {.name = "tail", .at = {0, 0, 1}, .axis = Triple{0, 1, 0}, .free = {"x", "z"}}}};
  const auto all = given_of(Pins::describe(), &in);
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all[0].key, "pins.head.at");
  EXPECT_TRUE(all[0].is_default);
  EXPECT_EQ(all[1].key, "pins.tail.at");
  EXPECT_EQ(all[1].numbers, (std::vector<double>{0, 0, 1}));
  EXPECT_FALSE(all[1].is_default);
  EXPECT_EQ(all[2].numbers, (std::vector<double>{0, 1, 0}));
  EXPECT_EQ(all[3].text, "x, z");
}

}  // namespace taut::result_test
