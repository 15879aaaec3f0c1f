#include "taut/report/figure/svg_bars.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/report/figure/pen.hpp"
#include "taut/report/figure/ruler.hpp"
#include "taut/report/figure/text_width.hpp"
#include "taut/report/figure/ticks.hpp"
#include "taut/report/text/text.hpp"

namespace taut::report {
namespace {

constexpr double bar_height = 13;
constexpr double row_gap = 9;  ///< between two rows
constexpr double most_name_width = 230;
constexpr int longest_bar_name = 44;
constexpr double legend_row = 20;

/// Bars with their scale, pixels.
struct BarScene {
  const Bars& bars;
  ShownUnit unit;
  std::vector<double> ticks;  ///< shown units
  Box axes;

  double pixel(double stored) const {
    const double t = (unit.of(stored) - ticks.front()) / (ticks.back() - ticks.front());
    return axes.left + t * axes.width();
  }
  std::size_t lanes() const { return bars.in_line ? 1 : std::max<std::size_t>(1, bars.series.size()); }
  double row_height() const { return static_cast<double>(lanes()) * bar_height + row_gap; }
};

bool is_shown(const Bars::Bar& b) { return std::isfinite(b.from) && std::isfinite(b.to); }

/// The range that the axis shows, shown units; empty where there is no bar.
std::vector<double> bar_ticks(const Bars& bars, const ShownUnit& unit) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  const auto add = [&](double stored) {
    if (!std::isfinite(stored)) return;
    low = std::min(low, unit.of(stored));
    high = std::max(high, unit.of(stored));
  };
  for (const Bars::Row& row : bars.rows) {
    for (const Bars::Bar& b : row.bars) {
      if (!is_shown(b)) continue;
      for (const double x : {b.from, b.to, b.low, b.high}) add(x);
    }
  }
  if (high < low) return {};
  add(bars.base);
  if (!(high > low)) {
    const double by = std::max(1e-3, 0.1 * std::abs(low));
    low -= by;
    high += by;
  }
  return nice_ticks(low, high, 6);
}

std::string bar_axis(const BarScene& s) {
  std::string out;
  const Box& a = s.axes;
  for (const double v : s.ticks) {
    const double x = a.left + (v - s.ticks.front()) / (s.ticks.back() - s.ticks.front()) * a.width();
    out += fmt::format("<path class=\"grid\" d=\"M{0:.1f} {1:.1f}V{2:.1f}\"/>", x, a.top, a.bottom);
    out += fmt::format("<text class=\"tick\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n", x,
                       a.bottom + 17, tick_text(v, s.ticks));
  }
  Runs title = label_runs(shortened(clean(s.bars.value.label), longest_bar_name + 16));
  if (const std::string unit = unit_text(s.unit); !unit.empty()) {
    title.push_back({fmt::format(" in {}", unit), Run::Style::plain});
  }
  return out + fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n",
                           (a.left + a.right) / 2, a.bottom + 37, to_svg(title));
}

std::string bar_row(const BarScene& s, const Bars::Row& row, double top) {
  std::string out;
  for (std::size_t k = 0; k < row.bars.size(); ++k) {
    const Bars::Bar& b = row.bars[k];
    if (!is_shown(b)) continue;
    const double y = top + (s.bars.in_line ? 0 : static_cast<double>(k) * bar_height);
    const double left = s.pixel(std::min(b.from, b.to)), right = s.pixel(std::max(b.from, b.to));
    out += fmt::format("<rect class=\"bar{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n", k % 2,
                       left, y + 1, right - left, bar_height - 2);
    if (!std::isfinite(b.low) || !std::isfinite(b.high)) continue;
    out +=
        fmt::format("<path class=\"interval\" d=\"M{0:.1f} {2:.1f}H{1:.1f}M{0:.1f} {3:.1f}v5M{1:.1f} {3:.1f}v5\"/>\n",
                    s.pixel(b.low), s.pixel(b.high), y + bar_height / 2, y + bar_height / 2 - 2.5);
  }
  const double middle = top + (s.row_height() - row_gap) / 2;
  return out + fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n",
                           s.axes.left - 9, middle + 4,
                           to_svg(label_runs(shortened(clean(row.label), longest_bar_name))));
}

/// Returns the first free line below.
double bar_legend(std::string& out, const Bars& bars, double left) {
  if (bars.series.size() < 2) return 4;
  double x = left;
  for (std::size_t k = 0; k < bars.series.size(); ++k) {
    const Runs runs = label_runs(clean(bars.series[k]));
    out += fmt::format("<rect class=\"bar{}\" x=\"{:.1f}\" y=\"4\" width=\"22\" height=\"11\"/>", k % 2, x);
    out += fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"14\">{}</text>\n", x + 29, to_svg(runs));
    x += 29 + text_width(runs, font_size) + 22;
  }
  return 4 + legend_row;
}

}  // namespace

std::string bars_svg(const Bars& bars, const Display& display) {
  BarScene s{.bars = bars, .unit = shown_unit(bars.value.unit, display), .ticks = {}, .axes = {}};
  s.ticks = bar_ticks(bars, s.unit);
  if (s.ticks.empty()) return "<p class=\"empty\">No values to plot.</p>";
  double widest = 0;
  for (const Bars::Row& row : bars.rows) {
    widest = std::max(widest, text_width(label_runs(shortened(clean(row.label), longest_bar_name)), font_size));
  }
  std::string body;
  s.axes.left = std::min(widest, most_name_width + 60) + 16;
  s.axes.right = paper_width - 22;
  s.axes.top = bar_legend(body, bars, s.axes.left);
  s.axes.bottom = s.axes.top + static_cast<double>(bars.rows.size()) * s.row_height() + row_gap;
  body += bar_axis(s);
  double top = s.axes.top + row_gap;
  for (const Bars::Row& row : bars.rows) {
    body += bar_row(s, row, top);
    top += s.row_height();
  }
  if (std::isfinite(bars.base))
    body += fmt::format("<path class=\"zero\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>\n", s.pixel(bars.base), s.axes.top,
                        s.axes.bottom);
  const Box box{.left = 0, .top = 0, .right = paper_width, .bottom = s.axes.bottom + 46};
  return svg_element(box.height() > figure_height ? "plot tall" : "plot", bars.title, box, body);
}

}  // namespace taut::report
