#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "taut/calc/result.hpp"
#include "taut/units/unit.hpp"

namespace taut::report {

/// Kind of quantity -> unit, as a deck asks for ("force" -> "kN").
using Display = std::map<std::string, std::string>;

/// The unit that a quantity is shown in.
struct ShownUnit {
  std::string name = "1";  ///< of the unit list, "kN m"; "1" for a plain number
  double si = 1;           ///< SI value of one of it
  bool is_slope = false;   ///< an angle in %: 100 tan(angle)
  double of(double si_value) const;
};

/// `display` first, then the unit's own preference; a name that does not fit falls back to SI.
ShownUnit shown_unit(const Unit& unit, const Display& display);

/// "kN·m", "N/mm²", "°"; empty for a plain number.
std::string unit_text(const ShownUnit& unit);

/// For ASCII surroundings: the name itself, empty for a plain number.
std::string plain_unit(const ShownUnit& unit);

/// A number for print: `digits` significant ones, no trailing zeros, a proper minus, "1.5×10⁻⁵"; "–" for NaN, "∞".
std::string number_shown(double x, int digits = 5);
/// The same in ASCII: "-1.5e-05", "-", "inf".
std::string number_plain(double x, int digits = 5);

/// "138.86 kN", "12°", "0.12".
std::string quantity_shown(double si_value, const Unit& unit, const Display& display, int digits = 5);
std::string quantity_plain(double si_value, const Unit& unit, const Display& display, int digits = 5);

/// The numbers of one column with the same number of decimals, as many as the largest of them needs for `digits`
/// significant ones; numbers that would vanish are shown with a power of ten.
std::vector<std::string> column_shown(const std::vector<double>& numbers, int digits = 5);

}  // namespace taut::report
