#include "taut/calc/quantity.hpp"

#include <gtest/gtest.h>

namespace taut {
namespace {

struct Tackle {
  std::string name;
  double falls = 0, pull = 0;
};

Quantities<Tackle> described() {
  return {{"name", "", si::one, "of the tackle", &Tackle::name},
          {"falls", "n", si::one, "falls of rope", &Tackle::falls},
          {"pull", "F", si::N, "pull on its rope", &Tackle::pull}};
}

const std::vector<Tackle> two = {{.name = "luff", .falls = 4, .pull = 2500}, {.name = "gun", .falls = 3, .pull = 1200}};

TEST(Quantity, MakesATable) {
  const Table t = make_table("tackles", "Tackles", described(), two);
  EXPECT_EQ(t.name, "tackles");
  EXPECT_EQ(t.title, "Tackles");
  ASSERT_EQ(t.columns.size(), 3U);
  EXPECT_EQ(t.columns[2].name, "pull");
  EXPECT_EQ(t.columns[2].unit.symbol, "N");
  ASSERT_EQ(t.rows.size(), 2U);
  EXPECT_EQ(std::get<std::string>(t.rows[1][0]), "gun");
  EXPECT_EQ(std::get<double>(t.rows[1][2]), 1200);
}

TEST(Quantity, AddsLinesToOneTable) {
  Result r;
  for (const Tackle& one : two) add_line(r, "tackles", "Tackles", described(), one);
  ASSERT_EQ(r.tables.size(), 1U);
  EXPECT_EQ(r.tables[0].title, "Tackles");
  EXPECT_EQ(r.tables[0].columns.size(), 3U);
  ASSERT_EQ(r.tables[0].rows.size(), 2U);
  EXPECT_EQ(std::get<double>(r.tables[0].rows[1][1]), 3);
}

TEST(Quantity, MakesAValue) {
  const Value v = make_value(named(described(), "pull"), two[0], "luff", "_2", "hoist");
  EXPECT_EQ(v.name, "luff.pull_2");
  EXPECT_EQ(v.symbol, "luff.pull_2");
  EXPECT_EQ(v.value, 2500);
  EXPECT_EQ(v.label, "pull on its rope of luff (hoist)");
}

TEST(Quantity, IsPickedByNameInTheOrderAsked) {
  std::vector<Column> columns = {{.name = "x", .unit = si::m}};
  add_columns(columns, picked(described(), {"pull", "falls"}), "luff.");
  ASSERT_EQ(columns.size(), 3U);
  EXPECT_EQ(columns[1].name, "luff.pull");
  EXPECT_EQ(columns[2].name, "luff.falls");
  EXPECT_EQ(words_of(joined(picked(described(), {"pull"}), described())).size(), 4U);
}

TEST(Quantity, OfAnUnknownNameIsOurFault) { EXPECT_ANY_THROW(named(described(), "weight")); }

}  // namespace
}  // namespace taut
