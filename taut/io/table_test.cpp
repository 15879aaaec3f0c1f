#include "taut/io/table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "taut/base/long_rows.hpp"

namespace taut::io::table_test {

TEST(TableCsv, WritesUnitsInTheHeaderAndQuotesWhatNeedsIt) {
  const Table t{
      .name = "extension",
      .title = "Extension",
      .columns = {{.name = "boom_length", .unit = si::m},
                  {.name = "case", .unit = si::one},
                  {.name = "moment, luffing", .unit = si::N_m}},
      .rows = {{9.0, std::string("rated, 8 falls"), 0.1}, {std::nan(""), std::string("say \"no\"\nnow"), 1e300}}};
  EXPECT_EQ(to_csv(t),
            "boom_length [m],case,\"moment, luffing [N m]\"\r\n"
            "9,\"rated, 8 falls\",0.1\r\n"
            ",\"say \"\"no\"\"\nnow\",1e+300\r\n");
}

TEST(TableCsv, WritesTheUnitsOfTheReport) {
  const Table t{.name = "t",
                .title = "",
                .columns = {{.name = "T_max", .unit = si::N},
                            {.name = "d", .unit = si::m.in("mm")},
                            {.name = "slope", .unit = si::rad},
                            {.name = "T", .unit = si::K.in("degC")},
                            {.name = "n", .unit = si::one}},
                .rows = {{42800.0, 0.016, std::numbers::pi / 4, 253.15, 0.1 + 0.2}}};
  EXPECT_EQ(to_csv(t, Display()), "T_max [kN],d [mm],slope [deg],T [degC],n\r\n42.8,16,45,-20,0.30000000000000004\r\n");
  EXPECT_EQ(to_csv(t, Display({{"force", "N"}, {"length", "m"}, {"angle", "%"}})),
            "T_max [N],d [m],slope [%],T [degC],n\r\n42800,0.016,100,-20,0.30000000000000004\r\n");
  EXPECT_EQ(to_csv(t).substr(0, 29), "T_max [N],d [m],slope [rad],T");
}

TEST(TableCsv, NumbersReadBackBitByBit) {
  for (const double x : {1.0 / 3.0, 0.1 + 0.2, 5e-324, -std::numeric_limits<double>::max(), 123456789.123456789}) {
    const std::string csv =
        to_csv({.name = "t", .title = "", .columns = {{.name = "x", .unit = si::one}}, .rows = {{x}}});
    EXPECT_EQ(std::strtod(csv.c_str() + 3, nullptr), x) << csv;
  }
}

TEST(TableCsv, LongRowsAreWrittenAsOthersPieceByPiece) {
  Table t{
      .name = "time", .title = "", .columns = {{.name = "t", .unit = si::s}, {.name = "x", .unit = si::m}}, .rows = {}};
  Table same = t;
  const auto rows = std::make_shared<LongRows>(2);
  for (int i = 0; i < 20'000; ++i) {
    const double x = i % 7 == 0 ? std::nan("") : std::sqrt(i);
    rows->add({0.1 * i, x});
    same.rows.push_back({0.1 * i, x});
  }
  t.long_rows = rows;
  int pieces = 0;
  std::string csv;
  to_csv(t, [&](const std::string& piece) {
    ++pieces;
    csv += piece;
  });
  EXPECT_EQ(csv, to_csv(same));
  EXPECT_GT(pieces, 3);
}

TEST(Series, CurvesOverTheSameXStandBesideEachOther) {
  const Plot p{.name = "forces",
               .title = "Forces",
               .caption = "",
               .x = {.label = "boom length", .unit = si::m},
               .y = {.label = "force", .unit = si::N},
               .curves = {{.label = "S1", .x = {9, 10}, .y = {1, 2}, .dashed = false, .points_only = false},
                          {.label = "S1", .x = {9, 10}, .y = {3, std::nan("")}, .dashed = true, .points_only = false}},
               .marks = {}};
  const Table t = series_table(p);
  ASSERT_EQ(t.columns.size(), 3U);
  EXPECT_EQ(t.name, "forces");
  EXPECT_EQ(t.columns[0].name, "boom_length");
  EXPECT_EQ(t.columns[1].name, "S1");
  EXPECT_EQ(t.columns[2].name, "S1_2") << "no two columns of one name";
  ASSERT_EQ(t.rows.size(), 2U);
  EXPECT_EQ(to_csv(t), "boom_length [m],S1 [N],S1_2 [N]\r\n9,1,3\r\n10,2,\r\n");
}

TEST(Series, CurvesOverDifferentXStandBelowEachOther) {
  const Plot p{.name = "grip",
               .title = "Grip",
               .caption = "",
               .x = {.label = "speed", .unit = si::m_per_s},
               .y = {.label = "grip", .unit = si::one},
               .curves = {{.label = "a", .x = {1, 2}, .y = {5, 6}, .dashed = false, .points_only = false},
                          {.label = "b", .x = {3}, .y = {7}, .dashed = false, .points_only = false}},
               .marks = {}};
  EXPECT_EQ(to_csv(series_table(p)), "curve,speed [m/s],grip\r\na,1,5\r\na,2,6\r\nb,3,7\r\n");
}

TEST(Series, ShortOrNoCurvesAreHarmless) {
  EXPECT_EQ(to_csv(series_table(Plot{})), "\r\n");
  const Plot p{.name = "p",
               .title = "",
               .caption = "",
               .x = {.label = "x", .unit = si::m},
               .y = {.label = "y", .unit = si::m},
               .curves = {{.label = "", .x = {1, 2}, .y = {5}, .dashed = false, .points_only = false}},
               .marks = {}};
  EXPECT_EQ(to_csv(series_table(p)), "x [m],y [m]\r\n1,5\r\n2,\r\n");
}

TEST(Series, NamesColumnsByTheirLabels) {
  EXPECT_EQ(column_name("boom length"), "boom_length");
  EXPECT_EQ(column_name("S1, extension (last)"), "S1_extension_last");
  EXPECT_EQ(column_name(""), "value");
  EXPECT_EQ(column_name("µ_s"), "µ_s");
}

TEST(TableCsv, TextsAreNoFormulas) {
  Table t;
  t.columns = {{.name = "=a", .unit = si::one}, {.name = "b", .unit = si::m}};
  t.rows = {{std::string("=1+1"), -1.0}, {std::string("+x"), 2.0},  {std::string("-x,y"), -1e-9},
            {std::string("@x"), 0.0},    {std::string("\tx"), 0.0}, {std::string("\rx"), 0.0},
            {std::string("a=1"), 0.0},   {std::string(), 0.0}};
  EXPECT_EQ(to_csv(t),
            "'=a,b [m]\r\n'=1+1,-1\r\n'+x,2\r\n\"'-x,y\",-1e-09\r\n'@x,0\r\n'\tx,0\r\n\"'\rx\",0\r\na=1,0\r\n,0\r\n");
}

}  // namespace taut::io::table_test
