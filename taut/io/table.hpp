#pragma once
#include <functional>
#include <string>

#include "taut/calc/result.hpp"
#include "taut/units/display.hpp"

namespace taut::io {

/// A table as CSV (RFC 4180: CRLF, quotes where needed): a header with SI units, "boom_length [m]", then the rows.
/// Numbers in as many digits as bring the same number back; no value is an empty cell. A text that begins with = + - @,
/// a tab or a carriage return gets an apostrophe before it: spreadsheets would run it as a formula.
std::string to_csv(const Table& t);
/// The same in the units of `display`, which the header names, "tension_max [kN]"; numbers in 12 significant digits.
std::string to_csv(const Table& t, const Display& display);
/// The same in SI piece by piece, for a table that is too long to be one text.
void to_csv(const Table& t, const std::function<void(const std::string&)>& write);

/// The numbers of a plot as a table of its name: the first column is x, then one column for each curve. When the
/// curves do not share their x, one row for each point instead: curve, x, y.
Table series_table(const Plot& p);

/// The places of a profile: x, z, ground, clearance, what is borne, what governs.
Table series_table(const Profile& p);

/// A word as a column's name: "boom length" -> "boom_length".
std::string column_name(const std::string& label);

}  // namespace taut::io
