#pragma once
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "taut/units/parse.hpp"
#include "taut/units/unit.hpp"

namespace taut {

/// One unit for each kind of quantity that `display:` of a deck may name, in the order of print.
const std::vector<Unit>& display_kinds();

/// Why a unit may not show quantities of a kind.
struct DisplayError {
  std::string message;
  bool of_kind = false;  ///< the kind is wrong; else the unit, there:
  int offset = 0, width = 1;
};

/// Empty when `unit` may show quantities of `kind` ("force", "kN"); otherwise why not, with the kinds or units that
/// can. `offset` and `width` of the error point into `unit`.
tl::expected<void, DisplayError> check_display(std::string_view kind, std::string_view unit);

/// To which side the digits that are not shown are rounded.
enum class Rounding { nearest, down, up };

/// How a person likes to read SI numbers: each unit's own unit of print, or the one chosen for its kind.
/// Conversion factors are asked for once and kept; copies share them. Safe to use from several threads.
class Display {
 public:
  Display();
  /// `units`: kind of quantity -> unit, each accepted by check_display; a ContractViolation at its first use otherwise.
  explicit Display(std::map<std::string, std::string> units);

  /// The number in the unit of print; an angle in % is 100 tan(angle), degrees Celsius count from
  /// 273.15 K.
  double from_si(double si, const Unit& unit) const;
  /// The unit of print, "kN"; empty for a plain number.
  std::string unit(const Unit& unit) const;
  /// The number in the unit of print, five significant digits, whole digits kept up to 10 million: "1.2346", "123457".
  /// NaN is "-", an infinity "infinite" or "-infinite".
  std::string number(double si, const Unit& unit) const;
  /// Number and unit, "63 kN"; the unit stands away for a plain number, for NaN and for an infinity.
  std::string quantity(double si, const Unit& unit) const;
  /// The same as an engineer writes a result, "138.9 kN": four significant digits, whole digits kept up to 10 million;
  /// a length of 10 m and more to the centimetre or finer in every unit, "382.42 m", "1254.66 ft". `rounding`: what a
  /// machine carries is rounded down, what it needs up.
  std::string brief(double si, const Unit& unit, Rounding rounding = Rounding::nearest) const;

  const std::map<std::string, std::string>& units() const { return units_; }

 private:
  struct Factors;
  double factor(const Unit& unit, const std::string& shown) const;

  std::map<std::string, std::string> units_;
  std::shared_ptr<Factors> factors_;
};

/// `digits` significant ones, up to five, without trailing zeros, whole digits kept up to 10 million; see
/// Display::number.
std::string short_number(double x, int digits = 5);

}  // namespace taut
