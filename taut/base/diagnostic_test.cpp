#include "taut/base/diagnostic.hpp"

#include <gtest/gtest.h>

namespace taut::diagnostic_test {

TEST(Diagnostic, PutsTheCaretUnderTheColumn) {
  const Diagnostic d{.file = "deck.yaml",
                     .place = {.line = 12, .column = 5},
                     .message = "unknown key",
                     .source_line = "    diamter: 12 mm",
                     .width = 7};
  EXPECT_EQ(to_text(d),
            "deck.yaml:12:5: error: unknown key\n"
            "      diamter: 12 mm\n"
            "      ^~~~~~~\n");
}

TEST(Diagnostic, WithoutAPlaceNamesTheFileOnly) {
  EXPECT_EQ(to_text(Diagnostic{"deck.yaml", {}, "empty", "", 1}), "deck.yaml: error: empty\n");
}

TEST(Diagnostic, ShowsOnlyTheNeighbourhoodInALongLine) {
  const Diagnostic d{.file = "d",
                     .place = {.line = 1, .column = 5000},
                     .message = "m",
                     .source_line = std::string(10000, 'x'),
                     .width = 1};
  EXPECT_LT(to_text(d).size(), 500U);
}

TEST(Diagnostic, SurvivesAColumnBehindTheLine) {
  const Diagnostic d{
      .file = "d", .place = {.line = 1, .column = 99}, .message = "m", .source_line = "short", .width = 50};
  EXPECT_NE(to_text(d).find('^'), std::string::npos);
}

TEST(Diagnostic, KeepsTabsAndControlCharactersHarmless) {
  const Diagnostic d{.file = "d",
                     .place = {.line = 1, .column = 3},
                     .message = "m",
                     .source_line = std::string("\ta\x01"
                                                "b"),
                     .width = 1};
  EXPECT_NE(to_text(d).find("\ta?b"), std::string::npos);
}

}  // namespace taut::diagnostic_test
