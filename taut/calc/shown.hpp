#pragma once
#include <string>
#include <utility>

#include "taut/calc/result.hpp"
#include "taut/units/display.hpp"
#include "taut/units/unit.hpp"

namespace taut {

/// Whether `a` is below `b` in the five significant digits that a reader is shown. False when one is NaN.
bool shown_below(double a, double b);

/// The significant digits, `least` or more, with which the value of a check that fails reads differently from its
/// limit. `least` for a check that passes, and where one of the two is no number.
int digits_apart(const Check& c, const Display& display, int least);

/// Two numbers as Display::brief has them, with more digits where they would read the same and differ.
std::pair<std::string, std::string> brief_apart(double one, double other, const Unit& unit, const Display& display);

/// The same for the value and the limit of a check; of one that passes they may read the same.
std::pair<std::string, std::string> brief_apart(const Check& c, const Display& display);

/// The units in which a report and its CSV files show the numbers of a result: those of its `display`, else each unit's
/// own unit of print. Units of `display` that fit nothing are left out.
Display display_of(const Result& r);

/// The unit that a quantity is shown in.
struct ShownUnit {
  Display display;
  Unit unit;
  std::string name;  ///< of the unit list, "kN m"; empty for a plain number
  double of(double stored) const { return display.from_si(stored, unit); }
};
ShownUnit shown_unit(const Unit& unit, const Display& display);

}  // namespace taut
