#include "taut/io/deck/parameters.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "taut/io/deck/deck.hpp"
#include "taut/io/deck/read.hpp"
#include "taut/io/deck/sample_test.hpp"

namespace taut::io::parameters_test {

namespace fs = std::filesystem;

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

/// `--set` takes the only use away: the deck as written has it.
TEST(Parameters, ThatAreUsedWhereSetPutsSomethingElse) {
  const std::string deck =
      head + "parameters: {far: = 2 * near, near: 1 m}\ninput: {span: = far + 1 m, rope: {diameter: 1 mm}}\n";
  const Reading set = run(deck, {"input.span=2 m"});
  EXPECT_EQ(set.mistakes, 0U) << set.text;
  EXPECT_DOUBLE_EQ(set.sample.span, 2);
  EXPECT_EQ(run(deck, {"input={span: 2 m, rope: {diameter: 1 mm}}"}).mistakes, 0U);
  EXPECT_EQ(run(deck, {"input.span=2 m", "parameters.fur=1 m"}).mistakes, 1U);
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

TEST(Parameters, ThatNothingUsesAreListedWhereverTheyWereDefined) {
  const auto unused = [](const std::string& text) {
    Diagnostics mistakes;
    const auto document = read_document(head + text, "deck.yaml", {}, mistakes);
    return unused_parameters(*document);
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(unused("parameters: {a: 1 m, b: = c, c: 2 m, d: 3 m}\ninput: {span: = d}\ntitle: = a\n"), (Names{"a", "b"}))
      << "c serves b; a title is a text";
  EXPECT_EQ(unused("input: {span: = d}\n"), Names{});
  EXPECT_EQ(unused("parameters: 3 m\ninput: {span: 1 m}\n"), Names{});
}

}  // namespace taut::io::parameters_test
