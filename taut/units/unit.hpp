#pragma once
#include <string_view>

#include "taut/units/dimension.hpp"

namespace taut {

/// A coherent SI unit and the unit in which its numbers are printed. `symbol`: SI unit of the stored number ("N m").
/// `shown`: unit of print ("kN m"), a name of the unit list.
struct Unit {
  Dimension dimension;
  std::string_view symbol = "1";
  std::string_view shown = "1";
  bool is_angle = false;
  std::string_view kind = "number";  ///< "force", "length", ...: the key of `display:` and the word in messages

  /// The same unit with another default unit of print: `si::m.in("mm")` for the thickness of a plate.
  constexpr Unit in(std::string_view other) const {
    Unit copy = *this;
    copy.shown = other;
    return copy;
  }
  constexpr bool needs_text() const { return is_angle || !is_plain_number(dimension); }
};

/// Coherent SI units by their symbol. `si::one` is a plain number.
namespace si {
inline constexpr Unit one{};
inline constexpr Unit rad{{}, "rad", "deg", true, "angle"};
inline constexpr Unit m{dimension(0, 1, 0), "m", "m", false, "length"};
inline constexpr Unit m2{dimension(0, 2, 0), "m^2", "mm^2", false, "area"};
inline constexpr Unit m3{dimension(0, 3, 0), "m^3", "cm^3", false, "section modulus"};
inline constexpr Unit m4{dimension(0, 4, 0), "m^4", "cm^4", false, "second moment of area"};
inline constexpr Unit s{dimension(0, 0, 1), "s", "s", false, "time"};
inline constexpr Unit kg{dimension(1, 0, 0), "kg", "kg", false, "mass"};
inline constexpr Unit N{dimension(1, 1, -2), "N", "kN", false, "force"};
inline constexpr Unit N_m{dimension(1, 2, -2), "N m", "kN m", false, "moment"};
inline constexpr Unit J{dimension(1, 2, -2), "J", "kJ", false, "energy"};
inline constexpr Unit W{dimension(1, 2, -3), "W", "kW", false, "power"};
inline constexpr Unit Pa{dimension(1, -1, -2), "Pa", "MPa", false, "stress"};
inline constexpr Unit N_per_m{dimension(1, 0, -2), "N/m", "N/m", false, "force per length"};
inline constexpr Unit kg_per_m{dimension(1, -1, 0), "kg/m", "kg/m", false, "mass per length"};
inline constexpr Unit N_per_m3{dimension(1, -2, -2), "N/m^3", "N/m^3", false, "weight per volume"};
inline constexpr Unit m_per_s{dimension(0, 1, -1), "m/s", "m/s", false, "speed"};
inline constexpr Unit m_per_s2{dimension(0, 1, -2), "m/s^2", "m/s^2", false, "acceleration"};
inline constexpr Unit m_per_N{dimension(-1, 0, 2), "m/N", "mm/kN", false, "compliance"};
inline constexpr Unit per_s{dimension(0, 0, -1), "1/s", "1/s", false, "frequency"};
inline constexpr Unit kg_m2{dimension(1, 2, 0), "kg m^2", "kg m^2", false, "inertia"};
inline constexpr Unit N_s_per_m{dimension(1, 0, -1), "N s/m", "N s/m", false, "damping"};
inline constexpr Unit K{dimension(0, 0, 0, 1), "K", "K", false, "temperature"};
inline constexpr Unit per_K{dimension(0, 0, 0, -1), "1/K", "1/K", false, "thermal expansion"};
}  // namespace si

}  // namespace taut
