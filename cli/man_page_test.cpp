#include "cli/man_page.hpp"

#include <gmock/gmock.h>

#include <sstream>

namespace taut::cli::man_page_test {

using ::testing::HasSubstr;

TEST(ManPage, EscapesWhatRoffReadsAsARequest) {
  VerbWords verb{.name = "run",
                 .words =
                     "Reads .hidden and 'quoted' C:\\deck with a long line of words that goes on and on "
                     ".until it is filled",
                 .options = {},
                 .operands = {}};
  verb.options = {
      {.names = {"-o", "--output"},
       .value = "DIR",
       .words = "'first' word",
       .required = true,
       .repeated = false,
       .choices = {}},
      {.names = {"-h", "--help"}, .value = "", .words = "help", .required = false, .repeated = false, .choices = {}}};
  const std::string page = man_page({.name = "taut", .words = "w", .options = {}, .verbs = {verb}}, "2026-02-13");
  EXPECT_THAT(page, HasSubstr(".TH TAUT 1 \"2026-02-13\" \"taut "));
  EXPECT_THAT(page, HasSubstr("\\fBtaut\\fR \\fBrun\\fR \\fB\\-o\\fR \\fIDIR\\fR\n")) << "no [OPTION] for --help alone";
  EXPECT_THAT(page, HasSubstr("\n\\&'first' word\n"));
  EXPECT_THAT(page, HasSubstr("C:\\edeck"));
  EXPECT_THAT(page, HasSubstr("\\fB\\-o\\fR, \\fB\\-\\-output\\fR \\fIDIR\\fR\n"));
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(line.size(), 120U) << line;
    if (line.starts_with('\'')) ADD_FAILURE() << line;
  }
}

TEST(ManPage, SaysEveryExitCode) {
  const std::string page = man_page({.name = "taut", .words = "w", .options = {}, .verbs = {}}, "2026-02-13");
  for (const char* code : {"0", "1", "2", "3", "4", "5", "130"}) {
    EXPECT_THAT(page, HasSubstr(std::string(".TP\n\\fB") + code + "\\fR\n"));
  }
}

}  // namespace taut::cli::man_page_test
