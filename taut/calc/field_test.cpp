#include "taut/calc/field.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace taut::field_test {

enum class Wrap { geometric, paper };

struct Span {
  double length = 0;
  std::vector<double> positions;
  static const Description& describe() {
    static const Description d = Describe<Span>()
                                     .field(&Span::length, "length", "l", si::m, "horizontal span")
                                     .required()
                                     .above(0)
                                     .field(&Span::positions, "positions", "x", si::m, "carriage positions");
    return d;
  }
};

struct Input {
  double friction = 0.12;
  std::optional<double> angle;
  Wrap wrap = Wrap::paper;
  bool verbose = true;
  std::optional<Span> span;
  std::vector<Span> spans;
  static const Description& describe() {
    static const Description d =
        Describe<Input>()
            .field(&Input::friction, "friction", "f", si::one, "block friction")
            .at_least(0)
            .at_most(0.5)
            .field(&Input::angle, "angle", "alpha", si::rad, "branch angle")
            .choice(&Input::wrap, "wrap", {{"geometric", Wrap::geometric}, {"paper", Wrap::paper}}, "wrap rule")
            .field(&Input::verbose, "verbose", "say more")
            .record(&Input::span, "span", "the span")
            .record(&Input::spans, "spans", "more spans");
    return d;
  }
};

TEST(Field, SlotsReachIntoTheStruct) {
  Input in;
  const Field* f = Input::describe().find("friction");
  ASSERT_NE(f, nullptr);
  *std::get<double*>(f->slot(&in)) = 0.2;
  EXPECT_EQ(in.friction, 0.2);
  EXPECT_EQ(Input::describe().find("nothing"), nullptr);
}

TEST(Field, KnowsDefaults) {
  const Description& d = Input::describe();
  EXPECT_EQ(default_number(d, *d.find("friction")), 0.12);
  EXPECT_FALSE(default_number(d, *d.find("angle")).has_value());
  EXPECT_EQ(default_text(d, *d.find("wrap")), "paper");
  EXPECT_EQ(default_text(d, *d.find("verbose")), "true");
  EXPECT_FALSE(default_number(Span::describe(), *Span::describe().find("length")).has_value());
}

TEST(Field, ChoicesSetAndGetTheEnumerator) {
  Input in;
  const Choice choice = std::get<Choice>(Input::describe().find("wrap")->slot(&in));
  EXPECT_TRUE(choice.set("geometric"));
  EXPECT_EQ(in.wrap, Wrap::geometric);
  EXPECT_EQ(choice.get(), "geometric");
  EXPECT_FALSE(choice.set("sideways"));
  EXPECT_EQ(in.wrap, Wrap::geometric);
}

TEST(Field, RecordsAreMadeOnDemand) {
  Input in;
  const Record one = std::get<Record>(Input::describe().find("span")->slot(&in));
  EXPECT_TRUE(one.all().empty());
  static_cast<Span*>(one.create())->length = 5;
  ASSERT_TRUE(in.span.has_value());
  EXPECT_EQ(in.span->length, 5);
  const Record many = std::get<Record>(Input::describe().find("spans")->slot(&in));
  many.create();
  many.create();
  EXPECT_EQ(in.spans.size(), 2U);
  EXPECT_EQ(many.all().size(), 2U);
}

TEST(Field, RangesKnowTheirOpenEnds) {
  const Range above_zero{.low = 0, .high = 1, .low_included = false, .high_included = true};
  EXPECT_FALSE(above_zero.contains(0));
  EXPECT_TRUE(above_zero.contains(1));
  EXPECT_FALSE(above_zero.contains(1.1));
  EXPECT_TRUE(Range{}.contains(-1e300));
}

TEST(DeckPlace, IsPutTogetherOfListsAndKeys) {
  const std::string path = "reevings[0]";
  const DeckPlace reeving(path);
  const DeckPlace keys(reeving, "path");
  const DeckPlace element(keys, 2);
  EXPECT_EQ(reeving.text(), "reevings[0]");
  EXPECT_EQ(element.text(), "reevings[0].path[2]");
  EXPECT_EQ(DeckPlace(element, "over").text(), "reevings[0].path[2].over");
}

}  // namespace taut::field_test
