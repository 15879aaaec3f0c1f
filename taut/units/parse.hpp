#pragma once
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "taut/units/unit.hpp"

namespace taut {

/// Why a text is not the quantity required. `offset` and `width`: the place of the mistake in that text, bytes from 0.
struct UnitError {
  std::string message;
  int offset = 0;
  int width = 1;
};

/// One unit name that a deck may use, for `taut list units` and the docs.
struct UnitName {
  std::string name;
  std::string meaning;  ///< "kilonewton", "slope, 100 tan(angle)"
  std::string kind;     ///< "force", "length", ...
};

/// Whether its values are cycles per time, of 2 pi rad each, and no speeds of turning.
bool counts_cycles(const Unit& unit);

/// The no-break and thin spaces of a printed text as plain ones, each in as many bytes as before, so that places in the
/// text stay where they are.
std::string with_plain_spaces(std::string_view text);

/// The same, and the minus of a printed text (U+2212) as '-', but in an exponent: "−12 deg" -> "  -12 deg".
std::string with_plain_signs(std::string_view text);

/// Reads a number with a unit as the SI value of `target`: "63 kN" -> 63000 for si::N. Units combine with space, `*`,
/// `/` and powers (`mm2`, `mm^2`, `mm²`). An angle takes deg, rad, mrad, gon or %; there % is a slope, atan(p/100). A
/// plain number takes no unit, or %, a hundredth. Where the target is shown in Hz it counts cycles, else radians:
/// 2 pi rad/s are 1 Hz; 1/s is the target's own unit. Spaces and the minus may be those of a printed text.
/// `.inf` is accepted only with `allow_infinite`. Factors:
/// factor.hpp. Errors: no unit or a wrong dimension (the message names a unit that fits), an unknown or ambiguous unit
/// (it names the choices), not a number, not finite.
tl::expected<double, UnitError> parse_quantity(std::string_view text, const Unit& target, bool allow_infinite = false);

/// The SI value of one `unit` ("kN" -> 1000). Error when it does not fit `target` or has an offset (degC).
tl::expected<double, UnitError> unit_factor(std::string_view unit, const Unit& target);

/// Reads a finite plain number; the whole text must be one. "1e999", "0x10", "1_000" and "nan" are errors with a
/// reason.
tl::expected<double, UnitError> parse_number(std::string_view text);

/// Every unit name that a deck may use, in the order of the list.
const std::vector<UnitName>& unit_names();

}  // namespace taut
