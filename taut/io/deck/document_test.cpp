#include "taut/io/deck/document.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <ctime>
#include <string>

#include "test/paths.hpp"

namespace taut::io::document_test {

std::string reported(const std::string& text) {
  const auto d = parse(text, "deck.yaml");
  return to_text(d ? d->mistakes : d.error());
}

TEST(Document, KeepsOrderKindsAndPlaces) {
  const auto d = parse("b: 12 mm\na:\n  - 'x y'\n  - {k: ~}\né: \"q\"\n", "deck.yaml");
  ASSERT_TRUE(d) << to_text(d.error());
  EXPECT_TRUE(d->mistakes.empty());
  ASSERT_EQ(d->root.entries.size(), 3U);
  EXPECT_EQ(d->root.entries[0].key, "b");
  const Node& b = *d->root.find("b");
  EXPECT_EQ(b.text, "12 mm");
  EXPECT_FALSE(b.quoted);
  EXPECT_EQ(b.spot.place(), (Place{1, 4}));
  EXPECT_EQ(b.inside(3, 2).place(), (Place{1, 7}));
  const Node& item = d->root.find("a")->items.at(0);
  EXPECT_TRUE(item.quoted);
  EXPECT_EQ(item.text, "x y");
  EXPECT_EQ(item.spot.place(), (Place{3, 5}));
  EXPECT_EQ(item.spot.width, 5U);
  EXPECT_EQ(item.inside(2, 1).place(), (Place{3, 8})) << "the opening quote is skipped";
  const Node& nothing = *d->root.find("a")->items.at(1).find("k");
  EXPECT_EQ(nothing.kind, Node::Kind::null);
  EXPECT_EQ(nothing.spot.place(), (Place{4, 9}));
  EXPECT_EQ(d->root.find("é")->spot.place(), (Place{5, 5})) << "columns count bytes";
}

TEST(Document, ReadsYaml12NotYaml11) {
  const auto d = parse("on: y\noff: no\n1: 0o17\n", "d");
  ASSERT_TRUE(d);
  EXPECT_EQ(d->root.find("on")->text, "y");
  EXPECT_EQ(d->root.find("off")->text, "no");
  EXPECT_EQ(d->root.find("1")->text, "0o17");
}

TEST(Document, ReadsWindowsLineEndsByteOrderMarkAndJson) {
  const auto d = parse("\xEF\xBB\xBF{\"a\": 1,\r\n \"b\": [true, null]}\r\n", "d");
  ASSERT_TRUE(d) << to_text(d.error());
  EXPECT_EQ(d->root.find("a")->text, "1");
  EXPECT_EQ(d->root.find("a")->spot.place(), (Place{1, 7}));
  EXPECT_EQ(d->root.find("b")->items.at(0).text, "true");
  EXPECT_EQ(d->root.find("b")->items.at(1).kind, Node::Kind::null);
}

TEST(Document, TellsADuplicateAtTheSecondKeyAndKeepsTheFirst) {
  const auto d = parse("a: 1\nb: 2\na: 3\n", "deck.yaml");
  ASSERT_TRUE(d);
  ASSERT_EQ(d->mistakes.size(), 1U);
  EXPECT_EQ(d->mistakes[0].place, (Place{3, 1}));
  EXPECT_EQ(d->mistakes[0].source_line, "a: 3");
  EXPECT_EQ(d->root.find("a")->text, "1");
}

TEST(Document, AnEmptyValueHasThePlaceOfItsKey) {
  const auto d = parse("m:\n  a:\n  b: 1\nl:\n  -\n  - 1\n", "d");
  ASSERT_TRUE(d);
  EXPECT_EQ(d->root.find("m")->find("a")->spot.place(), (Place{2, 3}));
  EXPECT_EQ(d->root.find("l")->items.at(0).spot.place(), (Place{5, 3}));
}

TEST(Document, TellsWhatIsNotADeck) {
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"", "deck.yaml:1:1: error: there is nothing"},
      {"# only a comment\n", "nothing in it"},
      {"a: 1\n---\nb: 2\n", "deck.yaml:2:1: error: a second document"},
      {"- a\nb: 1\n", "deck.yaml:2:1: error: this does not belong"},
      {"a: 'open\nb: 2\n", "deck.yaml:1:4: error: a quoted text that is never closed"},
      {"a: \"open\nb: 2\n", "deck.yaml:1:4: error: a quoted text that is never closed"},
      {"a: &x 1\n", "deck.yaml:1:4: error: anchors"},
      {"a: *x\n", "deck.yaml:1:4: error: aliases"},
      {"a: !foo 1\n", "deck.yaml:1:4: error: tags"},
      {"a: !!map [1]\n", "deck.yaml:1:4: error: tags"},
      {"[1, 2]: x\n", "deck.yaml:1:1: error: a key is a text, not a list"},
      {"? {a: b}\n: 3\n", "a key is a text, not a map"},
      {"a:\n\tb: 1\n", "deck.yaml:2:1: error: a tab"},
      {"a:\n\u00a0\u00a0b: 1\n", "deck.yaml:2:1: error: a no-break or thin space stands before this key"},
      {"a: b: c\n", "deck.yaml:1:5: error: a ':' can't stand here"},
      {"a: 1\nspan\nb: 2\n", "deck.yaml:3:2: error: a ':' can't stand here: check the indentation and the line above"},
      {"a: 1\nspan\n", "deck.yaml:2:1: error: 'span' stands alone"},
      {"a: [1, 2\nb: 3\n", "deck.yaml:1:4: error: this '[' is never closed: a ']' is missing"},
      {"a: [1, 2\n  3, b: c d: 4]\n", "deck.yaml:2:"},
      {"a: [1]]\n", "deck.yaml:1:7: error: a closing bracket"},
      {"a: %x\n", "deck.yaml:1:4: error: a value can't begin"},
      {", ", "deck.yaml:1:1: error: a ','"},
      {"a: \"\\0\"\n", "deck.yaml:1:4: error: a control character"},
      {"a: \"\\q\"\n", "unknown escape"},
      {std::string("a: \0\n", 5), "deck.yaml:1:4: error: a NUL byte"},
      {"a: 1\nb: \xFF\n", "deck.yaml:2:4: error: byte 0xFF is not valid UTF-8"},
      {"a: \xC0\xAF\n", "not valid UTF-8"},
      {"a: \xED\xA0\x80\n", "not valid UTF-8"},
      {"a: \x04\n", "deck.yaml:1:4: error: control character 0x04"},
      {"a: 1\rb: 2\r", "deck.yaml:1:5: error: a carriage return alone"},
      {"\xFF\xFE"
       "a",
       "UTF-16"},
  };
  for (const auto& [text, expected] : rows) {
    EXPECT_NE(reported(text).find(expected), std::string::npos) << text << "\n-> " << reported(text);
  }
}

TEST(Document, TellsWhereWhatIsNotClosedWasOpened) {
  const std::vector<std::pair<std::string, std::string>> rows = {
      // the deck goes on for lines before the scanner stumbles
      {"m:\n  l:\n    - {at: car, mass: 1 t\nanalyses:\n  - e: {x: 1 m}\n",
       "deck.yaml:3:7: error: this '{' is never closed: a '}' is missing"},
      {"m:\n  - {p: [{a: 1}, {b: 2}, l: 3 m}\nn: 1\n",
       "deck.yaml:2:9: error: this '[' is not closed before the '}' of line 2: a ']' is missing"},
      {"a: {b: [1, 2}\nc: 3\n", "deck.yaml:1:8: error: this '['"},
      {"a: {b: 1}\nc: {d: 2\ne: {f: 3}\ng: 4\n", "deck.yaml:2:4: error: this '{' is never closed"},
      {"t: \"open\nm:\n  r: {n: \"x\"}\n", "deck.yaml:1:4: error: the text that begins with this \" ends in line 3"},
      {"t: 'open\nm:\n  r: {n: 'x', o: 'y'}\n",
       "deck.yaml:1:4: error: the text that begins with this ' ends in line 3"},
      // brackets that don't count
      {"# a { here\nt: it's {not} one [\nu: '{ ['\nv: \"}{\"\na: b: c\n", "deck.yaml:5:5: error: a ':' can't stand"},
      {"t: |\n  a: {\n\n  b: [\nu: 1\na: b: c\n", "deck.yaml:6:5: error: a ':' can't stand"},
      {"a: {b: 1,\n    c: [2,\n  3]}\nd: e: f\n", "deck.yaml:4:5: error: a ':' can't stand"},
  };
  for (const auto& [text, expected] : rows) {
    EXPECT_NE(reported(text).find(expected), std::string::npos) << text << "\n-> " << reported(text);
  }
  // what the text behind the open bracket seems to do wrong is not reported besides
  const std::string one = reported("a: {b: 1\nc: 2\nc: 3\nd: e: f\n");
  EXPECT_EQ(one.find("a second time"), std::string::npos) << one;
}

TEST(Document, RefusesDeepNestingAndAllowsWhatIsBelow) {
  const auto nested = [](std::size_t depth) { return "a: " + std::string(depth, '[') + "1" + std::string(depth, ']'); };
  EXPECT_EQ(reported(nested(63)), "");
  EXPECT_NE(reported(nested(64)).find("nested deeper than 64"), std::string::npos);
  std::string block;
  for (std::size_t i = 0; i < 70; ++i) block += std::string(i, ' ') + "a:\n";
  EXPECT_NE(reported(block).find("deck.yaml:65:65: error: nested deeper than 64"), std::string::npos)
      << reported(block);
}

TEST(Document, RefusesAHugeTextUnread) {
  EXPECT_NE(reported(std::string(17'000'000, 'a')).find("deck.yaml:1:1: error: larger than 16 MB"), std::string::npos);
}

/// Texts that make scanners slow or hungry, grown to 16 MB.
TEST(Document, IsNeverSlow) {
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"", "["},
      {"", "{"},
      {"", "- "},
      {"", "a: "},
      {"", "? "},
      {"", "x"},
      {"", "\n"},
      {"", "- a\n"},
      {"", "# \n"},
      {"", "&a "},
      {"", "*a "},
      {"", "!a "},
      {"", ", "},
      {"", "''\n"},
      {"a: \"", "x"},
      {"a: '", "''"},
      {"a: |\n", " x\n"},
      {"a: [", "1, "},
      {"", "[],"},
      {"", "[a, "},
      {"", "{a: "},
      {"", "---\n"},
      {"a: &", "a, "},
      {"a: !", "[],"},
      {"a: |\n", "\n"},
      {"", "%A\n"},
      {"", "\t"},
      {"a: ", "b "},
      {"", "a:\n"},
      {"", "-\n"},
      {"a:\n", "- \"aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa\"\n"},
  };
  for (const auto& [head, piece] : rows) {
    std::string text = head;
    text.reserve(largest_deck + piece.size());
    while (text.size() + piece.size() <= largest_deck) text += piece;
    const std::clock_t start = std::clock();  // of this process: others may keep the machine busy
    const auto d = parse(text, "d");
    const double took = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    EXPECT_TRUE(!d || !d->mistakes.empty()) << head << piece;
    if (std::getenv("TAUT_SHOW_TIMES") != nullptr) fmt::print("{:.2f} s {}{}\n", took, head, piece.substr(0, 8));
#ifdef __OPTIMIZE__
    if (!taut_test::watched) {
      EXPECT_LT(took, 2.0) << head << piece;
    }
#endif
  }
}

}  // namespace taut::io::document_test
