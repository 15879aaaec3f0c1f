#include "taut/catalogue/csv.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "taut/base/expects.hpp"

namespace taut::catalogue::csv_test {

struct Row {
  std::string id;
  double diameter;
  std::string note;
};

struct Reading {
  std::vector<Row> rows;
  Diagnostics diagnostics;
};

Reading read(std::string_view text) {
  CsvReader csv(text, "t.csv", {{.name = "id"}, {.name = "d_mm"}, {.name = "note", .required = false}});
  Reading out;
  while (csv.next()) out.rows.push_back({csv.unique("id"), csv.positive("d_mm"), csv.text("note")});
  out.diagnostics = csv.take_diagnostics();
  return out;
}

/// The mistakes as "line:column message".
std::vector<std::string> mistakes(std::string_view text) {
  std::vector<std::string> out;
  for (const Diagnostic& d : read(text).diagnostics) {
    out.push_back(fmt::format("{}:{} {}", d.place.line, d.place.column, d.message));
  }
  return out;
}

using Texts = std::vector<std::string>;

TEST(Csv, reads_numbers_in_si_and_texts) {
  const Reading r = read("id,d_mm,note\nA,16,thick\nB, 4.1 ,\n");
  ASSERT_TRUE(r.diagnostics.empty());
  ASSERT_EQ(r.rows.size(), 2U);
  EXPECT_EQ(r.rows[0].id, "A");
  EXPECT_EQ(r.rows[0].diameter, 0.016);
  EXPECT_EQ(r.rows[0].note, "thick");
  EXPECT_DOUBLE_EQ(r.rows[1].diameter, 0.0041);
  EXPECT_EQ(r.rows[1].note, "");
}

TEST(Csv, the_order_of_columns_does_not_count_and_optional_ones_may_be_missing) {
  const Reading r = read("d_mm,id\n16,A");
  ASSERT_TRUE(r.diagnostics.empty());
  ASSERT_EQ(r.rows.size(), 1U);
  EXPECT_EQ(r.rows[0].id, "A");
  EXPECT_EQ(r.rows[0].note, "");
}

TEST(Csv, quotes_hold_commas_quotes_and_line_ends) {
  const Reading r = read("id,d_mm,note\r\n\"a, b\",\"16\",\"say \"\"yes\"\"\nor no\"\r\nB,x,\r\n");
  ASSERT_EQ(r.rows.size(), 2U);
  EXPECT_EQ(r.rows[0].id, "a, b");
  EXPECT_EQ(r.rows[0].note, "say \"yes\"\nor no");
  ASSERT_EQ(r.diagnostics.size(), 1U);
  EXPECT_EQ(r.diagnostics[0].place, (Place{4, 3}));  // the line end within the quotes counts as one
  EXPECT_EQ(r.diagnostics[0].source_line, "B,x,");
}

TEST(Csv, byte_order_mark_and_empty_lines_are_nothing) {
  const Reading r = read("\xef\xbb\xbfid,d_mm\n\n\r\nA,16\n\n");
  EXPECT_TRUE(r.diagnostics.empty());
  EXPECT_EQ(r.rows.size(), 1U);
}

TEST(Csv, header_mistakes_all_at_once) {
  EXPECT_EQ(mistakes(""), Texts{"1:1 the table is empty: its first line must name the columns"});
  EXPECT_EQ(mistakes("\n\n"), Texts{"1:1 the table is empty: its first line must name the columns"});
  EXPECT_EQ(mistakes("id,d_mn\nA,16\n"),
            (Texts{"1:4 'd_mn' is not a column of this table; did you mean 'd_mm'?", "1:1 column 'd_mm' is missing"}));
  EXPECT_EQ(mistakes("id,d_mm,id\nA,16,B\n"), Texts{"1:9 column 'id' is there twice"});
  EXPECT_EQ(mistakes("id;d_mm\nA;16\n"), Texts{"1:1 columns are separated by commas, not by semicolons"});
}

TEST(Csv, cells_that_are_not_what_they_should_be) {
  EXPECT_EQ(mistakes("id,d_mm\nA,sixteen\n"), Texts{"2:3 d_mm: 'sixteen' is not a number"});
  EXPECT_EQ(mistakes("id,d_mm\nA,16 mm\n"), Texts{"2:3 d_mm: '16 mm' is not a number"});
  EXPECT_EQ(mistakes("id,d_mm\nA,\"12,5\"\n"),
            Texts{"2:3 d_mm: '12,5' is not a number; write a decimal point, not a comma"});
  EXPECT_EQ(mistakes("id,d_mm\nA,-16\n"), Texts{"2:3 d_mm: -16 must be above 0"});
  EXPECT_EQ(mistakes("id,d_mm\nA,0\n"), Texts{"2:3 d_mm: 0 must be above 0"});
  EXPECT_EQ(mistakes("id,d_mm\nA,nan\n"), Texts{"2:3 d_mm: 'nan' is not a number"});
  EXPECT_EQ(mistakes("id,d_mm\nA,inf\n"), Texts{"2:3 d_mm: 'inf' is not a number"});
  EXPECT_EQ(mistakes("id,d_mm\nA,1e999\n"), Texts{"2:3 d_mm: '1e999' is out of range"});
  EXPECT_EQ(mistakes("id,d_mm\nA,\n"), Texts{"2:3 'd_mm' is empty"});
  EXPECT_EQ(mistakes("id,d_mm\n,16\n"), Texts{"2:1 'id' is empty"});
  EXPECT_EQ(mistakes("id,d_mm\nA,16\nB,18\nA,20\n"), Texts{"4:1 id 'A' is already in line 2"});
  // a name is looked up without its case and blanks
  EXPECT_EQ(mistakes("id,d_mm\nA 1,16\na1,20\n"),
            Texts{"3:1 id 'a1' is already in line 2; capitals and blanks make no other name"});
}

TEST(Csv, records_of_the_wrong_shape) {
  EXPECT_EQ(mistakes("id,d_mm\nA\nB,16,x\nC,16\n"),
            (Texts{"2:1 1 cells, but the header names 2 columns", "3:1 3 cells, but the header names 2 columns"}));
  EXPECT_EQ(mistakes("id,d_mm\n\"A,16\n"), Texts{"2:1 this quote is never closed"});
  EXPECT_EQ(mistakes("id,d_mm\n\"A\"x,16\n"), Texts{"2:4 text after the closing quote of a cell"});
  EXPECT_EQ(mistakes("id,d_mm\nA\"B,16\n"),
            Texts{"2:2 a quote inside a cell: put the whole cell in quotes and double the inner ones"});
  EXPECT_EQ(mistakes(std::string_view("id,d_mm\nA,1\0006\n", 14)),
            Texts{"2:4 a NUL byte: the table must be UTF-8 text"});
}

TEST(Csv, all_mistakes_in_one_run_up_to_a_limit) {
  std::string text = "id,d_mm\n";
  for (int i = 0; i < 200; ++i) text += fmt::format("r{},?\n", i);
  const auto all = mistakes(text);
  ASSERT_EQ(all.size(), CsvReader::most_mistakes + 1);
  EXPECT_EQ(all.back(), "52:5 and more mistakes after this one");
}

TEST(Csv, message_shows_file_line_and_caret) {
  EXPECT_EQ(to_text(read("id,d_mm\nA,16 mm\n").diagnostics),
            "t.csv:2:3: error: d_mm: '16 mm' is not a number\n  A,16 mm\n    ^~~~~\n");
}

TEST(Csv, asking_for_an_undeclared_column_is_our_bug) {
  CsvReader csv("id\nA\n", "t.csv", {{.name = "id"}});
  ASSERT_TRUE(csv.next());
  EXPECT_THROW((void)csv.text("di"), ContractViolation);
}

TEST(Csv, marks_of_trust) {
  CsvReader csv("t\nverified\nderived\nunverified\nsure\n\"\"\n", "t.csv", {{.name = "t"}});
  std::vector<Trust> marks;
  while (csv.next()) marks.push_back(csv.trust("t"));
  EXPECT_EQ(marks, (std::vector<Trust>{Trust::verified, Trust::derived, Trust::unverified, Trust::unverified,
                                       Trust::unverified}));
  EXPECT_EQ(csv.mistakes(), 2U);
}

TEST(Csv, ten_thousand_records) {
  std::string text = "id,d_mm,note\n";
  for (int i = 0; i < 10'000; ++i) text += fmt::format("rope {},{}.5,\"a, b\"\n", i, i + 1);
  const Reading r = read(text);
  EXPECT_TRUE(r.diagnostics.empty());
  ASSERT_EQ(r.rows.size(), 10'000U);
  EXPECT_DOUBLE_EQ(r.rows.back().diameter, 10.0005);
}

TEST(Csv, units_of_column_names) {
  EXPECT_EQ(si_value_of("d_mm", 16.0), 0.016);
  EXPECT_EQ(si_value_of("area_mm2", 131.5), 131.5e-6);
  EXPECT_EQ(si_value_of("Wely_mm3", 2.0), 2e-9);
  EXPECT_EQ(si_value_of("Iy_mm4", 3.0), 3e-12);
  EXPECT_EQ(si_value_of("grade_MPa", 1960.0), 1.96e9);
  EXPECT_EQ(si_value_of("E_GPa", 100.0), 1e11);
  EXPECT_EQ(si_value_of("mbf_kN", 18.76), 18760.0);
  EXPECT_EQ(si_value_of("mass_kg_per_m", 1.5), 1.5);
  EXPECT_EQ(si_value_of("W_kg_per_100m_per_mm2", 0.4), 4000.0);
  EXPECT_EQ(si_value_of("factor", 0.4), 0.4);
}

RC_GTEST_PROP(Csv, any_bytes_are_read_or_refused, (const std::vector<char>& noise)) {
  // A bias towards the signs that carry meaning: letters only would never leave the first branch.
  constexpr std::string_view signs = "\",\n\r;A1.- ";
  std::string text = "id,d_mm\n";
  for (const char c : noise) text += signs[static_cast<unsigned char>(c) % signs.size()];
  const Reading r = read(text);
  for (const Row& row : r.rows) RC_ASSERT(row.diameter > 0.0);
  for (const Diagnostic& d : r.diagnostics) RC_ASSERT(d.place.line >= 1 && d.place.column >= 1);
}

RC_GTEST_PROP(Csv, a_quoted_text_comes_back, (const std::string& any)) {
  std::string text;
  for (const char c : any) text += c == '\0' || c == ' ' || c == '\t' ? 'x' : c;
  std::string quoted;
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  const Reading r = read("id,d_mm,note\nA,1,\"" + quoted + "\"\n");
  RC_ASSERT(r.diagnostics.empty());
  RC_ASSERT(r.rows.size() == 1U);
  RC_ASSERT(r.rows[0].note == text);
}

}  // namespace taut::catalogue::csv_test
