#include "taut/report/figure/text_width.hpp"

#include <array>

namespace taut::report {
namespace {

constexpr double safety = 1.08;
constexpr double subscript_size = 0.76;
constexpr double variable_width = 0.74;  ///< of a letter in the italic formula font, in sizes of the text around

/// Thousandths of the size, from the space to the tilde.
constexpr std::array<int, 95> helvetica{278,  278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278,
                                        556,  556, 556, 556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556,
                                        1015, 667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667, 556, 833, 722, 778,
                                        667,  778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469, 556,
                                        333,  556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500, 222, 833, 556, 556,
                                        556,  556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584};

double letter_width(char32_t c) {
  if (c >= 32 && c < 127) return helvetica[c - 32] / 1000.0;
  if (c == U'°' || c == U'²' || c == U'³' || c == U'·' || c == U'′') return 0.4;
  if (c < 0x370) return 0.62;                                     // Latin with accents, signs
  return c < 0x1100 || (c >= 0x2000 && c < 0x2e80) ? 0.78 : 1.0;  // Greek, Cyrillic, signs; else the full width of CJK
}

template <class Add>
void each_letter(std::string_view utf8, Add&& add) {
  for (std::size_t i = 0; i < utf8.size();) {
    const auto lead = static_cast<unsigned char>(utf8[i]);
    const std::size_t bytes = lead < 0x80 ? 1 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
    char32_t c = bytes == 1 ? lead : lead & (0xffU >> (bytes + 1));
    for (std::size_t k = 1; k < bytes && i + k < utf8.size(); ++k) {
      c = (c << 6U) | (static_cast<unsigned char>(utf8[i + k]) & 0x3fU);
    }
    add(c);
    i += bytes;
  }
}

}  // namespace

double text_width(std::string_view utf8, double font_size) {
  double all = 0;
  each_letter(utf8, [&](char32_t c) { all += letter_width(c); });
  return safety * all * font_size;
}

double text_width(const Runs& runs, double font_size) {
  double all = 0;
  for (const Run& r : runs) {
    const bool sub = r.style == Run::Style::subscript || r.style == Run::Style::subscript_variable;
    const bool variable = r.style == Run::Style::variable || r.style == Run::Style::subscript_variable;
    const double size = sub ? subscript_size * font_size : font_size;
    if (variable) {
      each_letter(r.text, [&](char32_t) { all += variable_width * size; });
    } else {
      all += text_width(r.text, size);
    }
  }
  return all;
}

double ascent(double font_size) { return 0.96 * font_size; }
double descent(double font_size) { return 0.42 * font_size; }

}  // namespace taut::report
