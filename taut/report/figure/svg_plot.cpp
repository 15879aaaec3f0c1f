#include "taut/report/figure/svg_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "taut/report/figure/pen.hpp"
#include "taut/report/figure/placement.hpp"
#include "taut/report/figure/ticks.hpp"
#include "taut/report/text/text.hpp"

namespace taut::report {
namespace {

constexpr double axes_height = 270;
constexpr double character = 0.56 * font_size;
constexpr int longest_plot_label = 70;

struct Style {
  std::string_view colour;
  std::string_view dashes;
};
/// Distinguished by colour on a screen and by dashes on grey paper.
constexpr std::array<Style, 6> styles{{{.colour = "#1d5fa6", .dashes = ""},
                                       {.colour = "#d9730d", .dashes = "8 3"},
                                       {.colour = "#0f8577", .dashes = "2 2.5"},
                                       {.colour = "#7b3fa0", .dashes = "9 3 2 3"},
                                       {.colour = "#b3261e", .dashes = "5 2"},
                                       {.colour = "#5b6570", .dashes = "12 4"}}};
constexpr std::string_view limit_colour = "#b3261e";

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
  Style style;
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
  const bool marked =
      std::any_of(plot.marks.begin(), plot.marks.end(), [](const Mark& m) { return !m.whole_line && !m.upright; });
  if (marked && !curves.empty()) {  // room for the words at the highest and the lowest point
    r.y.high += r.y.high == 0 ? 0 : 0.07 * curves.size();
    r.y.low -= r.y.low == 0 ? 0 : 0.07 * curves.size();
  }
  add_limits(plot, yu, curves, r);
  widen(r.x);
  widen(r.y);
  return r;
}

std::string tick_text(double v, const std::vector<double>& ticks) {
  const double largest = std::max(std::abs(ticks.front()), std::abs(ticks.back()));
  if (largest >= 1e6 || largest < 1e-3) return number_shown(v, 4);
  std::string text = fmt::format("{:.{}f}", v, tick_decimals(ticks));
  if (text.starts_with('-')) text = "−" + text.substr(1);
  return text;
}

Runs axis_title(const Axis& axis, const ShownUnit& unit) {
  Runs runs = label_runs(shortened(clean(axis.label), longest_plot_label));
  const std::string name = unit_text(unit);
  if (!name.empty()) runs.push_back({fmt::format(" in {}", name), Run::Style::plain});
  return runs;
}

/// One entry of the legend.
struct Entry {
  Runs runs;
  Style style;
  bool points_only = false;
};

std::vector<Entry> entries_of(const Scene& s, const std::vector<Line>& lines) {
  std::vector<Entry> all;
  for (const Line& l : lines) {
    if (l.curve->label.empty()) continue;
    all.push_back({label_runs(shortened(clean(l.curve->label), longest_plot_label)), l.style, l.curve->points_only});
  }
  for (const Mark* m : s.limits_outside) {
    const std::string text = fmt::format("{}: {}, outside the range shown", m->label.empty() ? "limit" : m->label,
                                         number_shown(s.y_unit.of(m->y), 4) + " " + unit_text(s.y_unit));
    all.push_back({label_runs(clean(text)), {.colour = limit_colour, .dashes = "6 3"}, false});
  }
  return all;
}

std::string marker(Pixel p, std::string_view colour) {
  return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.6\" fill=\"{}\"/>", p.x, p.y, colour);
}

/// Rows of entries from `top` on; returns the first free line below.
double draw_legend(std::string& out, const std::vector<Entry>& entries, double left, double top) {
  double x = left;
  double y = top;
  for (const Entry& e : entries) {
    const double needed = 34 + width(e.runs) * font_size + 18;
    if (x > left && x + needed > paper_width) {
      x = left;
      y += 19;
    }
    if (e.points_only) {
      out += marker({.x = x + 13, .y = y}, e.style.colour);
    } else {
      out += fmt::format(
          "<path d=\"M{:.1f} {:.1f}h26\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\" "
          "stroke-dasharray=\"{}\"/>",
          x, y, e.style.colour, e.style.dashes);
    }
    out += fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x + 32, y + 4, to_svg(e.runs));
    x += needed;
  }
  return entries.empty() ? top : y + 19;
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
  for (const double v : s.x_ticks) {
    const double x = s.x_pixel(v);
    out += fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>", x, a.top, a.bottom);
    out += fmt::format("<text class=\"tick\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n", x,
                       a.bottom + 17, tick_text(v, s.x_ticks));
  }
  out += fmt::format("<rect class=\"frame\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n", a.left,
                     a.top, a.width(), a.height());
  out += fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n",
                     (a.left + a.right) / 2, a.bottom + 37, to_svg(axis_title(s.plot.x, s.x_unit)));
  out += fmt::format(
      "<text class=\"label\" transform=\"translate(12 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
      (a.top + a.bottom) / 2, to_svg(axis_title(s.plot.y, s.y_unit)));
  return out;
}

bool ok(Pixel p) { return std::isfinite(p.x) && std::isfinite(p.y); }

std::string draw_line(const Line& l) {
  std::string out;
  const auto& p = l.points;
  if (!l.curve->points_only) {
    out += fmt::format(
        "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\" stroke-linejoin=\"round\" "
        "stroke-dasharray=\"{}\"/>\n",
        path_data(p, false), l.style.colour, l.style.dashes);
  }
  for (std::size_t i = 0; i < p.size(); ++i) {
    const bool alone = (i == 0 || !ok(p[i - 1])) && (i + 1 == p.size() || !ok(p[i + 1]));
    if (ok(p[i]) && (alone || l.curve->points_only)) out += marker(p[i], l.style.colour);
  }
  return out;
}

std::vector<Line> lines_of(const Scene& s) {
  std::vector<Line> all;
  for (std::size_t k = 0; k < s.plot.curves.size(); ++k) {
    const Curve& c = s.plot.curves[k];
    Line line{.points = {}, .curve = &c, .style = styles[k % styles.size()]};
    if (c.dashed && line.style.dashes.empty()) line.style.dashes = "6 3";
    for (std::size_t i = 0; i < count(c); ++i) line.points.push_back(s.pixel(c.x[i], c.y[i]));
    all.push_back(std::move(line));
  }
  return all;
}

/// What happens at an x: a thin line over the whole height, its words upright beside it.
std::string draw_upright(const Scene& s, const Mark& m) {
  const double x = s.x_pixel(s.x_unit.of(m.x));
  if (!(x >= s.axes.left - 0.5 && x <= s.axes.right + 0.5)) return {};
  const double beside = x > s.axes.right - 14 ? x - 4 : x + 11;
  return fmt::format(
      "<path d=\"M{0:.1f} {1:.1f}V{2:.1f}\" stroke=\"#5b6570\" stroke-width=\"1\" stroke-dasharray=\"3 3\"/>"
      "<text class=\"tick\" transform=\"translate({3:.1f} {4:.1f}) rotate(-90)\" text-anchor=\"end\">{5}</text>\n",
      x, s.axes.top, s.axes.bottom, beside, s.axes.top + 4, to_svg(label_runs(shortened(clean(m.label), 34))));
}

/// Marks as they are drawn one after the other, their words still to be placed.
struct DrawnMarks {
  std::string svg;
  std::vector<Obstacle> obstacles;
  std::vector<Wanted> labels;
};

/// A limit: a line across the picture, its words at the right end or else further left.
void draw_limit(const Scene& s, const Mark& m, const Runs& runs, DrawnMarks& drawn) {
  const double y = s.y_pixel(s.y_unit.of(m.y));
  drawn.svg +=
      fmt::format("<path d=\"M{:.1f} {:.1f}H{:.1f}\" stroke=\"{}\" stroke-width=\"1.4\" stroke-dasharray=\"6 3\"/>\n",
                  s.axes.left, y, s.axes.right, limit_colour);
  drawn.obstacles.push_back({{.x = s.axes.left, .y = y}, {.x = s.axes.right, .y = y}, 3});
  if (m.label.empty()) return;
  const double half = width(runs) * font_size / 2 + 8;
  drawn.labels.push_back({{.x = s.axes.right - half, .y = y},
                          {{.x = s.axes.left + half, .y = y}, {.x = (s.axes.left + s.axes.right) / 2, .y = y}},
                          runs,
                          {.x = 0, .y = -1}});
}

void draw_point(const Scene& s, const Mark& m, const Runs& runs, DrawnMarks& drawn) {
  const Pixel p = s.pixel(m.x, m.y);
  if (!ok(p)) return;
  drawn.svg +=
      fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4.2\" fill=\"#fff\" stroke=\"{}\" stroke-width=\"2\"/>\n",
                  p.x, p.y, limit_colour);
  drawn.obstacles.push_back({{.x = p.x - 5, .y = p.y}, {.x = p.x + 5, .y = p.y}, 3});
  if (!m.label.empty()) drawn.labels.push_back({p, {}, runs, {.x = 0, .y = -1}});
}

/// Limits and marked points, their words placed where no curve runs.
std::string draw_marks(const Scene& s, const std::vector<Line>& lines) {
  DrawnMarks drawn;
  std::vector<Obstacle>& obstacles = drawn.obstacles;
  for (const Line& l : lines) {
    for (std::size_t i = 1; i < l.points.size(); ++i) {
      if (ok(l.points[i - 1]) && ok(l.points[i])) obstacles.push_back({l.points[i - 1], l.points[i], 3});
    }
  }
  for (const Mark& m : s.plot.marks) {
    if (m.upright) {
      if (std::isfinite(m.x)) drawn.svg += draw_upright(s, m);
      continue;
    }
    const bool outside = std::find(s.limits_outside.begin(), s.limits_outside.end(), &m) != s.limits_outside.end();
    if (outside || !std::isfinite(m.y) || (!m.whole_line && !std::isfinite(m.x))) continue;
    const Runs runs = label_runs(shortened(clean(m.label), longest_plot_label));
    m.whole_line ? draw_limit(s, m, runs, drawn) : draw_point(s, m, runs, drawn);
  }
  const Box& a = s.axes;
  for (const double y : {a.top, a.bottom}) obstacles.push_back({{.x = a.left, .y = y}, {.x = a.right, .y = y}, 3});
  for (const double x : {a.left, a.right}) obstacles.push_back({{.x = x, .y = a.top}, {.x = x, .y = a.bottom}, 3});
  const Box inside = a.grown(-4);
  return drawn.svg + to_svg(place_labels(drawn.labels, obstacles, inside, font_size), font_size);
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
  int widest = 0;
  for (const double v : s.y_ticks) widest = std::max(widest, length(tick_text(v, s.y_ticks)));
  s.axes.left = 32 + widest * character;
  s.axes.right = paper_width - 18;
  s.axes.top = 0;  // lines need their style before the legend, which decides where the axes start
  s.axes.bottom = axes_height;
  std::string legend;
  const auto entries = entries_of(s, lines_of(s));
  // A single curve is what the axis says; its name would only repeat it when it does.
  const bool repeats = entries.size() == 1 && plot.curves.size() == 1 && plot.curves[0].label == plot.y.label;
  const double below = draw_legend(legend, repeats ? std::vector<Entry>{} : entries, s.axes.left, 10);
  s.axes.top = below + 2;
  s.axes.bottom = s.axes.top + axes_height;
  const std::vector<Line> lines = lines_of(s);
  std::string body = legend + draw_axes(s);
  for (const Line& l : lines) body += draw_line(l);
  body += draw_marks(s, lines);
  return fmt::format(
      "<svg class=\"plot\" role=\"img\" aria-label=\"{}\" viewBox=\"0 0 {:.0f} {:.0f}\" width=\"{:.0f}\" "
      "height=\"{:.0f}\">\n{}</svg>\n",
      escape(plot.title), paper_width, s.axes.bottom + 46, paper_width, s.axes.bottom + 46, body);
}

}  // namespace taut::report
