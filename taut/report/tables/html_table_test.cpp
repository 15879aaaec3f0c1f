#include "taut/report/tables/html_table.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace taut::report::html_table_test {

Table wide(std::size_t columns) {
  Table t{.name = "load_path", .title = "Load path", .columns = {}, .rows = {std::vector<Cell>()}};
  for (std::size_t k = 0; k < columns; ++k) {
    t.columns.push_back({fmt::format("c{}", k), si::one});
    t.rows[0].emplace_back(static_cast<double>(k));
  }
  return t;
}

std::size_t times(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

TEST(HtmlTable, StaysWholeWhileItFits) {
  EXPECT_EQ(times(table_html(wide(most_columns), {}), "<table"), 1U);
  EXPECT_EQ(times(table_html(wide(most_columns), {}), "1 of"), 0U);
}

TEST(HtmlTable, WordsThatSayWhatARowIsAboutLeadEachPart) {
  Table t = wide(2 * most_columns);
  t.columns[0].name = "rope";
  t.columns[1].name = "from";
  t.rows[0][0] = "skyline";
  t.rows[0][1] = "tower";
  const std::string html = table_html(t, {});
  EXPECT_EQ(times(html, "<table"), 3U);
  EXPECT_EQ(times(html, "skyline"), 3U);
  EXPECT_EQ(times(html, "tower"), 3U);
}

TEST(HtmlTable, AColumnInWhichNothingStandsIsLeftOut) {
  Table t = wide(4);
  t.rows[0][1] = std::nan("");
  t.rows[0][2] = std::string();
  const std::string html = table_html(t, {});
  EXPECT_EQ(times(html, "<th class=\"num\">"), 2U);
  EXPECT_EQ(times(html, "<td class=\"num\">"), 2U);
}

TEST(HtmlTable, RowsWithUnitsOfTheirOwnAreInUnitsOfPrint) {
  const Table t{.name = "envelope",
                .title = "Envelope (SI)",
                .columns = {{.name = "quantity", .unit = si::one},
                            {.name = "unit", .unit = si::one},
                            {.name = "max", .unit = si::one}},
                .rows = {{std::string("T"), std::string("N"), 22078.4},
                         {std::string("z"), std::string("m"), 3.56648},
                         {std::string("slip"), std::string("m"), 2.8e-13}}};
  const std::string html = table_html(t, {});
  EXPECT_EQ(times(html, ">3.566<"), 1U);
  EXPECT_EQ(times(html, ">22.08<"), 1U);
  EXPECT_EQ(times(html, ">kN<"), 1U);
  EXPECT_EQ(times(html, "(SI)"), 0U);
  EXPECT_EQ(times(html, ">0<"), 1U) << "what rounding leaves";
}

TEST(HtmlTable, WithoutRowsIsNotShown) {
  Table t = wide(3);
  t.rows.clear();
  EXPECT_EQ(table_html(t, {}), "");
}

TEST(HtmlTable, ComesInPartsThatRepeatTheFirstColumn) {
  const std::string html = table_html(wide(2 * most_columns), {});
  EXPECT_EQ(times(html, "<table"), 3U);
  EXPECT_NE(html.find("Load path (3 of 3)"), std::string::npos);
  EXPECT_EQ(times(html, "<th class=\"num\">"), 2 * most_columns + 2);
}

/// Rows that each begin with a name are a list: they stand below what they are parts of.
TEST(HtmlTable, ALongListHasHeadings) {
  constexpr std::size_t count = 60;
  Table list{.name = "compared",
             .title = "Compared",
             .columns = {{.name = "what", .unit = si::one}, {.name = "taut", .unit = si::one}},
             .rows = {}};
  for (std::size_t i = 0; i < count; ++i) {
    list.rows.push_back({fmt::format("row {}: S{}", i / 3, i % 3), static_cast<double>(i)});
  }
  list.rows.push_back({std::string("alone: Fh"), 7.0});
  const std::string html = table_html(list, {});
  EXPECT_EQ(times(html, "<td>S0</td>"), count / 3);
  EXPECT_EQ(times(html, "class=\"part\""), count / 3);
  EXPECT_EQ(times(html, ">row 17</th>"), 1U);
  EXPECT_EQ(times(html, "<tbody"), times(html, "</tbody"));
  EXPECT_EQ(times(html, "<td>alone: Fh</td>"), 1U);
  list.rows.resize(30);  // short enough without headings
  EXPECT_EQ(times(table_html(list, {}), "class=\"part\""), 0U);
  EXPECT_EQ(times(table_html(list, {}), "<td>row 3: S1</td>"), 1U);
}

TEST(HtmlTable, SaysWhatItLeavesOutAndWhereItIs) {
  Table t = wide(2 * most_columns);
  EXPECT_EQ(table_html(t, {}).find(".csv"), std::string::npos);
  for (int i = 0; i < 90; ++i) t.rows.push_back(t.rows[0]);
  const std::string html = table_html(t, {}, {.rows = 12, .parts = 1});
  EXPECT_EQ(times(html, "<table"), 1U);
  EXPECT_EQ(times(html, "<tr>"), 13U);
  EXPECT_NE(html.find("12 of 91 rows: ends, extremes, changes; columns up to c10; all in <a href=\"load_path.csv\">"),
            std::string::npos)
      << html;
}

TEST(HtmlTable, LongNamesAndWordsTakeFewerColumnsToAPage) {
  Table t = wide(6);
  for (Column& c : t.columns) c.name = "analyses.payload.limits.mainline." + c.name;
  EXPECT_EQ(times(table_html(t, {}), "<table"), 5U);
  t = wide(6);
  for (std::size_t k = 3; k < 6; ++k) t.rows[0][k] = std::string(60, 'x');
  EXPECT_EQ(times(table_html(t, {}), "<table"), 3U);
  for (std::size_t k = 3; k < 6; ++k) t.rows[0][k] = "words that break into lines where there is no room for them all";
  EXPECT_EQ(times(table_html(t, {}), "<table"), 1U);
}

}  // namespace taut::report::html_table_test
