#pragma once
#include <string>

namespace taut {

/// Exponents of mass, length, time and temperature, stored in sixths so that square and cube roots are exact. An angle
/// has no exponents; its unit marks it as an angle.
struct Dimension {
  int mass = 0;
  int length = 0;
  int time = 0;
  int temperature = 0;

  friend constexpr bool operator==(const Dimension&, const Dimension&) = default;
  friend constexpr Dimension operator*(Dimension a, Dimension b) {
    return {.mass = a.mass + b.mass,
            .length = a.length + b.length,
            .time = a.time + b.time,
            .temperature = a.temperature + b.temperature};
  }
  friend constexpr Dimension operator/(Dimension a, Dimension b) {
    return {.mass = a.mass - b.mass,
            .length = a.length - b.length,
            .time = a.time - b.time,
            .temperature = a.temperature - b.temperature};
  }
};

/// A whole exponent in sixths.
inline constexpr int whole_exponent = 6;

/// The dimension kg^mass m^length s^time K^temperature.
constexpr Dimension dimension(int mass, int length, int time, int temperature = 0) {
  return {.mass = mass * whole_exponent,
          .length = length * whole_exponent,
          .time = time * whole_exponent,
          .temperature = temperature * whole_exponent};
}

constexpr bool is_plain_number(Dimension d) { return d == Dimension{}; }

/// d^(numerator/denominator). Throws ContractViolation when the exponents are not whole sixths.
Dimension power(Dimension d, int numerator, int denominator = 1);

/// "kg m s^-2"; "1" for a plain number.
std::string to_text(Dimension d);

}  // namespace taut
