#include "taut/io/json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>
#include <unordered_map>

#include "taut/base/version.hpp"
#include "taut/calc/comparison.hpp"
#include "taut/calc/shown.hpp"
#include "taut/calc/verdict.hpp"
#include "taut/io/table.hpp"

namespace taut::io {
namespace {

using Json = nlohmann::ordered_json;

Json number(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

Json cell(const Cell& c) {
  if (const auto* text = std::get_if<std::string>(&c)) return *text;
  return number(std::get<double>(c));
}

Json columns(const std::vector<Column>& all) {
  Json list = Json::array();
  for (const Column& c : all) list.push_back({{"name", c.name}, {"unit", c.unit.symbol}});
  return list;
}

/// With the units that the CSV file has in its heads.
Json columns(const std::vector<Column>& all, const Display& display) {
  Json list = Json::array();
  for (const Column& c : all) {
    const std::string unit = shown_unit(c.unit, display).name;
    list.push_back({{"name", c.name}, {"unit", unit.empty() ? std::string(si::one.symbol) : unit}});
  }
  return list;
}

Json values(const std::vector<Value>& all) {
  // an object looks through all its members for a name: thousands of values are put beside each other instead
  Json map = Json::object();
  auto& members = map.get_ref<Json::object_t&>();
  std::unordered_map<std::string_view, std::size_t> places;
  for (const Value& v : all) {
    Json one = {{"value", number(v.value)},
                {"unit", v.unit.symbol},
                {"symbol", v.symbol},
                {"label", v.label},
                {"source", v.source}};
    const auto [place, is_new] = places.try_emplace(v.name, members.size());
    if (is_new) {
      members.push_back({v.name, std::move(one)});
    } else {
      (members.begin() + static_cast<std::ptrdiff_t>(place->second))->second = std::move(one);
    }
  }
  return map;
}

Json table(const Table& t) {
  Json rows = Json::array();
  for (const auto& row : t.rows) {
    Json cells = Json::array();
    for (const Cell& c : row) cells.push_back(cell(c));
    rows.push_back(std::move(cells));
  }
  return {{"columns", columns(t.columns)}, {"rows", std::move(rows)}};
}

Json tables(const Result& r) {
  Json map = Json::object();
  for (const Table& t : r.tables) map[t.name] = table(t);
  if (!r.comparisons.empty()) {
    const Table comparison = comparison_table(r.comparisons);
    if (!map.contains(comparison.name)) map[comparison.name] = table(comparison);
  }
  return map;
}

Json checks(const std::vector<Check>& all) {
  Json list = Json::array();
  for (const Check& c : all) {
    list.push_back({{"name", c.name},
                    {"value", number(c.value)},
                    {"limit", number(c.limit)},
                    {"unit", c.unit.symbol},
                    {"utilisation", number(c.utilisation)},
                    {"passes", c.passes},
                    {"rule", c.rule},
                    {"trust", c.trust}});
    if (!c.part.empty()) list.back()["part"] = c.part;
  }
  return list;
}

Json steps(const std::vector<Step>& all) {
  Json list = Json::array();
  for (const Step& s : all) {
    if (s.symbol.empty()) continue;
    list.push_back({{"eq", s.eq},
                    {"symbol", s.symbol},
                    {"formula", formula_text(s.formula)},
                    {"numbers", numbers_text(s.formula)},
                    {"value", number(s.value)},
                    {"unit", s.unit.symbol},
                    {"source", s.source}});
  }
  return list;
}

Json series(const Result& r, SeriesFiles files) {
  Json map = Json::object();
  const auto file = [&](const std::string& name, bool in_csv) {
    if (files == SeriesFiles::none) return Json(nullptr);
    return Json(in_csv ? fmt::format("{}.csv", name) : "series.h5");
  };
  const Display display = display_of(r);
  const auto plot_of = [&](const Table& t) -> Json {
    return {{"columns", files == SeriesFiles::named ? columns(t.columns, display) : columns(t.columns)},
            {"file", file(t.name, true)}};
  };
  for (const Table& t : r.series) map[t.name] = {{"columns", columns(t.columns)}, {"file", file(t.name, !t.detail)}};
  for (const Figure& f : r.figures) {
    if (const auto* profile = std::get_if<Profile>(&f)) {
      map[profile->name] = plot_of(series_table(*profile));
    }
    const auto* plot = std::get_if<Plot>(&f);
    if (plot == nullptr || plot->name.empty()) continue;
    map[plot->name] = plot_of(series_table(*plot));
  }
  return map;
}

/// The texts that the deck gives.
Json project(const Project& given) {
  Json map = Json::object();
  for (const Field& f : Project::describe().fields) {
    Project copy = given;
    const std::string& text = *std::get<std::string*>(f.slot(&copy));
    if (!text.empty()) map[f.key] = text;
  }
  return map;
}

Json answers(const std::vector<Answer>& all) {
  Json list = Json::array();
  for (const Answer& a : all) list.push_back({{"label", a.label}, {"text", a.text}});
  return list;
}

/// Names of the figures of a report, in its order; some have none.
Json figures(const std::vector<Figure>& all) {
  Json list = Json::array();
  for (const Figure& f : all) list.push_back(std::visit([](const auto& one) { return one.name; }, f));
  return list;
}

/// A text that is not UTF-8 (a file's name) must not stop the result.
std::string written(const Json& j) { return j.dump(1, ' ', false, Json::error_handler_t::replace) + "\n"; }

Json errors(const Diagnostics& all) {
  Json list = Json::array();
  for (const Diagnostic& d : all) {
    list.push_back({{"file", d.file}, {"line", d.place.line}, {"column", d.place.column}, {"message", d.message}});
  }
  return list;
}

}  // namespace

std::string to_json(const Result& r, SeriesFiles files) {
  Json j;
  j["taut"] = {{"version", version}, {"format", result_format}};
  if (!r.deck_hash.empty()) j["taut"]["deck_hash"] = r.deck_hash;
  if (!r.deck_hash.empty()) j["taut"]["overrides"] = r.overrides;
  j["title"] = r.title;
  j["method"] = r.method;
  j["status"] = to_text(r.status);
  j["message"] = r.message;
  const auto verdict = verdict_of(r);
  j["verdict"] = verdict ? Json(to_text(verdict->kind)) : Json(nullptr);
  j["verdict_class"] = verdict && !verdict->verdict_class.empty() ? Json(verdict->verdict_class) : Json(nullptr);
  j["verdict_reason"] = verdict ? Json(verdict->reason) : Json(nullptr);
  j["values"] = values(r.values);
  j["tables"] = tables(r);
  j["checks"] = checks(r.checks);
  j["steps"] = steps(r.steps);
  j["series"] = series(r, files);
  j["warnings"] = r.warnings;
  j["errors"] = errors(r.errors);
  j["project"] = project(r.project);
  j["answers"] = answers(r.answers);
  j["key_figure"] = r.key_figure;
  j["figures"] = figures(r.figures);
  return written(j);
}

std::string to_json(const Diagnostics& mistakes) {
  Json j;
  j["taut"] = {{"version", version}, {"format", result_format}};
  j["status"] = to_text(mistakes.empty() ? Status::ok : Status::bad_deck);
  j["errors"] = errors(mistakes);
  return written(j);
}

}  // namespace taut::io
