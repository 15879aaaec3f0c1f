#include "taut/report/text/text.hpp"

#include <gtest/gtest.h>

namespace text_test {

using namespace taut::report;

TEST(Text, CleanDropsWhatATerminalWouldObey) {
  EXPECT_EQ(clean("a\x1b[31mb\x07\x7f"), "a[31mb");
  EXPECT_EQ(clean(std::string("a\0b", 3)), "ab");
  EXPECT_EQ(clean("a\nb\tc"), "a b c");
  EXPECT_EQ(clean("a\u202Eb\u2066c\uFEFF"), "abc");
}

TEST(Text, CleanKeepsLettersAndReplacesBrokenOnes) {
  EXPECT_EQ(clean("канат γ 𝑏"), "канат γ 𝑏");
  EXPECT_EQ(clean("a\xff"), "a\uFFFD");
  EXPECT_EQ(clean("\xC0\xAF"), "\uFFFD\uFFFD");            // a slash in a form that is too long
  EXPECT_EQ(clean("\xE2\x82"), "\uFFFD\uFFFD");            // cut off
  EXPECT_EQ(clean("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD");  // half of a pair
}

TEST(Text, EscapeLeavesNoMarkup) {
  EXPECT_EQ(escape("<a b=\"c\" d='e'>&"), "&lt;a b=&quot;c&quot; d=&#39;e&#39;&gt;&amp;");
}

TEST(Text, MarkdownCellsStayOneCell) { EXPECT_EQ(escape_markdown("a|b\n`c`"), "a\\|b \\`c\\`"); }

TEST(Text, CountsCharactersNotBytes) {
  EXPECT_EQ(length("γ_sky"), 5);
  EXPECT_EQ(shortened("γγγγγγ", 5), "γγ...");
  EXPECT_EQ(shortened("γγγγγ", 5), "γγγγγ");
}

TEST(Text, WrapsAtSpaces) {
  EXPECT_EQ(wrapped("one two three", 7), (std::vector<std::string>{"one two", "three"}));
  EXPECT_EQ(wrapped("", 7), (std::vector<std::string>{""}));
  EXPECT_EQ(wrapped("incomprehensible word", 7), (std::vector<std::string>{"incomprehensible", "word"}));
}

TEST(Text, Base64AsInRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Text, CssStringCannotLeaveTheStyleSheet) {
  const std::string s = css_string("a\"}</style>\\");
  EXPECT_EQ(s.find('<'), std::string::npos);
  EXPECT_EQ(s, "\"a\\22 }\\3c /style\\3e \\5c \"");
}

}  // namespace text_test
