#include "taut/units/dimension.hpp"

#include <fmt/format.h>

#include "taut/base/expects.hpp"

namespace taut {
namespace {

int scaled(int exponent, int numerator, int denominator) {
  expects((exponent * numerator) % denominator == 0, "an exponent leaves the sixths: check the formula's dimension");
  return exponent * numerator / denominator;
}

void append(std::string& text, const char* symbol, int exponent) {
  if (exponent == 0) return;
  if (!text.empty()) text += ' ';
  text += symbol;
  if (exponent == whole_exponent) return;
  if (exponent % whole_exponent == 0) {
    text += fmt::format("^{}", exponent / whole_exponent);
  } else {
    text += fmt::format("^({}/{})", exponent, whole_exponent);
  }
}

}  // namespace

Dimension power(Dimension d, int numerator, int denominator) {
  expects(denominator != 0, "an exponent with denominator zero");
  return {.mass = scaled(d.mass, numerator, denominator),
          .length = scaled(d.length, numerator, denominator),
          .time = scaled(d.time, numerator, denominator),
          .temperature = scaled(d.temperature, numerator, denominator)};
}

std::string to_text(Dimension d) {
  std::string text;
  append(text, "kg", d.mass);
  append(text, "m", d.length);
  append(text, "s", d.time);
  append(text, "K", d.temperature);
  return text.empty() ? "1" : text;
}

}  // namespace taut
