#include "taut/report/terminal.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "test/golden/made_result.hpp"

namespace terminal_test {

using namespace taut;
using namespace taut::report;

TEST(Terminal, PlainUnlessAskedForColour) {
  const Result r = taut_test::made_result();
  EXPECT_EQ(to_terminal(r).find('\x1b'), std::string::npos);
  EXPECT_NE(to_terminal(r, {.colour = true, .width = 100}).find("\x1b[1;31mfails\x1b[0m"), std::string::npos);
}

TEST(Terminal, ColourChangesNothingElse) {
  const Result r = taut_test::made_result();
  std::string coloured = to_terminal(r, {.colour = true, .width = 100});
  for (const std::string code : {"\x1b[1;31m", "\x1b[1;32m", "\x1b[0m"}) {
    for (std::size_t at = coloured.find(code); at != std::string::npos; at = coloured.find(code))
      coloured.erase(at, code.size());
  }
  EXPECT_EQ(coloured, to_terminal(r));
}

TEST(Terminal, TheDeckCannotSteerIt) {
  Result r = taut_test::made_result();
  r.title = "\x1b]0;owned\x07";
  r.warnings = {"\x1b[2J\r\nfake line"};
  r.checks[0].name = "\x1b[31mred";
  r.values[0].label = "two\nlines";
  const std::string text = to_terminal(r);
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
  EXPECT_EQ(text.find('\r'), std::string::npos);
  EXPECT_EQ(text.find("\nlines"), std::string::npos);
}

TEST(Terminal, SaysWhyThereIsNoAnswer) {
  Result r;
  r.status = Status::infeasible;
  r.message = "no grip: raise the wrap angle";
  EXPECT_NE(to_terminal(r).find("no grip"), std::string::npos);
}

TEST(Terminal, WordsWrapAtTheWidth) {
  Result r;
  r.warnings = {std::string(30, 'a') + " " + std::string(30, 'b') + " " + std::string(30, 'c')};
  const std::string text = to_terminal(r, {.colour = false, .width = 50});
  EXPECT_NE(text.find("\n    " + std::string(30, 'b') + "\n"), std::string::npos) << text;
}

TEST(Terminal, PrintsShortTablesTurnsWideOnesAndNamesLongOnes) {
  Result r;
  const Table narrow{.name = "narrow",
                     .title = "Narrow",
                     .columns = {{.name = "x", .unit = si::m}, {.name = "rope", .unit = si::one}},
                     .rows = {{1.5, "haulback"}}};
  Table wide{.name = "wide", .title = "Wide", .columns = {}, .rows = {{}}};
  for (int k = 0; k < 20; ++k) {
    wide.columns.push_back({fmt::format("column_{}", k), si::N});
    wide.rows[0].emplace_back(1000.0 * k);
  }
  const Table tall{.name = "tall",
                   .title = "Tall",
                   .columns = {{.name = "x", .unit = si::m}},
                   .rows = std::vector<std::vector<Cell>>(100, std::vector<Cell>{1.0})};
  r.tables = {narrow, wide, tall};
  const std::string text = to_terminal(r, {.all = true});
  EXPECT_NE(text.find("  x [m]  rope\n    1.5  haulback\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  column_7 [kN]   7\n"), std::string::npos) << text;
  EXPECT_NE(text.find("In the report and as CSV with -o: tall (100 rows)"), std::string::npos) << text;
}

TEST(Terminal, ASummaryHasFortyLinesAndEndsWithTheVerdict) {
  Result r;
  r.title = std::string(400, 't');
  r.source = std::string(400, 's');
  r.deck_name = "deck.yaml";
  r.deck_hash = std::string(40, 'a');
  r.answers = {{.label = "Build", .text = "skyline 20 mm, 382 m"}, {.label = "Carries", .text = "2.96 t"}};
  for (int k = 0; k < 60; ++k) {
    const std::string part = fmt::format("rope_{}", k);
    Check c = make_check(part + ".T_max", k, si::N, {.limit = 30, .rule = "breaking force", .trust = "derived"});
    c.part = part;
    r.checks.push_back(c);
    r.values.push_back({part + ".T", 1, si::N, "T", std::string(300, 'l'), ""});
    r.warnings.push_back(std::string(80, 'w') + " " + std::string(300, 'w'));
    r.beside.push_back(part);
    r.comparisons.push_back({part, "T", si::N, 1, 2, 3, "corrected"});
  }
  const std::string text = to_terminal(r);
  EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 38) << text;
  EXPECT_NE(text.find("Build    skyline 20 mm, 382 m\nCarries  2.96 t\n"), std::string::npos) << text;
  EXPECT_NE(text.find("fails  rope_59.T_max"), std::string::npos) << text;
  EXPECT_EQ(text.find("rope_49.T_max"), std::string::npos) << "ten rows, the worst";
  EXPECT_NE(text.find("50 more: --all"), std::string::npos) << text;
  EXPECT_NE(text.find("56 more: --all"), std::string::npos) << text;
  EXPECT_NE(text.find("more comparisons"), std::string::npos) << text;
  const std::size_t last = text.rfind('\n', text.size() - 2);
  EXPECT_TRUE(text.substr(last + 1).starts_with("Fails: rope_59.T_max")) << text;
  const std::string all = to_terminal(r, {.all = true});
  EXPECT_NE(all.find("rope_0.T_max"), std::string::npos) << "every check";
}

TEST(Terminal, ASummaryDoesNotSayThatAPartWithoutLimitPasses) {
  Result r;
  r.checks = {make_check("drop.T_max", 1, si::N, {.limit = 2, .rule = "breaking force", .trust = "derived"})};
  r.checks[0].part = "drop";
  r.checks[0].limits = false;
  r.unjudged = {"drop"};
  const std::string text = to_terminal(r);
  EXPECT_NE(text.find("not judged  drop.T_max"), std::string::npos) << text;
  EXPECT_NE(text.find("part has no strength limit"), std::string::npos) << text;
  EXPECT_EQ(text.find("passes"), std::string::npos) << text;
}

TEST(Terminal, ASummaryShowsThePrintedValuesThatAreUnsafe) {
  Result r;
  for (int k = 0; k < 60; ++k) {
    r.comparisons.push_back({fmt::format("rope_{}", k), "T", si::N, 1, 2, 3, "corrected", k == 40});
  }
  const std::string text = to_terminal(r);
  EXPECT_NE(text.find("rope_40       0.001"), std::string::npos) << text;
  EXPECT_EQ(text.find("rope_41"), std::string::npos) << text;
  EXPECT_NE(text.find("52 more comparisons"), std::string::npos) << text;
}

TEST(Terminal, ASummarySaysWhereACutWarningIsWhole) {
  Result r;
  r.warnings = {"the mainline goes slack " + std::string(200, 'x')};
  EXPECT_NE(to_terminal(r).find("In full: --all"), std::string::npos);
}

}  // namespace terminal_test
