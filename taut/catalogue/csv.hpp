#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "taut/base/diagnostic.hpp"
#include "taut/catalogue/trust.hpp"

namespace taut::catalogue {

/// A column that a table may have. A name ends in the unit of its numbers ("d_mm", "A_mm2"); see `si_value_of`.
struct CsvColumn {
  std::string_view name;
  bool required = true;
};

/// Reads one CSV table (RFC 4180: comma, double quotes, a header line; UTF-8, with or without a byte order mark; LF or
/// CRLF) record by record, and collects what is wrong with it, each mistake with file, line and column.
///
/// Strict, because a quiet guess about a rope can kill: a missing, unknown or repeated column, a record with too many
/// or too few cells, a stray quote or a NUL byte is a mistake. Empty lines are skipped. A mistake in a cell leaves the
/// reader going, so that one run shows them all (up to `most_mistakes`).
///
///     CsvReader csv(text, "my_ropes.csv", {{"id"}, {"d_mm"}, {"note", false}});
///     while (csv.next()) rows.push_back({csv.unique("id"), csv.positive("d_mm"), csv.text("note")});
///     if (csv.failed()) return tl::unexpected(csv.take_diagnostics());
///
/// `text` must outlive the reader. After a mistake the functions return a harmless value: "" or 1.
class CsvReader {
 public:
  static constexpr std::size_t most_mistakes = 50;

  CsvReader(std::string_view text, std::string file, std::vector<CsvColumn> columns);

  /// Goes to the next record; false at the end of the text, or when the table can't be read any further.
  bool next();

  /// The cell without blanks around it; empty when the cell or an optional column is.
  const std::string& text(std::string_view column) const;
  /// The same; an empty cell is a mistake.
  std::string required_text(std::string_view column);
  /// A text that no earlier record has in this column.
  std::string unique(std::string_view column);
  /// A finite number in SI units; zero, negative or empty is a mistake.
  double positive(std::string_view column);
  /// A finite number in SI units; negative or empty is a mistake.
  double not_negative(std::string_view column);
  /// The same as `positive`, or nothing for an empty cell.
  std::optional<double> optional_positive(std::string_view column);
  /// The cell's mark of trust; anything else is a mistake.
  Trust trust(std::string_view column);

  /// Notes a mistake at the cell of the current record.
  void fail(std::string_view column, std::string message);

  bool failed() const { return !diagnostics_.empty(); }
  std::size_t mistakes() const { return diagnostics_.size(); }
  Diagnostics take_diagnostics() { return std::move(diagnostics_); }

 private:
  struct Cell {
    std::string text;
    Place place;
  };

  bool read_record();
  void read_cell(Cell& cell);
  void read_quoted(Cell& cell);
  void read_header();
  void check_encoding();
  void note(Place place, std::string message, int width = 1);
  bool at_line_end() const;
  void skip_line_end();
  char current() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void advance();
  const Cell* cell(std::string_view column) const;
  std::optional<double> number(std::string_view column, bool zero_allowed);

  std::string_view text_;
  std::string file_;
  std::vector<CsvColumn> columns_;
  std::vector<std::optional<std::size_t>> index_;  // of each column in a record; empty when the table lacks it
  std::vector<Cell> record_;
  std::size_t cells_ = 0;  // of record_ in use; the rest keeps its memory for later records
  std::size_t header_cells_ = 0;
  std::size_t at_ = 0;
  Place place_{.line = 1, .column = 1};
  Place record_place_;
  bool stopped_ = false;
  struct Seen {
    std::string text;
    int line = 0;
  };
  std::unordered_map<std::string, std::unordered_map<std::string, Seen>> seen_;  // column -> normalised text
  Diagnostics diagnostics_;
};

/// `value`, printed in the unit that the column's name ends in (_cm _mm _mm2 _mm3 _mm4 _m _kN _MPa _GPa _kg_per_m
/// _kg_per_100m_per_mm2), in SI; a name without unit leaves it unchanged. Whole numbers of millimetres give the double
/// that the program's own text has: "16" in d_mm is exactly 0.016.
double si_value_of(std::string_view column, double value);

}  // namespace taut::catalogue
