#include "taut/report/figure/tension_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/report/figure/pen.hpp"
#include "taut/report/figure/text_width.hpp"
#include "taut/report/text/text.hpp"

namespace taut::report {
namespace {

constexpr int tension_steps = 8;  ///< the classes t0 to t7 of figure.css
constexpr double slack_share = 1e-6;

double tension_at(const Animation::Line& line, std::size_t time) {
  return line.tension.empty() ? NAN : line.tension[std::min(time, line.tension.size() - 1)];
}

}  // namespace

TensionScale tension_scale(const Animation& a) {
  TensionScale scale;
  for (const auto& line : a.lines) {
    for (const double T : line.tension) {
      if (std::isfinite(T)) scale.most = std::max(scale.most, T);
    }
  }
  return scale;
}

char tension_letter(const Animation::Line& line, std::size_t time, const TensionScale& scale) {
  const double T = tension_at(line, time);
  if (!std::isfinite(T) || !(scale.most > 0)) return '-';
  if (T <= slack_share * scale.most) return 's';
  return static_cast<char>('0' + std::clamp(static_cast<int>(tension_steps * T / scale.most), 0, tension_steps - 1));
}

std::string line_classes(const Animation::Line& line, std::size_t time, const TensionScale& scale) {
  const char letter = tension_letter(line, time, scale);
  if (letter == 's') return "line slack";
  return letter == '-' ? fmt::format("line {}", pen(line.role).name) : fmt::format("line t{}", letter);
}

std::string tension_legend(const TensionScale& scale, const Display& display, Pixel at, Box& box) {
  if (!(scale.most > 0)) return {};
  constexpr double swatch = 18;
  double x = at.x;
  std::string out;
  const auto words = [&](const std::string& text) {
    out += fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", x, at.y + 4, escape(text));
    x += text_width(text, font_size) + 6;
  };
  words("tension 0");
  for (int i = 0; i < tension_steps; ++i) {
    out += fmt::format("<path class=\"line t{}\" d=\"M{:.1f} {:.1f}h{:.1f}\"/>", i, x, at.y, swatch);
    x += swatch;
  }
  x += 6;
  words(quantity_shown(scale.most, si::N, display, 3));
  x += 12;
  out += fmt::format("<path class=\"line slack\" d=\"M{:.1f} {:.1f}h26\"/>", x, at.y);
  x += 32;
  words("slack");
  box.add(Box{.left = at.x, .top = at.y - ascent(font_size) + 4, .right = x, .bottom = at.y + 4 + descent(font_size)});
  return out + "\n";
}

}  // namespace taut::report
