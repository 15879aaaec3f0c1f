#include "taut/report/figure/svg_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "taut/report/figure/pen.hpp"
#include "taut/report/figure/placement.hpp"
#include "taut/report/figure/ticks.hpp"
#include "taut/report/text/text.hpp"

namespace taut::report {
namespace {

constexpr double drawing_width = 520;  ///< for the machine itself, before arrows and labels
constexpr double drawing_height = 380;
constexpr double polygon_height = 310;
constexpr double longest_arrow = 95;
constexpr int longest_label = 64;

/// Everything that is known before the first line is drawn.
struct Layout {
  Fit fit;
  double force_scale = 0;  ///< pixels per newton
  bool is_polygon = false;
};

/// The drawing so far.
struct Canvas {
  const Display& display;
  Layout layout;
  std::string behind;  ///< ground, bodies, ropes
  std::string front;   ///< arrows, dimension lines
  Box box;
  std::vector<Obstacle> obstacles;
  std::vector<Wanted> labels;
  std::set<Role> roles;
};

struct Place {
  Pixel at;
  Pixel toward;  ///< where its text would like to stand from there
  // NOLINTNEXTLINE(readability-redundant-member-init): keeps it optional in a list of initial values
  std::vector<Pixel> or_at = {};  ///< other places on the same line
  bool may_cover = false;
};

void want_label(Canvas& c, const std::string& text, Place place) {
  if (text.empty()) return;
  c.labels.push_back({place.at, std::move(place.or_at), label_runs(shortened(clean(text), longest_label)), place.toward,
                      place.may_cover});
}

Pixel between(Pixel a, Pixel b, double t) { return {.x = a.x + t * (b.x - a.x), .y = a.y + t * (b.y - a.y)}; }

void add_line(Canvas& c, const std::vector<Pixel>& points, double weight, bool closed = false) {
  for (const Pixel p : points) c.box.add(p);
  const std::size_t step = std::max<std::size_t>(1, points.size() / 200);
  for (std::size_t i = step; i < points.size(); i += step) {
    c.obstacles.push_back({points[i - step], points[i], weight});
  }
  if (points.size() > 1 && step > 1)
    c.obstacles.push_back({points[(points.size() - 1) / step * step], points.back(), weight});
  if (closed && points.size() > 2) c.obstacles.push_back({points.back(), points.front(), weight});
}

std::vector<Pixel> pixels_of(const Fit& fit, const std::vector<Point>& points) {
  std::vector<Pixel> all;
  for (const Point& p : points) {
    if (is_finite(p)) all.push_back(fit.of(p));
  }
  return all;
}

/// The circle as a chain of points, so that a stretched drawing stretches it too.
std::vector<Point> arc_points(Point center, double radius, double from, double to) {
  const int n = std::clamp(static_cast<int>(std::ceil(std::abs(to - from) / 0.06)), 8, 240);
  std::vector<Point> all;
  for (int i = 0; i <= n; ++i) {
    const double a = from + (to - from) * i / n;
    all.push_back({center.x + radius * std::cos(a), center.y + radius * std::sin(a)});
  }
  return all;
}

std::vector<Point> circle_points(const Circle& c) {
  if (c.from == c.to) return arc_points(c.center, c.radius, 0, 2 * std::numbers::pi);
  double to = c.to;
  while (to < c.from) to += 2 * std::numbers::pi;
  return arc_points(c.center, c.radius, c.from, to);
}

bool is_drawable(const Circle& c) {
  const bool angles = std::abs(c.from) < 1e3 && std::abs(c.to) < 1e3;
  return is_finite(c.center) && std::isfinite(c.radius) && c.radius >= 0 && angles;
}

/// Short strokes below a ground line.
std::string hatching(const std::vector<Pixel>& line, const Pen& p) {
  std::string d;
  constexpr double pitch = 9;
  double next = pitch / 2;
  double done = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double l = std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
    for (; next < done + l; next += pitch) {
      const double t = (next - done) / l;
      const double x = line[i - 1].x + t * (line[i].x - line[i - 1].x);
      const double y = line[i - 1].y + t * (line[i].y - line[i - 1].y);
      d += fmt::format("M{:.1f} {:.1f}l-5 6", x, y);
    }
    done += l;
  }
  return d.empty() ? d : fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\".8\"/>\n", d, p.stroke);
}

void draw_chain(Canvas& c, const std::vector<Pixel>& points, Role role, bool closed, bool filled) {
  if (points.empty()) return;
  const Pen& p = pen(role);
  c.roles.insert(role);
  add_line(c, points, p.weight, closed);
  if (role == Role::ground && !closed) c.behind += hatching(points, p);
  c.behind += fmt::format("<path d=\"{}\" fill=\"{}\" {}/>\n", path_data(points, closed), filled ? p.fill : "none",
                          stroke_of(p));
}

struct Drawer {
  Canvas& c;

  void operator()(const Polyline& s) const {
    draw_chain(c, pixels_of(c.layout.fit, s.points), s.role, s.closed, s.filled);
  }

  void operator()(const Circle& s) const {
    if (!is_drawable(s)) return;
    draw_chain(c, pixels_of(c.layout.fit, circle_points(s)), s.role, s.from == s.to, s.filled);
  }

  void operator()(const ForceArrow& s) const {
    if (!is_finite(s.at) || !std::isfinite(s.fx) || !std::isfinite(s.fy)) return;
    const Pen& p = pen(s.role);
    c.roles.insert(s.role);
    const double force = std::hypot(s.fx, s.fy);
    const std::string value = quantity_shown(force, si::N, c.display, 4);
    const std::string text = s.label.empty() ? value : fmt::format("{} = {}", s.label, value);
    const Pixel at = c.layout.fit.of(s.at);
    // Along the stretched rope, not across it; the length shows the force whatever the direction.
    const double dy = -s.fy * c.layout.fit.vertical;
    const double l = std::hypot(s.fx, dy);
    const double length = force * c.layout.force_scale;
    if (!(l > 0) || !(length > 0.05)) return want_label(c, text, {.at = at, .toward = {}});
    const Pixel d{.x = s.fx / l * length, .y = dy / l * length};
    const Pixel tail = s.towards ? Pixel{.x = at.x - d.x, .y = at.y - d.y} : at;
    const Pixel tip = s.towards ? at : Pixel{.x = at.x + d.x, .y = at.y + d.y};
    const double head = std::min(9.0, 0.6 * length + 2);
    const double shaft = std::max(0.0, 1 - 0.8 * head / length);
    c.front += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" fill=\"none\" {}/>", tail.x, tail.y,
                           tail.x + shaft * d.x, tail.y + shaft * d.y, stroke_of(p));
    c.front += arrow_head(tip, d.x, d.y, head, p.stroke) + "\n";
    add_line(c, {tail, tip}, p.weight);
    // The free end has more room; a side of a polygon is named at its middle.
    const Pixel free_end = s.towards ? tail : tip;
    const double sign = s.towards ? -1 : 1;
    const auto along = [&](double t) { return between(tail, tip, t); };
    if (c.layout.is_polygon)
      return want_label(c, text,
                        {.at = along(0.5), .toward = {.x = -d.y, .y = d.x}, .or_at = {along(0.3), along(0.7)}});
    want_label(c, text, {.at = free_end, .toward = {.x = sign * d.x, .y = sign * d.y}, .or_at = {along(0.5)}});
  }

  void operator()(const DimensionLine& s) const {
    if (!is_finite(s.from) || !is_finite(s.to) || !std::isfinite(s.offset)) return;
    const double lx = s.to.x - s.from.x;
    const double ly = s.to.y - s.from.y;
    const double l = std::hypot(lx, ly);
    if (!(l > 0)) return;
    const Point n{.x = -ly / l * s.offset, .y = lx / l * s.offset};
    const Pixel a = c.layout.fit.of({.x = s.from.x + n.x, .y = s.from.y + n.y});
    const Pixel b = c.layout.fit.of({.x = s.to.x + n.x, .y = s.to.y + n.y});
    const Pixel from = c.layout.fit.of(s.from);
    const Pixel to = c.layout.fit.of(s.to);
    const double px = std::hypot(b.x - a.x, b.y - a.y);
    if (s.offset != 0) {
      c.front +=
          fmt::format("<path class=\"extension\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>",
                      from.x, from.y, a.x, a.y, to.x, to.y, b.x, b.y);
      add_line(c, {from, a}, 0.6);
      add_line(c, {to, b}, 0.6);
    }
    c.front += fmt::format("<path class=\"dimension\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>", a.x, a.y, b.x, b.y);
    const double head = std::min(7.0, px / 3);
    c.front +=
        arrow_head(a, a.x - b.x, a.y - b.y, head, "#555d66") + arrow_head(b, b.x - a.x, b.y - a.y, head, "#555d66");
    c.front += "\n";
    add_line(c, {a, b}, 2);
    const std::string text =
        s.text.empty() ? quantity_shown(l, c.layout.is_polygon ? si::N : si::m, c.display, 4) : s.text;
    const double side = s.offset < 0 ? -1 : 1;
    want_label(c, text,
               {.at = between(a, b, 0.5),
                .toward = {.x = side * -ly, .y = side * -lx},
                .or_at = {between(a, b, 0.3), between(a, b, 0.7)}});
  }

  void operator()(const AngleMark& s) const {
    const bool angles = std::abs(s.from) < 1e3 && std::abs(s.to) < 1e3;
    if (!is_finite(s.center) || !std::isfinite(s.radius) || !angles) return;
    const double least = 15 / c.layout.fit.scale;
    const double radius = std::max(s.radius, least);
    const std::vector<Pixel> arc = pixels_of(c.layout.fit, arc_points(s.center, radius, s.from, s.to));
    c.front += fmt::format("<path class=\"angle\" d=\"{}\"/>\n", path_data(arc, false));
    add_line(c, arc, 1.2);
    const Pixel center = c.layout.fit.of(s.center);
    const Pixel middle = arc[arc.size() / 2];
    want_label(c, s.text, {.at = middle, .toward = {.x = middle.x - center.x, .y = middle.y - center.y}});
  }

  void operator()(const Label& s) const {
    if (!is_finite(s.at)) return;
    const Pixel at = c.layout.fit.of(s.at);
    c.box.add(at);
    want_label(c, s.text, {.at = at, .toward = {}, .or_at = {}, .may_cover = true});
  }
};

/// The points that a shape spans in its own coordinates; arrows only where they stand, but for a polygon.
struct Extent {
  std::vector<Point>& all;
  bool is_polygon;
  double vertical;

  void operator()(const Polyline& s) const { all.insert(all.end(), s.points.begin(), s.points.end()); }
  void operator()(const Circle& s) const {
    if (!is_drawable(s)) return;
    const auto points = circle_points(s);
    all.insert(all.end(), points.begin(), points.end());
  }
  void operator()(const ForceArrow& s) const {
    all.push_back(s.at);
    const double sign = s.towards ? -1 : 1;
    if (is_polygon) all.push_back({s.at.x + sign * s.fx, s.at.y + sign * s.fy});
  }
  void operator()(const DimensionLine& s) const {
    all.push_back(s.from);
    all.push_back(s.to);
  }
  void operator()(const AngleMark& s) const { all.push_back(s.center); }
  void operator()(const Label& s) const { all.push_back(s.at); }
};

double largest_force(const Drawing& d) {
  double largest = 0;
  for (const Shape& s : d.shapes) {
    const auto* arrow = std::get_if<ForceArrow>(&s);
    const double f = arrow == nullptr ? 0 : std::hypot(arrow->fx, arrow->fy);
    if (std::isfinite(f)) largest = std::max(largest, f);
  }
  return largest;
}

/// Scale so that the machine fits into `wide` pixels; empty drawings and single points get a scale of 1.
Layout layout_of(const Drawing& d, double wide) {
  Layout layout;
  layout.is_polygon = d.unit.dimension == si::N.dimension;
  layout.fit.vertical = std::isfinite(d.vertical_scale) && d.vertical_scale > 0 ? d.vertical_scale : 1;
  std::vector<Point> points;
  for (const Shape& s : d.shapes)
    std::visit(Extent{.all = points, .is_polygon = layout.is_polygon, .vertical = layout.fit.vertical}, s);
  Box box;
  for (const Point& p : points) {
    if (is_finite(p)) box.add(Pixel{.x = p.x, .y = p.y * layout.fit.vertical});
  }
  const double high = layout.is_polygon ? polygon_height : drawing_height;
  const double w = box.empty() ? 0 : box.width();
  const double h = box.empty() ? 0 : box.height();
  if (w > 0 || h > 0) layout.fit.scale = std::min(w > 0 ? wide / w : HUGE_VAL, h > 0 ? high / h : HUGE_VAL);
  const double force = largest_force(d);
  if (force > 0) layout.force_scale = layout.is_polygon ? layout.fit.scale : longest_arrow / force;
  return layout;
}

/// One scale bar: a line of `pixels` with its text; returns the width it takes.
double scale_bar(std::string& out, Pixel at, double pixels, const std::string& text, bool is_force) {
  const Pen& p = pen(Role::force);
  if (is_force) {
    out += fmt::format("<path d=\"M{:.1f} {:.1f}h{:.1f}\" {}/>", at.x, at.y, pixels - 6, stroke_of(p));
    out += arrow_head({.x = at.x + pixels, .y = at.y}, 1, 0, 9, p.stroke);
  } else {
    out += fmt::format("<path class=\"bar\" d=\"M{:.1f} {:.1f}v6M{:.1f} {:.1f}h{:.1f}M{:.1f} {:.1f}v6\"/>", at.x,
                       at.y - 3, at.x, at.y, pixels, at.x + pixels, at.y - 3);
  }
  out += fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", at.x + pixels + 6, at.y + 4,
                     escape(text));
  return pixels + 6 + 0.52 * font_size * length(text) + 20;
}

/// A round length of 30 to 90 pixels.
double round_length(double scale, const ShownUnit& unit) { return nice_below(90 / scale * unit.of(1)) / unit.of(1); }

std::string legend_words(const Drawing& d, Role role) {
  for (const auto& [r, words] : d.legend) {
    if (r == role) return words;
  }
  return std::string(pen(role).words);
}

/// The row below: scale bars and legend.
void draw_foot(Canvas& c, const Drawing& d) {
  constexpr double row = 20;
  const double left = c.box.left;
  const double right = std::max(c.box.right, left + 480);
  Pixel at{.x = left, .y = c.box.bottom + 26};
  std::string out;
  const auto next = [&](double taken) { at.x += taken; };
  const auto room = [&](double needed) {
    if (at.x > left && at.x + needed > right) at = {.x = left, .y = at.y + row};
  };
  const ShownUnit unit = shown_unit(d.unit, c.display);
  const double bar = round_length(c.layout.fit.scale, unit);
  if (std::isfinite(bar) && bar > 0) {
    next(scale_bar(out, at, bar * c.layout.fit.scale, quantity_shown(bar, d.unit, c.display), c.layout.is_polygon));
  }
  if (c.layout.force_scale > 0 && !c.layout.is_polygon) {
    const double force = round_length(c.layout.force_scale, shown_unit(si::N, c.display));
    room(170);
    next(scale_bar(out, at, force * c.layout.force_scale, quantity_shown(force, si::N, c.display), true));
  }
  std::vector<Role> named;
  for (const Role r : c.roles) {
    if (!legend_words(d, r).empty()) named.push_back(r);
  }
  if (named.size() < 2) named.clear();
  for (const Role r : named) {
    const std::string words = escape(legend_words(d, r));
    const double needed = 34 + 0.52 * font_size * length(words) + 12;
    room(needed);
    out += fmt::format("<path d=\"M{:.1f} {:.1f}h26\" fill=\"none\" {}/>", at.x, at.y, stroke_of(pen(r)));
    out += fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", at.x + 32, at.y + 4, words);
    next(needed);
  }
  c.box.add(Pixel{.x = right, .y = at.y + 8});
  c.front += out;
}

/// The sides of a polygon are named from outside: between two of them a name could belong to either.
void turn_outward(Canvas& c) {
  const Pixel center{.x = (c.box.left + c.box.right) / 2, .y = (c.box.top + c.box.bottom) / 2};
  for (Wanted& w : c.labels) {
    const double outward = w.toward.x * (w.anchor.x - center.x) + w.toward.y * (w.anchor.y - center.y);
    if (outward < 0) w.toward = {.x = -w.toward.x, .y = -w.toward.y};
  }
}

}  // namespace

std::string drawing_svg(const Drawing& d, const Display& display) {
  if (d.shapes.empty()) return "<p class=\"empty\">Nothing to draw.</p>";
  double wide = drawing_width;
  std::string body;
  Box box;
  for (int round = 0; round < 3; ++round) {  // arrows and labels take room that is known only when they are placed
    Canvas c{.display = display,
             .layout = layout_of(d, wide),
             .behind = {},
             .front = {},
             .box = {},
             .obstacles = {},
             .labels = {},
             .roles = {}};
    for (const Shape& s : d.shapes) std::visit(Drawer{c}, s);
    if (c.box.empty()) c.box.add(Pixel{.x = 0, .y = 0});
    if (c.layout.is_polygon) turn_outward(c);
    const std::vector<Placed> labels = place_labels(c.labels, c.obstacles, c.box, font_size);
    for (const Placed& p : labels) c.box.add(p.box);
    draw_foot(c, d);
    body = c.behind + c.front + to_svg(labels, font_size);
    box = c.box.grown(8);
    if (box.width() <= paper_width) break;
    wide *= 0.97 * paper_width / box.width();
  }
  return fmt::format(
      "<svg class=\"drawing\" role=\"img\" aria-label=\"{}\" viewBox=\"{:.0f} {:.0f} {:.0f} {:.0f}\" width=\"{:.0f}\" "
      "height=\"{:.0f}\">\n{}</svg>\n",
      escape(d.title), box.left, box.top, std::ceil(box.width()), std::ceil(box.height()), std::ceil(box.width()),
      std::ceil(box.height()), body);
}

std::string scale_words(const Drawing& d) {
  if (d.vertical_scale == 1 || !std::isfinite(d.vertical_scale) || !(d.vertical_scale > 0)) return {};
  return fmt::format("Heights are drawn {} times as large as lengths; angles are not true.",
                     number_shown(d.vertical_scale, 3));
}

}  // namespace taut::report
