#include "taut/report/figure/ruler.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/report/figure/text_width.hpp"
#include "taut/report/figure/ticks.hpp"
#include "taut/report/text/quantity.hpp"
#include "taut/report/text/text.hpp"

namespace taut::report {
namespace {

constexpr double room_across = 64;  ///< pixels for a number and the space to the next one
constexpr double room_upward = 34;

/// Round numbers inside the ruler; empty when fewer than two have room.
std::vector<double> inner_ticks(const EdgeRuler& r, double room) {
  const double pixels = std::abs(r.to_pixel - r.from_pixel);
  const int count = static_cast<int>(pixels / room);
  if (count < 1 || !(r.to > r.from) || !std::isfinite(r.to - r.from)) return {};
  std::vector<double> ticks = nice_ticks(r.from, r.to, std::min(count, 10));
  const double little = 1e-9 * (r.to - r.from);
  std::erase_if(ticks, [&](double v) { return v < r.from - little || v > r.to + little; });
  if (ticks.size() < 2) return {};
  return ticks;
}

double pixel_of(const EdgeRuler& r, double v) {
  return r.from_pixel + (v - r.from) / (r.to - r.from) * (r.to_pixel - r.from_pixel);
}

}  // namespace

std::string tick_text(double v, const std::vector<double>& ticks) {
  const double largest = std::max(std::abs(ticks.front()), std::abs(ticks.back()));
  if (largest >= 1e6 || largest < 1e-3) return number_shown(v, 4);
  std::string text = fmt::format("{:.{}f}", v, tick_decimals(ticks));
  if (text.starts_with('-')) text = "−" + text.substr(1);
  return text;
}

Drawn ruler_level(const EdgeRuler& r, double y) {
  Drawn out;
  std::vector<double> ticks = inner_ticks(r, room_across);
  if (ticks.empty()) return out;
  std::string marks;
  double last = -HUGE_VAL;
  for (const double v : ticks) {
    const double x = pixel_of(r, v);
    const std::string text = tick_text(v, ticks);
    const double half = text_width(text, tick_size) / 2;
    marks += fmt::format("M{:.1f} {:.1f}v5", x, y);
    if (x - half < last + 6) continue;
    out.svg += fmt::format("<text class=\"tick\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n", x,
                           y + 18, text);
    last = x + half;
    out.box.add(Box{.left = x - half, .top = y, .right = x + half, .bottom = y + 18 + descent(tick_size)});
  }
  const double title_at = std::max(last, r.to_pixel) + 10;
  out.svg += fmt::format(
      "<path class=\"ruler\" d=\"M{:.1f} {:.1f}H{:.1f}{}\"/><text class=\"tick\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
      r.from_pixel, y, r.to_pixel, marks, title_at, y + 18, escape(r.title));
  out.box.add(Box{.left = r.from_pixel,
                  .top = y,
                  .right = title_at + text_width(r.title, tick_size),
                  .bottom = y + 18 + descent(tick_size)});
  return out;
}

Drawn ruler_upright(const EdgeRuler& r, double x) {
  Drawn out;
  const std::vector<double> ticks = inner_ticks(r, room_upward);
  if (ticks.empty()) return out;
  std::string marks;
  for (const double v : ticks) {
    const double y = pixel_of(r, v);
    const std::string text = tick_text(v, ticks);
    marks += fmt::format("M{:.1f} {:.1f}h-5", x, y);
    out.svg += fmt::format("<text class=\"tick\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n", x - 8,
                           y + 4, text);
    out.box.add(Box{.left = x - 8 - text_width(text, tick_size),
                    .top = y + 4 - ascent(tick_size),
                    .right = x,
                    .bottom = y + 4 + descent(tick_size)});
  }
  const double title_base = std::min(out.box.top, r.to_pixel) - descent(tick_size) - 2;
  out.svg += fmt::format(
      "<path class=\"ruler\" d=\"M{:.1f} {:.1f}V{:.1f}{}\"/><text class=\"tick\" x=\"{:.1f}\" y=\"{:.1f}\" "
      "text-anchor=\"end\">{}</text>\n",
      x, r.from_pixel, r.to_pixel, marks, x, title_base, escape(r.title));
  out.box.add(Box{.left = x - text_width(r.title, tick_size),
                  .top = title_base - ascent(tick_size),
                  .right = x,
                  .bottom = r.from_pixel});
  return out;
}

}  // namespace taut::report
