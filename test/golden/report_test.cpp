#include <gtest/gtest.h>

#include "taut/report/html.hpp"
#include "taut/report/markdown.hpp"
#include "taut/report/terminal.hpp"
#include "test/golden/golden.hpp"
#include "test/golden/made_result.hpp"

namespace report_test {

using namespace taut;
using taut_test::golden;
using taut_test::normalised;

/// The page without its fonts, which have a test of their own.
std::string without_fonts(std::string page) {
  for (std::size_t at = page.find("base64,"); at != std::string::npos; at = page.find("base64,", at + 8)) {
    page.erase(at + 7, page.find(')', at) - at - 7);
  }
  return page;
}

TEST(Golden, MarkdownOfAMadeResult) {
  const std::string now = normalised(report::to_markdown(taut_test::made_result()));
  EXPECT_EQ(now, golden("made.md", now));
}

TEST(Golden, TerminalOfAMadeResult) {
  const std::string now = normalised(report::to_terminal(taut_test::made_result()));
  EXPECT_EQ(now, golden("made.txt", now));
}

TEST(Golden, PageOfAMadeResult) {
  const std::string now = normalised(without_fonts(report::to_html(taut_test::made_result())));
  EXPECT_EQ(now, golden("made.html", now));
}

TEST(Golden, NormalisingTakesOutOnlyWhatChanges) {
  EXPECT_EQ(normalised("taut 1.22.3 · deck /a/b/mast.yaml · sha256:0123456789abcdef0123"),
            "taut VERSION · deck mast.yaml · HASH");
  EXPECT_EQ(normalised("63 kN at 0.12"), "63 kN at 0.12");
}

}  // namespace report_test
