#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "taut/calc/result.hpp"
#include "taut/calc/shown.hpp"
#include "taut/units/display.hpp"
#include "taut/units/unit.hpp"

namespace taut::report {

/// A unit's name for print: "kN·m", "N/mm²", "°"; empty for a plain number.
std::string unit_text(std::string_view name);
std::string unit_text(const ShownUnit& unit);

/// A number for print: `digits` significant ones, no trailing zeros, a proper minus, "1.5×10⁻⁵"; "–" for NaN, "∞".
std::string number_shown(double x, int digits = 5);
/// The same in ASCII: "-1.5e-05", "-", "inf".
std::string number_plain(double x, int digits = 5);

/// "138.86 kN", "12°", "0.12".
std::string quantity_shown(double stored, const Unit& unit, const Display& display, int digits = 5);
std::string quantity_plain(double stored, const Unit& unit, const Display& display, int digits = 5);

/// A result as its reader needs it, "138.9 kN", "382.42 m": four significant digits, of a length in metres centimetres
/// at least. JSON and CSV have all digits.
std::string value_shown(double stored, const Unit& unit, const Display& display);
std::string value_number(double stored, const ShownUnit& unit);

/// The numbers of one column with the same number of decimals, as many as the largest of them needs for `digits`
/// significant ones; numbers that would vanish are shown with a power of ten.
std::vector<std::string> column_shown(const std::vector<double>& numbers, int digits = 5);

}  // namespace taut::report
