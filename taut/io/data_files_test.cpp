#include "taut/io/data_files.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "taut/io/json.hpp"

namespace taut::io::data_files_test {

Table table_named(std::string name) {
  return {.name = std::move(name), .title = "", .columns = {{.name = "x", .unit = si::m}}, .rows = {{1.0}}};
}

Plot plot_named(std::string name) {
  return {.name = std::move(name),
          .title = "",
          .caption = "",
          .x = {.label = "x", .unit = si::m},
          .y = {.label = "y", .unit = si::m},
          .curves = {{.label = "y", .x = {0, 1}, .y = {1, 2}}},
          .marks = {}};
}

Profile profile_named(std::string name) {
  Profile profile;
  profile.name = std::move(name);
  return profile;
}

Drawing drawing_named(std::string name) {
  Drawing drawing;
  drawing.name = std::move(name);
  return drawing;
}

std::vector<std::string> names_of(const Result& r) {
  std::vector<std::string> all;
  all.reserve(r.tables.size() + r.series.size() + r.figures.size());
  for (const Table& t : r.tables) all.push_back(t.name);
  for (const Table& t : r.series) all.push_back(t.name);
  for (const Figure& f : r.figures) all.push_back(std::visit([](const auto& one) { return one.name; }, f));
  return all;
}

TEST(DataFiles, WhatHasANameOfItsOwnKeepsIt) {
  Result r;
  r.tables = {table_named("load_path"), table_named("closure")};
  r.series = {table_named("time")};
  r.figures = {plot_named("load_path_profile"), plot_named(""), plot_named(""), drawing_named("closure")};
  const auto before = names_of(r);
  EXPECT_TRUE(named_apart(r)) << "a plot without a name has no file, nor has a drawing";
  name_apart(r);
  EXPECT_EQ(names_of(r), before);
}

// A load path that the deck calls `profile` has a table with the name of the picture of the unnamed one.
TEST(DataFiles, APictureGivesWayToATable) {
  Result r;
  r.tables = {table_named("load_path"), table_named("load_path_profile")};
  r.series = {table_named("time")};
  r.figures = {profile_named("load_path_profile"), plot_named("time"), plot_named("time_plot"), plot_named("time")};
  r.key_figure = "load_path_profile";
  ASSERT_FALSE(named_apart(r));
  name_apart(r);
  EXPECT_TRUE(named_apart(r));
  const std::vector<std::string> expected = {"load_path",   "load_path_profile", "time",       "load_path_profile_plot",
                                             "time_plot_2", "time_plot",         "time_plot_3"};
  EXPECT_EQ(names_of(r), expected);
  EXPECT_EQ(r.key_figure, "load_path_profile_plot") << "page 1 goes on to show it";
  const std::string json = to_json(r, SeriesFiles::named);
  EXPECT_NE(json.find("\"load_path_profile_plot.csv\""), std::string::npos);
}

// A rope may be called as its user likes, and its tables have its name.
TEST(DataFiles, NamesThatNoFileCanHaveAreMended) {
  Result r;
  const std::string letters(150, 'x');
  std::string long_name = "life_";
  for (int i = 0; i < 120; ++i) long_name += "\u043e";  // two bytes each
  r.tables = {table_named("discard_main/left"), table_named("discard_main_left"), table_named(".."),
              table_named("life_a\\b?c#d%e:f"), table_named(letters + letters),   table_named(long_name)};
  r.series = {table_named("time_../../x")};
  r.figures = {plot_named("discard_main/left"), plot_named("\u043e\u043f\u043e\u0440\u0430")};
  r.key_figure = "discard_main/left";
  r.scenes.resize(1);
  r.scenes[0].name = "motion_a/b";
  ASSERT_FALSE(named_apart(r));
  name_apart(r);
  EXPECT_TRUE(named_apart(r));
  const std::string cut = long_name.substr(0, 199);  // 5 + 2 * 97 bytes: no half of a letter
  const std::vector<std::string> expected = {"discard_main_left",
                                             "discard_main_left_2",
                                             "_.",
                                             "life_a_b_c_d_e_f",
                                             (letters + letters).substr(0, 200),
                                             cut,
                                             "time_.._.._x",
                                             "discard_main_left_plot",
                                             "\u043e\u043f\u043e\u0440\u0430"};
  EXPECT_EQ(names_of(r), expected);
  EXPECT_EQ(r.key_figure, "discard_main_left_plot");
  EXPECT_EQ(r.scenes[0].name, "motion_a_b");
}

TEST(DataFiles, TablesOfOneNameAreNumbered) {
  Result r;
  r.tables = {table_named("sweep"), table_named("sweep"), table_named("sweep_2"), table_named("comparison")};
  r.comparisons.push_back({.quantity = "pull", .symbol = "P", .unit = si::N, .build_by = ""});
  name_apart(r);
  const std::vector<std::string> expected = {"sweep", "sweep_3", "sweep_2", "comparison_2"};
  EXPECT_EQ(names_of(r), expected) << "comparison.csv has the printed values beside the exact ones";
}

}  // namespace taut::io::data_files_test
