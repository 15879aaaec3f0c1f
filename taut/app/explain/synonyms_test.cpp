#include "taut/app/explain/synonyms.hpp"

#include <gtest/gtest.h>

#include "taut/app/explain/explain_name.hpp"

namespace taut::app::synonyms_test {

TEST(Synonyms, LeadToTheWordOfADeck) {
  EXPECT_EQ(deck_word("pulley"), "sheaves");
  EXPECT_EQ(deck_word("Winches"), "") << "only a plain s";
  EXPECT_EQ(deck_word("Pulleys"), "sheaves");
  EXPECT_EQ(deck_word("jack"), "supports");
  EXPECT_EQ(deck_word("sheaves"), "");
}

TEST(Synonyms, EachIsExplained) {
  for (const std::string& word : field_words()) {
    const auto text = explain_name(word);
    ASSERT_TRUE(text) << word << ": " << text.error();
    EXPECT_GT(text->size(), 60U) << word;
  }
}

}  // namespace taut::app::synonyms_test
