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
inline constexpr Unit rad{.dimension = {}, .symbol = "rad", .shown = "deg", .is_angle = true, .kind = "angle"};
inline constexpr Unit m{
    .dimension = dimension(0, 1, 0), .symbol = "m", .shown = "m", .is_angle = false, .kind = "length"};
inline constexpr Unit m2{
    .dimension = dimension(0, 2, 0), .symbol = "m^2", .shown = "mm^2", .is_angle = false, .kind = "area"};
inline constexpr Unit m3{
    .dimension = dimension(0, 3, 0), .symbol = "m^3", .shown = "cm^3", .is_angle = false, .kind = "section modulus"};
inline constexpr Unit m4{.dimension = dimension(0, 4, 0),
                         .symbol = "m^4",
                         .shown = "cm^4",
                         .is_angle = false,
                         .kind = "second moment of area"};
inline constexpr Unit s{
    .dimension = dimension(0, 0, 1), .symbol = "s", .shown = "s", .is_angle = false, .kind = "time"};
inline constexpr Unit kg{
    .dimension = dimension(1, 0, 0), .symbol = "kg", .shown = "kg", .is_angle = false, .kind = "mass"};
inline constexpr Unit N{
    .dimension = dimension(1, 1, -2), .symbol = "N", .shown = "kN", .is_angle = false, .kind = "force"};
inline constexpr Unit N_m{
    .dimension = dimension(1, 2, -2), .symbol = "N m", .shown = "kN m", .is_angle = false, .kind = "moment"};
inline constexpr Unit J{
    .dimension = dimension(1, 2, -2), .symbol = "J", .shown = "kJ", .is_angle = false, .kind = "energy"};
inline constexpr Unit W{
    .dimension = dimension(1, 2, -3), .symbol = "W", .shown = "kW", .is_angle = false, .kind = "power"};
inline constexpr Unit Pa{
    .dimension = dimension(1, -1, -2), .symbol = "Pa", .shown = "MPa", .is_angle = false, .kind = "stress"};
inline constexpr Unit N_per_m{
    .dimension = dimension(1, 0, -2), .symbol = "N/m", .shown = "N/m", .is_angle = false, .kind = "force per length"};
inline constexpr Unit kg_per_m{
    .dimension = dimension(1, -1, 0), .symbol = "kg/m", .shown = "kg/m", .is_angle = false, .kind = "mass per length"};
inline constexpr Unit N_per_m3{.dimension = dimension(1, -2, -2),
                               .symbol = "N/m^3",
                               .shown = "N/m^3",
                               .is_angle = false,
                               .kind = "weight per volume"};
inline constexpr Unit m_per_s{
    .dimension = dimension(0, 1, -1), .symbol = "m/s", .shown = "m/s", .is_angle = false, .kind = "speed"};
inline constexpr Unit m_per_s2{
    .dimension = dimension(0, 1, -2), .symbol = "m/s^2", .shown = "m/s^2", .is_angle = false, .kind = "acceleration"};
inline constexpr Unit m_per_N{
    .dimension = dimension(-1, 0, 2), .symbol = "m/N", .shown = "mm/kN", .is_angle = false, .kind = "compliance"};
inline constexpr Unit per_s{
    .dimension = dimension(0, 0, -1), .symbol = "1/s", .shown = "1/s", .is_angle = false, .kind = "frequency"};
inline constexpr Unit kg_m2{
    .dimension = dimension(1, 2, 0), .symbol = "kg m^2", .shown = "kg m^2", .is_angle = false, .kind = "inertia"};
inline constexpr Unit N_s_per_m{
    .dimension = dimension(1, 0, -1), .symbol = "N s/m", .shown = "N s/m", .is_angle = false, .kind = "damping"};
inline constexpr Unit N_m_s{
    .dimension = dimension(1, 2, -1), .symbol = "N m s", .shown = "N m s", .is_angle = false, .kind = "rotary damping"};
inline constexpr Unit K{
    .dimension = dimension(0, 0, 0, 1), .symbol = "K", .shown = "K", .is_angle = false, .kind = "temperature"};
inline constexpr Unit per_K{.dimension = dimension(0, 0, 0, -1),
                            .symbol = "1/K",
                            .shown = "1/K",
                            .is_angle = false,
                            .kind = "thermal expansion"};
}  // namespace si

}  // namespace taut
