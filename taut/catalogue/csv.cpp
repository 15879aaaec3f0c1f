#include "taut/catalogue/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "taut/base/expects.hpp"
#include "taut/base/number.hpp"
#include "taut/base/suggest.hpp"
#include "taut/catalogue/lookup.hpp"

namespace taut::catalogue {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

int width_of(std::string_view text) { return std::max(1, static_cast<int>(text.size())); }

}  // namespace

double si_value_of(std::string_view column, double value) {
  struct Unit {
    std::string_view suffix;
    double multiplier;
    double divisor;
  };
  // Powers of ten that a double holds exactly, dividing by which rounds once. Longest suffix first.
  static constexpr std::array<Unit, 11> units{{{.suffix = "_kg_per_100m_per_mm2", .multiplier = 1e4, .divisor = 1.0},
                                               {.suffix = "_kg_per_m", .multiplier = 1.0, .divisor = 1.0},
                                               {.suffix = "_mm2", .multiplier = 1.0, .divisor = 1e6},
                                               {.suffix = "_mm3", .multiplier = 1.0, .divisor = 1e9},
                                               {.suffix = "_mm4", .multiplier = 1.0, .divisor = 1e12},
                                               {.suffix = "_mm", .multiplier = 1.0, .divisor = 1e3},
                                               {.suffix = "_cm", .multiplier = 1.0, .divisor = 1e2},
                                               {.suffix = "_MPa", .multiplier = 1e6, .divisor = 1.0},
                                               {.suffix = "_GPa", .multiplier = 1e9, .divisor = 1.0},
                                               {.suffix = "_kN", .multiplier = 1e3, .divisor = 1.0},
                                               {.suffix = "_m", .multiplier = 1.0, .divisor = 1.0}}};
  for (const Unit& unit : units) {
    if (column.ends_with(unit.suffix)) return value * unit.multiplier / unit.divisor;
  }
  return value;
}

CsvReader::CsvReader(std::string_view text, std::string file, std::vector<CsvColumn> columns)
    : text_(text), file_(std::move(file)), columns_(std::move(columns)), index_(columns_.size()) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
  check_encoding();
  if (!stopped_) read_header();
}

void CsvReader::check_encoding() {
  const auto nul = text_.find('\0');
  if (nul == std::string_view::npos) return;
  const auto lines = std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(nul), '\n');
  const auto line_start = text_.rfind('\n', nul);
  const std::size_t column = line_start == std::string_view::npos ? nul + 1 : nul - line_start;
  note({.line = static_cast<int>(lines) + 1, .column = static_cast<int>(column)},
       "a NUL byte: the table must be UTF-8 text");
  stopped_ = true;
}

void CsvReader::read_header() {
  if (!read_record()) {
    if (!failed()) note({.line = 1, .column = 1}, "the table is empty: its first line must name the columns");
    stopped_ = true;
    return;
  }
  header_cells_ = cells_;
  if (cells_ == 1 && record_[0].text.find(';') != std::string::npos) {
    note(record_[0].place, "columns are separated by commas, not by semicolons");
    stopped_ = true;
    return;
  }
  std::vector<std::string> names;
  names.reserve(columns_.size());
  for (const CsvColumn& column : columns_) names.emplace_back(column.name);
  for (std::size_t i = 0; i < cells_; ++i) {
    const Cell& head = record_[i];
    const auto found = std::find(names.begin(), names.end(), head.text);
    if (found == names.end()) {
      note(head.place,
           fmt::format("{} is not a column of this table{}", in_quotes(head.text), did_you_mean(head.text, names)),
           width_of(head.text));
      continue;
    }
    std::optional<std::size_t>& index = index_[static_cast<std::size_t>(found - names.begin())];
    if (index) note(head.place, fmt::format("column {} is there twice", in_quotes(head.text)), width_of(head.text));
    index = i;
  }
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (columns_[i].required && !index_[i])
      note({.line = 1, .column = 1}, fmt::format("column '{}' is missing", columns_[i].name));
  }
  // Cells of a table with a broken header would only repeat its mistakes.
  stopped_ = failed();
}

bool CsvReader::next() {
  while (!stopped_ && read_record()) {
    if (cells_ == header_cells_) return true;
    note(record_place_, fmt::format("{} cells, but the header names {} columns", cells_, header_cells_));
  }
  return false;
}

bool CsvReader::at_line_end() const {
  return current() == '\n' || (current() == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n');
}

void CsvReader::advance() {
  if (text_[at_] == '\n') {
    ++place_.line;
    place_.column = 1;
  } else {
    ++place_.column;
  }
  ++at_;
}

void CsvReader::skip_line_end() {
  if (current() == '\r') advance();
  if (current() == '\n') advance();
}

bool CsvReader::read_record() {
  while (at_ < text_.size() && at_line_end()) skip_line_end();
  if (at_ >= text_.size()) return false;
  record_place_ = place_;
  cells_ = 0;
  while (true) {
    if (cells_ == record_.size()) record_.emplace_back();
    read_cell(record_[cells_++]);
    if (stopped_) return false;
    if (current() == ',') {
      advance();
      continue;
    }
    skip_line_end();
    return true;
  }
}

void CsvReader::read_cell(Cell& cell) {
  cell.text.clear();
  cell.place = place_;
  if (current() == '"') return read_quoted(cell);
  const std::size_t from = at_;
  while (at_ < text_.size() && current() != ',' && !at_line_end()) {
    if (current() == '"') note(place_, "a quote inside a cell: put the whole cell in quotes and double the inner ones");
    advance();
  }
  const std::string_view raw = text_.substr(from, at_ - from);
  const std::string_view bare = trimmed(raw);
  if (!bare.empty()) cell.place.column += static_cast<int>(bare.data() - raw.data());
  cell.text.assign(bare);
}

void CsvReader::read_quoted(Cell& cell) {
  advance();
  while (true) {
    if (at_ >= text_.size()) {
      note(cell.place, "this quote is never closed");
      stopped_ = true;
      return;
    }
    if (current() != '"') {
      cell.text += current();
      advance();
      continue;
    }
    advance();
    if (current() != '"') break;
    cell.text += '"';
    advance();
  }
  if (at_ < text_.size() && current() != ',' && !at_line_end()) {
    note(place_, "text after the closing quote of a cell");
    while (at_ < text_.size() && current() != ',' && !at_line_end()) advance();
  }
  cell.text = std::string(trimmed(cell.text));
}

void CsvReader::note(Place place, std::string message, int width) {
  if (diagnostics_.size() > most_mistakes) return;
  if (diagnostics_.size() == most_mistakes) {
    diagnostics_.push_back({file_, place, "and more mistakes after this one", {}, 1});
    stopped_ = true;
    return;
  }
  // Only a mistake pays for finding its line again. With the line's start at hand it would have to be kept for each
  // cell.
  std::size_t start = 0;
  for (int line = 1; line < place.line && start < text_.size(); ++line) {
    const auto end = text_.find('\n', start);
    start = end == std::string_view::npos ? text_.size() : end + 1;
  }
  std::string_view line = text_.substr(start, text_.find('\n', start) - start);
  if (line.ends_with('\r')) line.remove_suffix(1);
  diagnostics_.push_back({file_, place, std::move(message), std::string(line), width});
}

const CsvReader::Cell* CsvReader::cell(std::string_view column) const {
  const auto found =
      std::find_if(columns_.begin(), columns_.end(), [&](const CsvColumn& c) { return c.name == column; });
  expects(found != columns_.end(), "the column was declared when the reader was made");
  const auto index = index_[static_cast<std::size_t>(found - columns_.begin())];
  return index ? &record_[*index] : nullptr;
}

const std::string& CsvReader::text(std::string_view column) const {
  static const std::string nothing;
  const Cell* found = cell(column);
  return found ? found->text : nothing;
}

void CsvReader::fail(std::string_view column, std::string message) {
  const Cell* found = cell(column);
  note(found ? found->place : record_place_, std::move(message), found ? width_of(found->text) : 1);
}

std::string CsvReader::required_text(std::string_view column) {
  const std::string& found = text(column);
  if (found.empty()) fail(column, fmt::format("'{}' is empty", column));
  return found;
}

std::string CsvReader::unique(std::string_view column) {
  std::string found = required_text(column);
  if (found.empty()) return found;
  const auto [first, fresh] =
      seen_[std::string(column)].emplace(normalised(found), Seen{.text = found, .line = record_place_.line});
  if (!fresh) {
    const bool same = first->second.text == found;
    fail(column, fmt::format("{} {} is already in line {}{}", column, in_quotes(found), first->second.line,
                             same ? "" : "; capitals and blanks make no other name"));
  }
  return found;
}

std::optional<double> CsvReader::number(std::string_view column, bool zero_allowed) {
  const std::string& cell_text = text(column);
  const NumberAtFront read = number_at_front(cell_text);
  const double value = read.value;
  if (!read.in_range) {
    fail(column, fmt::format("{}: {} is out of range", column, in_quotes(cell_text)));
  } else if (read.length == 0 || read.length != cell_text.size()) {
    const bool comma = cell_text.find(',') != std::string::npos;
    fail(column, fmt::format("{}: {} is not a number{}", column, in_quotes(cell_text),
                             comma ? "; write a decimal point, not a comma" : ""));
  } else if (value < 0.0 || (value == 0.0 && !zero_allowed)) {
    fail(column, fmt::format("{}: {} must be {}", column, cell_text, zero_allowed ? "0 or more" : "above 0"));
  } else {
    return si_value_of(column, value);
  }
  return std::nullopt;
}

std::optional<double> CsvReader::optional_positive(std::string_view column) {
  if (text(column).empty()) return std::nullopt;
  return number(column, false);
}

double CsvReader::positive(std::string_view column) {
  return required_text(column).empty() ? 1.0 : number(column, false).value_or(1.0);
}

double CsvReader::not_negative(std::string_view column) {
  return required_text(column).empty() ? 1.0 : number(column, true).value_or(1.0);
}

Trust CsvReader::trust(std::string_view column) {
  const std::string found = required_text(column);
  if (found.empty()) return Trust::unverified;
  const std::optional<Trust> mark = parse_trust(found);
  if (!mark) fail(column, fmt::format("{}: {} is not verified, derived or unverified", column, in_quotes(found)));
  return mark.value_or(Trust::unverified);
}

}  // namespace taut::catalogue
