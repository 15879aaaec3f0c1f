#include "taut/io/json.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "taut/calc/formula.hpp"

namespace taut::io::json_test {

Result sample() {
  Result r;
  r.title = "Title";
  r.method = "mast_section";
  r.message = "fine";
  r.values = {{.name = "P_s",
               .value = 1.0 / 3.0,
               .unit = si::N,
               .symbol = "P_s",
               .label = "force of the mast",
               .source = "(4)"},
              {.name = "A", .value = std::nan(""), .unit = si::m2, .symbol = "A", .label = "area", .source = "(5)"}};
  r.tables = {{.name = "sweep",
               .title = "Sweep",
               .columns = {{.name = "x", .unit = si::m}, {.name = "note", .unit = si::one}},
               .rows = {{1.5, std::string("a")}, {std::nan(""), std::string()}}}};
  r.checks = {
      make_check("D/d", 22, si::one, {.sense = Sense::at_least, .limit = 20, .rule = "rule", .trust = "verified"}),
      make_check("q", 1, si::one, {.sense = Sense::at_most, .limit = 0, .rule = "rule", .trust = "user"})};
  Step heading;
  heading.kind = Step::Kind::heading;
  heading.words = "Forces";
  Step note = heading;
  note.kind = Step::Kind::note;
  note.words = "a note";
  r.steps = {heading,
             {.kind = Step::Kind::given,
              .eq = "",
              .symbol = "m",
              .formula = {},
              .value = 1.2,
              .unit = si::one,
              .source = "input",
              .words = "ratio"},
             {.kind = Step::Kind::equation,
              .eq = "4",
              .symbol = "P_s",
              .formula = make_node(Op::multiply, {make_symbol("m", 1.2), make_number(2)}, 2.4),
              .value = 2.4,
              .unit = si::N,
              .source = "Paper, (4)",
              .words = ""},
             note};
  r.comparisons = {{.quantity = "force",
                    .symbol = "P_s",
                    .unit = si::N,
                    .printed = 1,
                    .corrected = 2,
                    .exact = std::nan(""),
                    .build_by = "corrected: because",
                    .printed_unsafe = true}};
  r.figures = {Plot{.name = "sizes",
                    .title = "",
                    .caption = "",
                    .x = {.label = "x", .unit = si::m},
                    .y = {.label = "y", .unit = si::m},
                    .curves = {{.label = "a", .x = {1}, .y = {2}, .dashed = false, .points_only = false}},
                    .marks = {}},
               Drawing{}};
  r.warnings = {"look out"};
  r.errors = {{.file = "deck.yaml",
               .place = {.line = 12, .column = 15},
               .message = "wrong",
               .source_line = "line",
               .width = 3}};
  return r;
}

TEST(Json, MistakesHaveNoVerdict) {
  Diagnostic bad;
  bad.message = "no such key";
  EXPECT_EQ(nlohmann::ordered_json::parse(to_json(Diagnostics{}))["status"], "ok");
  const auto j = nlohmann::ordered_json::parse(to_json(Diagnostics{bad}));
  EXPECT_EQ(j["status"], "bad_deck");
  EXPECT_EQ(j["errors"][0]["message"], "no such key");
  EXPECT_FALSE(j.contains("verdict"));
}

TEST(Json, HasTheShapeOfTheContractInItsOrder) {
  const auto j = nlohmann::ordered_json::parse(to_json(sample(), SeriesFiles::named));
  std::vector<std::string> keys;
  for (const auto& [key, value] : j.items()) keys.push_back(key);
  EXPECT_EQ(keys, (std::vector<std::string>{"taut", "title", "method", "status", "message", "verdict", "verdict_class",
                                            "verdict_reason", "values", "tables", "checks", "steps", "series",
                                            "warnings", "errors", "project", "answers", "key_figure", "figures"}));
  EXPECT_EQ(j["taut"].dump(), R"({"version":"0.1.0","format":2})");
  EXPECT_EQ(j["status"], "ok");
  EXPECT_EQ(j["values"]["P_s"].dump(),
            R"x({"value":0.3333333333333333,"unit":"N","symbol":"P_s","label":"force of the mast","source":"(4)"})x");
  EXPECT_TRUE(j["values"]["A"]["value"].is_null());
  EXPECT_EQ(j["tables"]["sweep"].dump(),
            R"({"columns":[{"name":"x","unit":"m"},{"name":"note","unit":"1"}],"rows":[[1.5,"a"],[null,""]]})");
  EXPECT_EQ(j["tables"]["comparison"]["rows"].dump(), R"([["force","P_s","N",1.0,2.0,null,"corrected: because"]])");
  EXPECT_EQ(j["checks"][0]["name"], "D/d");
  EXPECT_EQ(j["checks"][0]["passes"], true);
  EXPECT_TRUE(j["checks"][1]["utilisation"].is_null()) << "1/0";
  ASSERT_EQ(j["steps"].size(), 2U) << "headings and notes have no symbol";
  EXPECT_EQ(j["steps"][0]["symbol"], "m");
  EXPECT_EQ(
      j["steps"][1].dump(),
      R"x({"eq":"4","symbol":"P_s","formula":"m*2","numbers":"1.2*2","value":2.4,"unit":"N","source":"Paper, (4)"})x");
  EXPECT_EQ(j["series"].dump(),
            R"({"sizes":{"columns":[{"name":"x","unit":"m"},{"name":"a","unit":"m"}],"file":"sizes.csv"}})");
  EXPECT_EQ(j["warnings"].dump(), R"(["look out"])");
  EXPECT_EQ(j["errors"].dump(), R"([{"file":"deck.yaml","line":12,"column":15,"message":"wrong"}])");
}

// Programs read the numbers of a plot from its file: the units are those in the heads there.
TEST(Json, APlotHasTheUnitsOfItsFile) {
  Result r = sample();
  r.display = {{"length", "ft"}};
  std::get<Plot>(r.figures[0]).x.unit = si::K.in("degC");
  r.series = {{.name = "time", .title = "", .columns = {{.name = "z", .unit = si::m}}, .rows = {}},
              {.name = "cases", .title = "", .columns = {{.name = "z", .unit = si::m}}, .rows = {}, .detail = true}};
  const auto series = [&](SeriesFiles files) { return nlohmann::ordered_json::parse(to_json(r, files))["series"]; };
  const auto shown = series(SeriesFiles::named);
  EXPECT_EQ(shown["sizes"]["columns"].dump(), R"([{"name":"x","unit":"degC"},{"name":"a","unit":"ft"}])");
  EXPECT_EQ(shown["time"].dump(), R"({"columns":[{"name":"z","unit":"m"}],"file":"time.csv"})") << "SI always";
  EXPECT_EQ(shown["cases"]["file"], "series.h5") << "no CSV file has it";
  EXPECT_EQ(series(SeriesFiles::named_si)["sizes"]["columns"].dump(),
            R"([{"name":"x","unit":"K"},{"name":"a","unit":"m"}])");
}

TEST(Json, WithoutFilesTheSeriesNameNone) {
  EXPECT_TRUE(nlohmann::ordered_json::parse(to_json(sample()))["series"]["sizes"]["file"].is_null());
}

TEST(Json, AnEmptyResultHasEveryKey) {
  Result r;
  r.status = Status::bad_deck;
  const auto j = nlohmann::ordered_json::parse(to_json(r));
  EXPECT_EQ(j["status"], "bad_deck");
  EXPECT_EQ(j["values"].dump(), "{}");
  EXPECT_EQ(j["tables"].dump(), "{}");
  EXPECT_EQ(j["errors"].dump(), "[]");
}

TEST(Json, NumbersReadBackBitByBitAndOthersAreNull) {
  for (const double x : {1.0 / 3.0, 0.1 + 0.2, 5e-324, -0.0, 1e22, std::numeric_limits<double>::max()}) {
    Result r;
    r.values = {{.name = "x", .value = x, .unit = si::one, .symbol = "x", .label = "", .source = ""}};
    const double back = nlohmann::ordered_json::parse(to_json(r))["values"]["x"]["value"].get<double>();
    EXPECT_EQ(back, x);
    EXPECT_EQ(std::signbit(back), std::signbit(x));
  }
  Result r;
  r.values = {{.name = "x",
               .value = -std::numeric_limits<double>::infinity(),
               .unit = si::one,
               .symbol = "x",
               .label = "",
               .source = ""}};
  EXPECT_TRUE(nlohmann::ordered_json::parse(to_json(r))["values"]["x"]["value"].is_null());
}

TEST(Json, TextsThatAreNotUtf8DoNotStopIt) {
  Result r;
  r.title = "a\xFF\x01 \"b\"";
  EXPECT_EQ(nlohmann::ordered_json::parse(to_json(r))["title"], "a\xEF\xBF\xBD\x01 \"b\"");
}

}  // namespace taut::io::json_test
