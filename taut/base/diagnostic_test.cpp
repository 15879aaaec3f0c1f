#include "taut/base/diagnostic.hpp"

#include <gtest/gtest.h>

namespace taut::diagnostic_test {

TEST(Diagnostic, PutsTheCaretUnderTheColumn) {
  const Diagnostic d{"deck.yaml", {12, 5}, "unknown key", "    diamter: 12 mm", 7};
  EXPECT_EQ(to_text(d),
            "deck.yaml:12:5: error: unknown key\n"
            "      diamter: 12 mm\n"
            "      ^~~~~~~\n");
}

TEST(Diagnostic, WithoutAPlaceNamesTheFileOnly) {
  EXPECT_EQ(to_text(Diagnostic{"deck.yaml", {}, "empty", "", 1}), "deck.yaml: error: empty\n");
}

TEST(Diagnostic, ShowsOnlyTheNeighbourhoodInALongLine) {
  const Diagnostic d{"d", {1, 5000}, "m", std::string(10000, 'x'), 1};
  EXPECT_LT(to_text(d).size(), 500U);
}

TEST(Diagnostic, SurvivesAColumnBehindTheLine) {
  const Diagnostic d{"d", {1, 99}, "m", "short", 50};
  EXPECT_NE(to_text(d).find('^'), std::string::npos);
}

TEST(Diagnostic, KeepsTabsAndControlCharactersHarmless) {
  const Diagnostic d{"d",
                     {1, 3},
                     "m",
                     std::string("\ta\x01"
                                 "b"),
                     1};
  EXPECT_NE(to_text(d).find("\ta?b"), std::string::npos);
}

}  // namespace taut::diagnostic_test
