// Bad decks: each is reported with file:line:column, none throws.
#include "taut/io/deck/bad_decks_test.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "taut/io/deck/deck.hpp"
#include "taut/io/deck/read.hpp"
#include "taut/io/deck/sample_test.hpp"

namespace taut::io::bad_decks_test {

Diagnostics mistakes_of(const std::string& text) {
  Diagnostics mistakes;
  const auto deck = read_deck(text, "deck.yaml", {}, {"sample"}, mistakes);
  if (!deck) return mistakes;
  Sample s;
  read(deck->input, Sample::describe(), &s, "sample", mistakes);
  return mistakes;
}

TEST(BadDecks, TheDeckTheyAreMadeOfIsGood) { EXPECT_EQ(to_text(mistakes_of(good)), ""); }

TEST(BadDecks, EachIsToldWithItsPlace) {
  std::vector<std::string> decks;
  add_wrong_values(decks);
  add_wrong_keys(decks);
  add_no_decks(decks);
  EXPECT_GE(decks.size(), 200U);
  for (const std::string& text : decks) {
    const std::string shown = text.substr(0, 400);
    Diagnostics mistakes;
    EXPECT_NO_THROW(mistakes = mistakes_of(text)) << shown;
    EXPECT_FALSE(mistakes.empty()) << "taken as good:\n" << shown;
    for (const Diagnostic& d : mistakes) {
      EXPECT_FALSE(d.file.empty() || d.message.empty()) << shown;
      EXPECT_GE(d.place.line, 1) << shown;
      EXPECT_GE(d.place.column, 1) << shown;
      EXPECT_LE(d.message.size(), 1000U) << d.message;
    }
  }
}

/// Every deck cut off anywhere, and with any one byte replaced, is read without an exception.
TEST(BadDecks, CutAndDamagedDecksNeverThrow) {
  for (std::size_t i = 0; i < good.size(); ++i) {
    EXPECT_NO_THROW(mistakes_of(good.substr(0, i))) << i;
    for (const char c : std::string("\0\t\n:-[]{}\"'&*!#|%~,\x80\xFF", 21)) {
      std::string text = good;
      text[i] = c;
      EXPECT_NO_THROW(mistakes_of(text)) << i << " " << c;
    }
  }
}

}  // namespace taut::io::bad_decks_test
