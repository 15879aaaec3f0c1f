#include "taut/app/explain/example_lines.hpp"

#include <gtest/gtest.h>

#include <string_view>

#include "taut/app/explain/terms.hpp"

namespace taut::app::example_lines_test {

const Term& key(std::string_view path) {
  for (const Term& t : terms()) {
    if (t.path == path) return t;
  }
  throw std::runtime_error("no key " + std::string(path));
}

TEST(ExampleLines, AreThoseOfAnExampleDeckThatHasTheKey) {
  const ExampleLine length = example_line(key("machine.reevings[].length"));
  EXPECT_TRUE(length.text.starts_with("length: ")) << length.text;
  EXPECT_TRUE(length.deck.ends_with(".yaml"));
  EXPECT_EQ(example_line(key("machine.drums.NAME.brake_torque")).text, "brake_torque: 7 kN m");
  EXPECT_EQ(example_line(key("closed_loop.input.span")).deck, "closed_loop.yaml");
}

TEST(ExampleLines, AreMadeWhereNoExampleHasTheKey) {
  const ExampleLine shorthand = example_line(key("machine.beams.NAME.top"));
  EXPECT_EQ(shorthand.text, "top: free");
  EXPECT_EQ(shorthand.deck, "");
  int none = 0;
  for (const Term& t : terms()) {
    if (t.kind == Term::Kind::key && t.field->record == nullptr && example_line(t).text.empty()) ++none;
  }
  EXPECT_LT(none, 250) << "keys without any example line";
}

}  // namespace taut::app::example_lines_test
