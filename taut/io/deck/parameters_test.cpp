#include "taut/io/deck/parameters.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "taut/io/deck/deck.hpp"
#include "taut/io/deck/expression.hpp"
#include "taut/io/deck/read.hpp"
#include "taut/io/deck/sample_test.hpp"

namespace taut::io::parameters_test {

namespace fs = std::filesystem;

tl::expected<Measure, UnitError> value_of(std::string_view text) {
  return evaluate(text, [](std::string_view name) -> tl::expected<Measure, std::string> {
    if (name == "gap") return Measure{.value = 0.95, .dimension = dimension(0, 1, 0), .is_angle = false};
    if (name == "beta") return Measure{.value = 0.5, .dimension = {}, .is_angle = true};
    return tl::unexpected(fmt::format("no {}", name));
  });
}

TEST(Expression, Arithmetic) {
  const std::vector<std::pair<std::string, double>> rows = {
      {"2 + 3 * 4", 14},
      {"(2 + 3) * 4", 20},
      {"2 - 3 - 4", -5},
      {"12 / 3 / 2", 2},
      {"-2^2", -4},
      {"2^3^1", 8},
      {"2^-1", 0.5},
      {"--3", 3},
      {"9 m - gap", 8.05},
      {"9 m - 2*gap", 7.1},
      {"gap/2", 0.475},
      {"1 m/gap", 1 / 0.95},
      {"60 km/h * 3 s", 50},
      {"3.5 kN/m * 2 m + 1 kN", 8000},
      {"5 1/s * 2 s", 10},
      {"2 m^2 / 4 m", 0.5},
      {"1 kg m^2 / 2 kg m2", 0.5},
      {"30 deg + beta", std::numbers::pi / 6 + 0.5},
      {"sin(30 deg) * 2", 1},
      {"tan(beta)", std::tan(0.5)},
      {"atan2(1 m, 1 m)", std::numbers::pi / 4},
      {"max(gap, 90 cm) + min(1 m, gap)", 1.9},
      {"sqrt(9 m^2) - abs(-1 m)", 2},
      {"2 * pi", 2 * std::numbers::pi},
      {"15 %", 0.15},
      {".5e1 + 1.5E-1", 5.15},
      {"1e3 N", 1000},
  };
  for (const auto& [text, expected] : rows) {
    const auto got = value_of(text);
    ASSERT_TRUE(got) << text << ": " << got.error().message;
    EXPECT_NEAR(got->value, expected, 1e-12 * std::max(1.0, std::abs(expected))) << text;
  }
  EXPECT_EQ(value_of("3 kN * 2 m")->dimension, si::N_m.dimension);
  EXPECT_TRUE(value_of("2 * beta")->is_angle);
  EXPECT_FALSE(value_of("beta / (1 deg)")->is_angle);
  EXPECT_FALSE(value_of("beta * gap")->is_angle);
}

TEST(Expression, TellsWhereItIsWrong) {
  const std::vector<std::tuple<std::string, std::string, int>> rows = {
      {"1 m + 2", "the left side is in ", 4},
      {"", "a value is missing", 0},
      {"2 *", "a value is missing", 2},
      {"(1 + 2", "is not closed", 0},
      {"1 2", "an operator", 2},
      {"2 gap", "gap", 2},
      {"gip + 1 m", "no gip", 0},
      {"1 m + 3 furlongs", "furlongs", 8},
      {"sine(1)", "there is no function 'sine'; did you mean 'sin'?", 0},
      {"sin(1)", "an angle is expected", 0},
      {"asin(2)", "outside -1 to 1", 0},
      {"sqrt(-1)", "below 0", 0},
      {"sqrt(1, 2)", "one value is expected", 0},
      {"max(1)", "two values are expected", 0},
      {"max(1 m, 1 s)", "the first value is", 0},
      {"gap^0.5", "a whole number", 3},
      {"beta + 1", "the left side is an angle", 5},
      {"1/0", "not a finite number", 0},
      {"#", "is expected here", 0},
  };
  for (const auto& [text, message, offset] : rows) {
    const auto got = value_of(text);
    ASSERT_FALSE(got) << text;
    EXPECT_NE(got.error().message.find(message), std::string::npos) << text << ": " << got.error().message;
    EXPECT_EQ(got.error().offset, offset) << text << ": " << got.error().message;
  }
  EXPECT_NE(value_of(std::string(100, '(') + "1" + std::string(100, ')')).error().message.find("deeper than 64"),
            std::string::npos);
  EXPECT_FALSE(value_of(std::string(100000, '-') + "1"));
}

TEST(Expression, AValueIsWrittenSoThatItIsReadBackExactly) {
  for (const char* text : {"0.1 m * 3", "7 kN / 3", "1 kg m^2 / 7", "beta / 3", "3 kN s/m / 7", "1/3", "4 m/s/3"}) {
    const auto value = value_of(text);
    ASSERT_TRUE(value) << text;
    const auto back = parse_any_quantity(to_text(*value));
    ASSERT_TRUE(back) << to_text(*value) << ": " << back.error().message;
    EXPECT_EQ(back->value, value->value) << to_text(*value);
    EXPECT_EQ(back->unit.dimension, value->dimension);
    EXPECT_EQ(back->unit.is_angle, value->is_angle);
  }
  EXPECT_EQ(to_text(*value_of("sqrt(1 m)")), "");
}

struct Reading {
  Sample sample;
  std::string text;
  std::size_t mistakes = 0;
};

Reading run(const std::string& text, const std::vector<std::string>& set = {}, const std::string& name = "deck.yaml") {
  Reading t;
  Diagnostics mistakes;
  const auto deck = read_deck(text, name, set, {"sample"}, mistakes);
  if (deck) read(deck->input, Sample::describe(), &t.sample, "sample", mistakes);
  t.text = to_text(mistakes);
  t.mistakes = mistakes.size();
  return t;
}

const std::string head = "taut: 1\nmethod: sample\n";

TEST(Parameters, AreUsedAnywhereInAnyOrder) {
  const std::string deck = head +
                           "parameters: {far: = 2 * near + 1 m, near: 3 m, d: 9 mm, kind: 6x19, mu: 20 %, n: = k + 1, "
                           "k: 2, stiff: .inf}\n"
                           "input:\n  span: = far\n  positions: [= near, 1 m, '= max(near, far)']\n"
                           "  friction: = mu\n  sheaves: = n\n  stiffness: = stiff\n"
                           "  rope: {diameter: = d, construction: = kind}\n"
                           "  cases:\n    - {name: a, angle: '= atan2(1 m, near)', falls: = 2 * k}\n";
  const Reading t = run(deck);
  ASSERT_EQ(t.mistakes, 0U) << t.text;
  EXPECT_DOUBLE_EQ(t.sample.span, 7);
  EXPECT_EQ(t.sample.positions, (std::vector<double>{3, 1, 7}));
  EXPECT_DOUBLE_EQ(t.sample.friction, 0.2);
  EXPECT_EQ(t.sample.sheaves, 3);
  EXPECT_TRUE(std::isinf(t.sample.stiffness));
  EXPECT_DOUBLE_EQ(t.sample.rope.diameter, 0.009);
  EXPECT_EQ(t.sample.rope.construction, "6x19");
  EXPECT_DOUBLE_EQ(t.sample.cases.at(0).angle, std::atan2(1.0, 3.0));
  EXPECT_EQ(t.sample.cases.at(0).falls, 4);
  const Reading other = run(deck, {"parameters.near=4 m", "input.friction== mu / 2"});
  ASSERT_EQ(other.mistakes, 0U) << other.text;
  EXPECT_DOUBLE_EQ(other.sample.span, 9);
  EXPECT_DOUBLE_EQ(other.sample.friction, 0.1);
}

TEST(Parameters, MistakesAreToldOnceAtTheirPlace) {
  const std::string input = "input: {span: = far, rope: {diameter: 1 mm}}\n";
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"parameters: {fat: 1 m}\n" + input, "deck.yaml:4:17: error: there is no parameter 'far'; did you mean 'fat'?"},
      {input, "there is no parameter 'far'; the deck has no 'parameters'"},
      {"parameters: {far: = a, a: = b + 1 m, b: = a}\n" + input, "deck.yaml:3:43: error: 'a' is used in its own value"},
      {"parameters: {far: = 1 m +}\n" + input, "deck.yaml:3:25: error: a value is missing at the end"},
      {"parameters: {far: 1 kN}\n" + input, "deck.yaml:4:15: error: span: "},
      {"parameters: {far: = 1 kN * 2}\n" + input, "deck.yaml:4:15: error: span: "},
      {"parameters: {far: = sqrt(1 m)}\n" + input, "a fraction of a dimension"},
      {"parameters: {far: hello, x: = far + 1 m}\n" + input, "'far' is the text 'hello', no quantity"},
      {"parameters: {far: [1 m]}\n" + input, "'far' is a list; a quantity, a text or an expression is expected"},
      {"parameters: {m: 1 m}\n" + head.substr(0, 0) + "input: {span: = m, rope: {diameter: 1 mm}}\n",
       "'m' can't be a name"},
      {"parameters: [a]\n" + input, "parameters: a map of names and values is expected"},
      {"parameters: {far: 1 m, fur: 2 m}\n" + input,
       "deck.yaml:3:24: error: parameters: nothing in the deck uses 'fur'; did you mean 'far'?"},
  };
  for (const auto& [text, expected] : rows) {
    const Reading t = run(head + text);
    EXPECT_NE(t.text.find(expected), std::string::npos) << text << "\n-> " << t.text;
  }
  const Reading once = run(head + "parameters: {far: = a, a: = b, b: = c + 1 m}\n" + input);
  EXPECT_NE(once.text.find("deck.yaml:3:37: error: there is no parameter 'c'"), std::string::npos) << once.text;
  const Reading set = run(head + "parameters: {far: 1 m}\n" + input, {"parameters.fur=2 m"});
  EXPECT_NE(set.text.find("nothing in the deck uses 'fur'; did you mean 'far'?"), std::string::npos) << set.text;
  std::string chain = head + "parameters:\n  far: = p0\n";
  for (int i = 0; i < 200; ++i) chain += fmt::format("  p{}: = p{}\n", i, i + 1);
  EXPECT_NE(run(chain + "  p200: 1 m\n" + input).text.find("more than 64 parameters use one another"),
            std::string::npos);
}

TEST(Parameters, OfAnIncludedDeckAreOverridden) {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  const fs::path folder = fs::path(testing::TempDir()) / fmt::format("taut_parameters_{}", info->name());
  fs::create_directories(folder);
  std::ofstream(folder / "base.part.yaml") << "taut: 1\nmethod: sample\nparameters: {near: 3 m, spare: 1 m, d: 9 mm}\n"
                                              "input: {span: = 2 * near, rope: {diameter: = d + hole}}\n";
  const std::string deck = (folder / "deck.yaml").string();
  const Reading good = run("include: base.part.yaml\nparameters: {near: 5 m, hole: 1 mm}\n", {}, deck);
  ASSERT_EQ(good.mistakes, 0U) << good.text;
  EXPECT_DOUBLE_EQ(good.sample.span, 10);
  EXPECT_DOUBLE_EQ(good.sample.rope.diameter, 0.01);
  const Reading bad = run("include: base.part.yaml\nparameters: {nera: 5 m}\n", {}, deck);
  EXPECT_NE(bad.text.find("base.part.yaml:4:50: error: there is no parameter '...'"), std::string::npos) << bad.text;
  EXPECT_NE(bad.text.find("deck.yaml:2:14: error: parameters: nothing in the deck uses 'nera'; did you mean 'near'?"),
            std::string::npos)
      << bad.text;
  fs::remove_all(folder);
}

}  // namespace taut::io::parameters_test
