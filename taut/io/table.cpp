#include "taut/io/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <vector>

#include "taut/base/long_rows.hpp"
#include "taut/calc/shown.hpp"

namespace taut::io {
namespace {

constexpr const char* line_end = "\r\n";

/// What a spreadsheet takes for the beginning of a formula is led by an apostrophe, which makes it a text there.
std::string csv_text(std::string text) {
  if (!text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos)
    text.insert(0, 1, '\'');
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}

/// How the numbers of a column are written: as they are stored, or in a unit of print.
struct CsvColumn {
  std::string head;
  std::optional<ShownUnit> shown;

  std::string number(double x) const {
    if (std::isnan(x)) return {};
    // a factor leaves 0.30000000000000004 of 0.3; the shortest exact text is for numbers that were not converted
    return shown && !shown->name.empty() ? fmt::format("{:.12g}", shown->of(x)) : fmt::format("{}", x);
  }
  std::string cell(const Cell& cell) const {
    if (const auto* text = std::get_if<std::string>(&cell)) return csv_text(*text);
    return number(std::get<double>(cell));
  }
};

/// `display`: null for SI.
std::vector<CsvColumn> csv_columns(const Table& t, const Display* display) {
  std::vector<CsvColumn> all;
  for (const Column& c : t.columns) {
    CsvColumn column;
    if (display != nullptr) column.shown = shown_unit(c.unit, *display);
    std::string unit = c.unit.symbol == "1" ? std::string() : std::string(c.unit.symbol);
    if (column.shown) unit = column.shown->name;
    column.head = csv_text(unit.empty() ? c.name : fmt::format("{} [{}]", c.name, unit));
    all.push_back(std::move(column));
  }
  return all;
}

void write_csv(const Table& t, const Display* display, const std::function<void(const std::string&)>& write) {
  constexpr std::size_t piece = 1 << 16;
  const std::vector<CsvColumn> columns = csv_columns(t, display);
  std::string csv;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (i > 0) csv += ',';
    csv += columns[i].head;
  }
  const auto end_line = [&] {
    csv += line_end;
    if (csv.size() < piece) return;
    write(csv);
    csv.clear();
  };
  end_line();
  for (const auto& row : t.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0) csv += ',';
      csv += columns[i].cell(row[i]);
    }
    end_line();
  }
  if (t.long_rows) {
    t.long_rows->each([&](const double* row) {
      for (std::size_t i = 0; i < t.long_rows->width(); ++i) {
        if (i > 0) csv += ',';
        csv += columns[i].number(row[i]);
      }
      end_line();
    });
  }
  write(csv);
}

/// Names of columns have to differ from each other.
std::string fresh(std::string name, std::set<std::string>& taken) {
  const std::string stem = name;
  for (int i = 2; !taken.insert(name).second; ++i) name = fmt::format("{}_{}", stem, i);
  return name;
}

bool share_x(const std::vector<Curve>& curves) {
  return std::all_of(curves.begin(), curves.end(), [&](const Curve& c) { return c.x == curves.front().x; });
}

double at_or_nothing(const std::vector<double>& all, std::size_t i) { return i < all.size() ? all[i] : std::nan(""); }

}  // namespace

std::string column_name(const std::string& label) {
  std::string name;
  for (char c : label) {
    const bool kept = std::isalnum(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80U ||
                      std::string_view("_-+*/.'").find(c) != std::string_view::npos;
    if (kept) name += c;
    if (!kept && !name.empty() && name.back() != '_') name += '_';
  }
  while (!name.empty() && name.back() == '_') name.pop_back();
  return name.empty() ? "value" : name;
}

void to_csv(const Table& t, const std::function<void(const std::string&)>& write) { write_csv(t, nullptr, write); }

std::string to_csv(const Table& t) {
  std::string csv;
  write_csv(t, nullptr, [&](const std::string& piece) { csv += piece; });
  return csv;
}

std::string to_csv(const Table& t, const Display& display) {
  std::string csv;
  write_csv(t, &display, [&](const std::string& piece) { csv += piece; });
  return csv;
}

Table series_table(const Profile& p) {
  Table t;
  t.name = p.name;
  t.title = p.title;
  t.columns = {{"x", si::m},
               {"z", si::m},
               {"ground", si::m},
               {"clearance", si::m},
               {column_name(p.value.label), p.value.unit},
               {"governs", si::one}};
  for (const Profile::Place& one : p.places) {
    t.rows.push_back({one.x, one.z, one.ground, one.z - one.ground, one.value, one.governs});
  }
  return t;
}

Table series_table(const Plot& p) {
  Table t;
  t.name = p.name;
  t.title = p.title;
  std::set<std::string> taken;
  if (p.curves.empty()) return t;
  if (!share_x(p.curves)) {
    t.columns.push_back({fresh("curve", taken), si::one});
    t.columns.push_back({fresh(column_name(p.x.label), taken), p.x.unit});
    t.columns.push_back({fresh(column_name(p.y.label), taken), p.y.unit});
    for (const Curve& c : p.curves) {
      for (std::size_t i = 0; i < c.x.size(); ++i) t.rows.push_back({c.label, c.x[i], at_or_nothing(c.y, i)});
    }
    return t;
  }
  t.columns.push_back({fresh(column_name(p.x.label), taken), p.x.unit});
  for (const Curve& c : p.curves) {
    t.columns.push_back({fresh(column_name(c.label.empty() ? p.y.label : c.label), taken), p.y.unit});
  }
  for (std::size_t i = 0; i < p.curves.front().x.size(); ++i) {
    std::vector<Cell> row = {p.curves.front().x[i]};
    for (const Curve& c : p.curves) row.emplace_back(at_or_nothing(c.y, i));
    t.rows.push_back(std::move(row));
  }
  return t;
}

}  // namespace taut::io
