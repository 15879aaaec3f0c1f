#include "taut/report/figure/svg_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/report/figure/event_lane.hpp"
#include "taut/report/figure/pen.hpp"
#include "taut/report/figure/placement.hpp"
#include "taut/report/figure/ruler.hpp"
#include "taut/report/figure/text_width.hpp"
#include "taut/report/figure/ticks.hpp"
#include "taut/report/text/text.hpp"

namespace taut::report {
namespace {

constexpr double axes_height = 250;
constexpr double lane_row = 19;
constexpr int longest_plot_label = 70;
constexpr double most_limit_width = 150;  ///< of the words beside the plot
constexpr std::size_t styles = 6;         ///< of curves: each has a colour on a screen and dashes on grey paper

struct Span {
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  bool empty() const { return high < low; }
  double size() const { return high - low; }
  void add(double v) {
    if (!std::isfinite(v) || std::abs(v) > 1e200) return;
    low = std::min(low, v);
    high = std::max(high, v);
  }
};

/// A curve in shown units; NaN breaks it.
struct Line {
  std::vector<Pixel> points;
  const Curve* curve = nullptr;
  std::string style;  ///< classes
};

struct Scene {
  const Plot& plot;
  ShownUnit x_unit;
  ShownUnit y_unit;
  std::vector<double> x_ticks;
  std::vector<double> y_ticks;
  Box axes;  ///< in pixels
  std::vector<const Mark*> limits_outside;

  double x_pixel(double shown) const {
    const double t = (shown - x_ticks.front()) / (x_ticks.back() - x_ticks.front());
    return axes.left + t * axes.width();
  }
  double y_pixel(double shown) const {
    const double t = (shown - y_ticks.front()) / (y_ticks.back() - y_ticks.front());
    return axes.bottom - t * axes.height();
  }
  Pixel pixel(double x, double y) const {
    const Pixel p{.x = x_pixel(x_unit.of(x)), .y = y_pixel(y_unit.of(y))};
    const bool near = std::abs(p.x) < 1e6 && std::abs(p.y) < 1e6;  // false for NaN too
    return near ? p : Pixel{.x = NAN, .y = NAN};
  }
};

std::size_t count(const Curve& c) { return std::min(c.x.size(), c.y.size()); }

/// A range that has a size, whatever the numbers: one value gets a range around it.
void widen(Span& s) {
  if (s.empty()) s = {.low = 0, .high = 1};
  const double size = std::max(std::abs(s.low), std::abs(s.high));
  if (s.size() > 1e-9 * size && s.size() > 0) return;
  const double by = size > 0 ? 0.1 * size : 1;
  s.low -= by;
  s.high += by;
}

struct Ranges {
  Span x;
  Span y;
  std::vector<const Mark*> limits_outside;
};

/// Zero belongs to the picture unless the curves live far from it.
void reach_zero(Span& y) {
  if (y.empty()) return;
  if (y.low > 0 && y.low < 0.5 * y.high) y.low = 0;
  if (y.high < 0 && y.high > 0.5 * y.low) y.high = 0;
}

/// Limits near the curves widen the range of y, others only get into the legend.
void add_limits(const Plot& plot, const ShownUnit& yu, const Span& curves, Ranges& r) {
  for (const Mark& m : plot.marks) {
    if (!m.whole_line || !std::isfinite(m.y)) continue;
    Span with = r.y;
    with.add(yu.of(m.y));
    const double room = std::max(curves.size(), 0.25 * std::max(std::abs(curves.low), std::abs(curves.high)));
    if (curves.empty() || with.size() <= 4 * room) {
      r.y = with;
    } else {
      r.limits_outside.push_back(&m);
    }
  }
}

/// What the axes have to show, in shown units.
Ranges ranges_of(const Plot& plot, const ShownUnit& xu, const ShownUnit& yu) {
  Ranges r;
  for (const Curve& c : plot.curves) {
    for (std::size_t i = 0; i < count(c); ++i) {
      if (!std::isfinite(c.x[i]) || !std::isfinite(c.y[i])) continue;
      r.x.add(xu.of(c.x[i]));
      r.y.add(yu.of(c.y[i]));
    }
  }
  for (const Mark& m : plot.marks) {
    if (m.whole_line || m.upright || !std::isfinite(m.x) || !std::isfinite(m.y)) continue;
    r.x.add(xu.of(m.x));
    r.y.add(yu.of(m.y));
  }
  reach_zero(r.y);
  const Span curves = r.y;
  add_limits(plot, yu, curves, r);
  widen(r.x);
  widen(r.y);
  return r;
}

/// The axis in words with its unit, cut to `room` pixels.
Runs axis_title(const Axis& axis, const ShownUnit& unit, double room) {
  const std::string name = unit_text(unit);
  for (int letters = longest_plot_label;; letters -= 4) {
    Runs runs = label_runs(shortened(clean(axis.label), letters));
    if (!name.empty()) runs.push_back({fmt::format(" in {}", name), Run::Style::plain});
    if (letters <= 8 || text_width(runs, font_size) <= room) return runs;
  }
}

/// One entry of the legend.
struct Entry {
  Runs runs;
  std::string style;
  bool points_only = false;
};

std::vector<Entry> entries_of(const Scene& s, const std::vector<Line>& lines) {
  std::vector<Entry> all;
  for (const Line& l : lines) {
    if (l.curve->label.empty()) continue;
    all.push_back({label_runs(shortened(clean(l.curve->label), longest_plot_label)), l.style, l.curve->points_only});
  }
  for (const Mark* m : s.limits_outside) {
    const std::string text =
        fmt::format("{}: {}, outside the range shown", m->label.empty() ? "limit" : shortened(m->label, 40),
                    number_shown(s.y_unit.of(m->y), 4) + " " + unit_text(s.y_unit));
    all.push_back({label_runs(clean(text)), "limit", false});
  }
  return all;
}

std::string point(Pixel p, std::string_view style) {
  return fmt::format("<circle class=\"point {}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.6\"/>", style, p.x, p.y);
}

/// Rows of entries from `top` on; returns the first free line below.
double draw_legend(std::string& out, const std::vector<Entry>& entries, double left, double top) {
  double x = left;
  double y = top;
  for (const Entry& e : entries) {
    const double needed = 34 + text_width(e.runs, font_size) + 18;
    if (x > left && x + needed - 18 > paper_width) {
      x = left;
      y += lane_row;
    }
    if (e.points_only) {
      out += point({.x = x + 13, .y = y}, e.style);
    } else {
      out += fmt::format("<path class=\"{}\" d=\"M{:.1f} {:.1f}h26\"/>",
                         e.style == "limit" ? e.style : "curve " + e.style, x, y);
    }
    out += fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x + 32, y + 4, to_svg(e.runs));
    x += needed;
  }
  return entries.empty() ? top : y + lane_row;
}

std::string draw_axes(const Scene& s) {
  std::string out;
  const Box& a = s.axes;
  for (const double v : s.y_ticks) {
    const double y = s.y_pixel(v);
    out +=
        fmt::format("<path class=\"{}\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>", v == 0 ? "zero" : "grid", a.left, y, a.right);
    out += fmt::format("<text class=\"tick\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n", a.left - 7,
                       y + 4, tick_text(v, s.y_ticks));
  }
  double last = -HUGE_VAL;
  for (const double v : s.x_ticks) {
    const double x = s.x_pixel(v);
    const std::string text = tick_text(v, s.x_ticks);
    const double half = text_width(text, tick_size) / 2;
    out += fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>", x, a.top, a.bottom);
    if (x - half < last + 4) continue;
    out += fmt::format("<text class=\"tick\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n", x,
                       a.bottom + 17, text);
    last = x + half;
  }
  out += fmt::format("<rect class=\"frame\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n", a.left,
                     a.top, a.width(), a.height());
  out += fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n",
                     (a.left + a.right) / 2, a.bottom + 37, to_svg(axis_title(s.plot.x, s.x_unit, a.width())));
  out += fmt::format(
      "<text class=\"label\" transform=\"translate(12 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
      (a.top + a.bottom) / 2, to_svg(axis_title(s.plot.y, s.y_unit, a.height() + 20)));
  return out;
}

bool ok(Pixel p) { return std::isfinite(p.x) && std::isfinite(p.y); }

std::string draw_line(const Line& l) {
  std::string out;
  const auto& p = l.points;
  if (!l.curve->points_only) out += fmt::format("<path class=\"curve {}\" d=\"{}\"/>\n", l.style, path_data(p, false));
  for (std::size_t i = 0; i < p.size(); ++i) {
    const bool alone = (i == 0 || !ok(p[i - 1])) && (i + 1 == p.size() || !ok(p[i + 1]));
    if (ok(p[i]) && (alone || l.curve->points_only)) out += point(p[i], l.style);
  }
  return out;
}

std::vector<Line> lines_of(const Scene& s) {
  std::vector<Line> all;
  for (std::size_t k = 0; k < s.plot.curves.size(); ++k) {
    const Curve& c = s.plot.curves[k];
    Line line{.points = {}, .curve = &c, .style = fmt::format("c{}{}", k % styles, c.dashed ? " dashed" : "")};
    for (std::size_t i = 0; i < count(c); ++i) line.points.push_back(s.pixel(c.x[i], c.y[i]));
    all.push_back(std::move(line));
  }
  return all;
}

bool is_outside(const Scene& s, const Mark& m) {
  return std::find(s.limits_outside.begin(), s.limits_outside.end(), &m) != s.limits_outside.end();
}

/// Marks with a place along x: events, and points of curves.
std::vector<const Mark*> marks_along(const Scene& s) {
  std::vector<const Mark*> all;
  for (const Mark& m : s.plot.marks) {
    if (m.whole_line || !std::isfinite(m.x) || (!m.upright && !ok(s.pixel(m.x, m.y)))) continue;
    const double x = s.x_pixel(s.x_unit.of(m.x));
    if (x >= s.axes.left - 0.5 && x <= s.axes.right + 0.5) all.push_back(&m);
  }
  return all;
}

Lane lane_above(const Scene& s) {
  std::vector<LaneMark> marks;
  const std::string unit = unit_text(s.x_unit);
  const bool time = s.plot.x.unit.dimension == si::s.dimension;
  for (const Mark* m : marks_along(s)) {
    if (m->label.empty()) continue;
    const double x = s.x_unit.of(m->x);
    marks.push_back(
        {.at = s.x_pixel(x),
         .runs = label_runs(shortened(clean(m->label), longest_plot_label)),
         .when = fmt::format("{}{}{}{}", time ? "t = " : "", number_shown(x, 4), unit.empty() ? "" : " ", unit)});
  }
  return lane_of(std::move(marks), s.axes.left - 4, paper_width - 4, font_size);
}

/// Lines of events and rings of points, their names in the lane above the axes.
std::string draw_marks(const Scene& s, const Lane& lane) {
  std::string out;
  for (const Mark* m : marks_along(s)) {
    const Pixel p{.x = s.x_pixel(s.x_unit.of(m->x)), .y = s.y_pixel(s.y_unit.of(m->y))};
    const double bottom = m->upright ? s.axes.bottom : p.y - 4;
    out += fmt::format("<path class=\"event\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>", p.x, s.axes.top, bottom);
    if (!m->upright) {
      out += fmt::format("<circle class=\"mark\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4.2\"/>\n", p.x, p.y);
    }
  }
  const double floor = s.axes.top - 6;  // of the lane
  for (const Lane::Name& n : lane.names) {
    const double base = floor - n.row * lane_row - descent(font_size) + 2;
    out += fmt::format("<path class=\"leader\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>", n.mark, s.axes.top,
                       std::clamp(n.mark, n.center - n.wide / 2, n.center + n.wide / 2), base + 4);
  }
  for (const Lane::Name& n : lane.names) {
    const double base = floor - n.row * lane_row - descent(font_size) + 2;
    if (n.is_number) {
      out += fmt::format("<rect class=\"pill\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"16\" rx=\"7\"/>",
                         n.center - n.wide / 2, base - 12, n.wide);
    }
    out += fmt::format("<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n",
                       n.is_number ? "number" : "label", n.center, base, to_svg(n.runs));
  }
  return out;
}

/// Words of a limit beside the plot, in lines.
struct LimitWords {
  double y = 0;
  std::vector<std::string> lines;
};

std::vector<LimitWords> limits_of(const Scene& s) {
  std::vector<LimitWords> all;
  for (const Mark& m : s.plot.marks) {
    if (!m.whole_line || !std::isfinite(m.y) || is_outside(s, m)) continue;
    const std::string value = number_shown(s.y_unit.of(m.y), 4) + " " + unit_text(s.y_unit);
    LimitWords words{.y = m.y, .lines = {}};
    if (!m.label.empty()) {
      constexpr int letters = 20;
      for (std::string& line : wrapped(shortened(clean(m.label), longest_plot_label), letters)) {
        words.lines.push_back(shortened(line, letters + 4));
      }
    }
    if (m.y != 0 && m.label.find_first_of("0123456789") == std::string::npos) words.lines.push_back(value);
    all.push_back(std::move(words));
  }
  std::sort(all.begin(), all.end(), [](const LimitWords& a, const LimitWords& b) { return a.y > b.y; });
  return all;
}

double width_of(const std::vector<LimitWords>& limits) {
  double widest = 0;
  for (const LimitWords& l : limits) {
    for (const std::string& line : l.lines) widest = std::max(widest, text_width(label_runs(line), font_size));
  }
  return std::min(widest, most_limit_width);
}

/// Lines across the picture, their words in the margin on the right.
std::string draw_limits(const Scene& s, const std::vector<LimitWords>& limits) {
  constexpr double line_height = 16;
  std::string out;
  std::vector<double> at, high;
  for (const LimitWords& l : limits) {
    at.push_back(s.y_pixel(s.y_unit.of(l.y)));
    high.push_back(line_height * static_cast<double>(l.lines.size()));
    out += fmt::format("<path class=\"limit\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>\n", s.axes.left, at.back(), s.axes.right);
  }
  const std::vector<double> centers = spread(at, high, 3, s.axes.top - 2, s.axes.bottom + 2);
  for (std::size_t i = 0; i < limits.size(); ++i) {
    if (limits[i].lines.empty()) continue;
    out += fmt::format("<path class=\"leader\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>", s.axes.right, at[i],
                       s.axes.right + 8, centers[i]);
    for (std::size_t k = 0; k < limits[i].lines.size(); ++k) {
      const double base = centers[i] - high[i] / 2 + line_height * (static_cast<double>(k) + 0.78);
      out += fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", s.axes.right + 11, base,
                         to_svg(label_runs(limits[i].lines[k])));
    }
  }
  return out;
}

/// The list, or a reference to the plot above that has the same.
std::vector<Listed> list_below(const std::vector<Listed>& list, std::vector<std::string>& listed) {
  if (list.empty()) return list;
  std::vector<std::string> words;
  words.reserve(list.size());
  for (const Listed& l : list) words.push_back(fmt::format("{} {}", l.number, to_svg(l.runs)));
  if (words == listed && list.size() > 1) {
    return {{.number = 0, .runs = label_runs(fmt::format("1 to {}: see the plot above", list.back().number))}};
  }
  listed = std::move(words);
  return list;
}

bool has_values(const Plot& plot) {
  for (const Curve& c : plot.curves) {
    for (std::size_t i = 0; i < count(c); ++i) {
      if (std::isfinite(c.x[i]) && std::isfinite(c.y[i])) return true;
    }
  }
  return std::any_of(plot.marks.begin(), plot.marks.end(), [](const Mark& m) { return std::isfinite(m.y); });
}

}  // namespace

std::string plot_svg(const Plot& plot, const Display& display) {
  std::vector<std::string> nothing;
  return plot_svg(plot, display, nothing);
}

std::string plot_svg(const Plot& plot, const Display& display, std::vector<std::string>& listed) {
  if (!has_values(plot)) return "<p class=\"empty\">No values to plot.</p>";
  Scene s{.plot = plot,
          .x_unit = shown_unit(plot.x.unit, display),
          .y_unit = shown_unit(plot.y.unit, display),
          .x_ticks = {},
          .y_ticks = {},
          .axes = {},
          .limits_outside = {}};
  const Ranges r = ranges_of(plot, s.x_unit, s.y_unit);
  s.limits_outside = r.limits_outside;
  s.x_ticks = nice_ticks(r.x.low, r.x.high, 8);
  s.y_ticks = nice_ticks(r.y.low, r.y.high, 6);
  double widest = 0;
  for (const double v : s.y_ticks) widest = std::max(widest, text_width(tick_text(v, s.y_ticks), tick_size));
  const std::vector<LimitWords> limits = limits_of(s);
  const double beside = width_of(limits);
  s.axes.left = 32 + widest;
  s.axes.right = paper_width - (beside > 0 ? beside + 16 : 18);
  s.axes.top = 0;  // lines need their style before the legend, which decides where the axes start
  s.axes.bottom = axes_height;
  std::string body;
  const auto entries = entries_of(s, lines_of(s));
  // A single curve is what the axis says; its name would only repeat it when it does.
  const bool repeats = entries.size() == 1 && plot.curves.size() == 1 && plot.curves[0].label == plot.y.label;
  const double below = draw_legend(body, repeats ? std::vector<Entry>{} : entries, s.axes.left, 10);
  const Lane lane = lane_above(s);
  s.axes.top = below + 2 + lane.rows * lane_row + (lane.rows > 0 ? 8 : 0);
  s.axes.bottom = s.axes.top + axes_height;
  const std::vector<Line> lines = lines_of(s);
  body += draw_axes(s);
  for (const Line& l : lines) body += draw_line(l);
  body += draw_limits(s, limits) + draw_marks(s, lane);
  Box box{.left = 0, .top = 0, .right = paper_width, .bottom = s.axes.bottom + 46};
  Box list;
  body += list_svg(list_below(lane.list, listed), {.x = s.axes.left - 20, .y = box.bottom + 2},
                   paper_width - s.axes.left + 20, font_size, list);
  box.add(list);
  if (!list.empty()) box.bottom += 4;
  return svg_element(box.height() > figure_height ? "plot tall" : "plot", plot.title, box, body);
}

}  // namespace taut::report
