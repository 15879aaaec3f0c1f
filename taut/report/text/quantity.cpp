#include "taut/report/text/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "taut/report/text/text.hpp"

namespace taut::report {
namespace {

std::string superscript(std::string_view digits) {
  constexpr std::array<std::string_view, 10> small{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string out;
  for (const char c : digits) {
    if (c == '-') out += "⁻";
    if (c >= '0' && c <= '9') out += small[static_cast<std::size_t>(c - '0')];
  }
  return out;
}

/// "m2" and "m^2" -> "m²"; the digits of "1/s" stay.
std::string with_powers(std::string_view name) {
  std::string out;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool after_letter = i > 0 && std::isalpha(static_cast<unsigned char>(name[i - 1])) != 0;
    const bool power = name[i] == '^' || (std::isdigit(static_cast<unsigned char>(name[i])) != 0 && after_letter);
    if (!power) {
      out += name[i] == ' ' || name[i] == '*' ? "·" : std::string(1, name[i]);
      continue;
    }
    if (name[i] == '^') ++i;
    const std::size_t from = i;
    while (i < name.size() && (name[i] == '-' || std::isdigit(static_cast<unsigned char>(name[i])) != 0)) ++i;
    out += superscript(name.substr(from, i - from));
    --i;
  }
  return out;
}

/// Fixed for sizes a person reads at once, with a power of ten beyond.
std::string digits_of(double x, int digits) {
  const double size = std::abs(x);
  if (size != 0 && (size < 1e-4 || size >= 1e7)) return fmt::format("{:.{}e}", x, digits - 1);
  return fmt::format("{:.{}g}", x,
                     std::max(digits, size >= 1 ? static_cast<int>(std::floor(std::log10(size))) + 1 : 1));
}

void strip_zeros(std::string& mantissa) {
  if (mantissa.find('.') == std::string::npos) return;
  mantissa.erase(mantissa.find_last_not_of('0') + 1);
  if (mantissa.back() == '.') mantissa.pop_back();
}

std::string pretty(const std::string& text) {
  const std::size_t e = text.find('e');
  std::string mantissa = text.substr(0, e);
  if (e != std::string::npos) strip_zeros(mantissa);
  std::string out = mantissa.starts_with('-') ? "−" + mantissa.substr(1) : mantissa;
  if (e != std::string::npos) out += "×10" + superscript(std::to_string(std::stoi(text.substr(e + 1))));
  return out;
}

}  // namespace

std::string unit_text(std::string_view name) {
  if (name == "1") return {};
  if (name == "deg") return "°";
  if (name == "degC") return "°C";
  return with_powers(name);
}

std::string unit_text(const ShownUnit& unit) { return unit_text(unit.name); }

std::string number_shown(double x, int digits) {
  if (std::isnan(x)) return "–";
  if (std::isinf(x)) return x > 0 ? "∞" : "−∞";
  return pretty(digits_of(x == 0 ? 0.0 : x, digits));
}

std::string number_plain(double x, int digits) {
  if (std::isnan(x)) return "-";
  if (std::isinf(x)) return x > 0 ? "inf" : "-inf";
  std::string text = digits_of(x == 0 ? 0.0 : x, digits);
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  std::string mantissa = text.substr(0, e);
  strip_zeros(mantissa);
  return mantissa + text.substr(e);
}

std::string quantity_shown(double stored, const Unit& unit, const Display& display, int digits) {
  const ShownUnit u = shown_unit(unit, display);
  const std::string name = unit_text(u);
  std::string number = number_shown(u.of(stored), digits);
  if (name.empty() || std::isnan(stored)) return number;
  return name == "°" ? number + name : fmt::format("{} {}", number, name);
}

std::string value_number(double stored, const ShownUnit& unit) {
  constexpr int digits = 4;
  const double x = unit.of(stored);
  const double size = std::abs(x);
  const bool metres = unit.name == "m" && size >= 100 && size < 1e5;
  const int more = metres ? static_cast<int>(std::floor(std::log10(size))) - 1 : 0;  // to the centimetre
  return number_shown(x, digits + more);
}

std::string value_shown(double stored, const Unit& unit, const Display& display) {
  const ShownUnit u = shown_unit(unit, display);
  const std::string name = unit_text(u);
  const std::string number = value_number(stored, u);
  if (name.empty() || std::isnan(stored)) return number;
  return name == "°" ? number + name : fmt::format("{} {}", number, name);
}

std::string quantity_plain(double stored, const Unit& unit, const Display& display, int digits) {
  const ShownUnit u = shown_unit(unit, display);
  const std::string number = number_plain(u.of(stored), digits);
  return u.name.empty() || std::isnan(stored) ? number : fmt::format("{} {}", number, u.name);
}

namespace {

double largest_of(const std::vector<double>& numbers) {
  double largest = 0;
  for (const double x : numbers) {
    if (std::isfinite(x)) largest = std::max(largest, std::abs(x));
  }
  return largest;
}

/// Zeros at the end of a number, up to `most` of them.
std::size_t zeros_at_end(const std::string& number, std::size_t most) {
  std::size_t zeros = 0;
  while (zeros < most && number[number.size() - 1 - zeros] == '0') ++zeros;
  return zeros;
}

}  // namespace

std::vector<std::string> column_shown(const std::vector<double>& numbers, int digits) {
  constexpr double trace = 1e-12;  // what rounding leaves of 0, as a share of the largest
  const double largest = largest_of(numbers);
  const bool fixed = largest == 0 || (largest >= 1e-4 && largest < 1e7);
  const int before = largest > 0 ? static_cast<int>(std::floor(std::log10(largest))) + 1 : 1;
  const int decimals = std::clamp(digits - before, 0, 8);
  std::vector<std::string> all;
  auto spare = static_cast<std::size_t>(decimals);
  for (const double number : numbers) {
    const double x = std::abs(number) < trace * largest ? 0 : number;
    const double least = 0.5 * std::pow(10, -decimals);
    const bool plain = fixed && std::isfinite(x) && (x == 0 || std::abs(x) >= least);
    all.push_back(plain ? pretty(fmt::format("{:.{}f}", x == 0 ? 0.0 : x, decimals)) : number_shown(x, digits));
    if (plain) spare = zeros_at_end(all.back(), spare);  // zeros that all numbers end with say nothing
  }
  if (spare == 0 || !fixed) return all;
  const std::size_t cut = spare == static_cast<std::size_t>(decimals) ? spare + 1 : spare;
  for (std::string& s : all) {
    if (s.find('.') == std::string::npos || s.find("×") != std::string::npos) continue;
    if (decimals > 0) s.erase(s.size() - cut);
  }
  return all;
}

}  // namespace taut::report
