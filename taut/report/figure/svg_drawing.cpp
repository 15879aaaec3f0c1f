#include "taut/report/figure/svg_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "taut/report/figure/pen.hpp"
#include "taut/report/figure/placement.hpp"
#include "taut/report/figure/ruler.hpp"
#include "taut/report/figure/text_width.hpp"
#include "taut/report/figure/ticks.hpp"
#include "taut/report/text/text.hpp"

namespace taut::report {
namespace {

constexpr double drawing_width = 520;  ///< for the machine itself, before arrows and labels
constexpr double drawing_height = 360;
constexpr double polygon_height = 310;
constexpr double longest_arrow = 95;
constexpr double drawing_margin = 8;
constexpr int longest_label = 64;
constexpr int most_rounds = 5;  ///< of shrinking the machine until it fits with its labels

/// Everything that is known before the first line is drawn.
struct Layout {
  Fit fit;
  Box machine;             ///< in metres (newtons), y up
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

/// "G_3 = 12 kN" for a symbol, "F tower 51 kN" and "span 200 m" for words. A long name is cut, not its number.
std::string named(const std::string& name, const std::string& value) {
  if (name.empty()) return value;
  const std::string between = split_symbol(name).is_word ? " " : " = ";
  return fmt::format("{}{}{}", shortened(clean(name), longest_label - length(between + value)), between, value);
}

Pixel between(Pixel a, Pixel b, double t) { return {.x = a.x + t * (b.x - a.x), .y = a.y + t * (b.y - a.y)}; }

/// The line becomes part of the picture and something for labels to keep off, in pieces as long as matters to a label.
void add_line(Canvas& c, const std::vector<Pixel>& points, double weight, bool closed = false) {
  constexpr double piece = 5;
  if (points.empty()) return;
  for (const Pixel p : points) c.box.add(p);
  Pixel last = points.front();
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (i + 1 < points.size() && std::hypot(points[i].x - last.x, points[i].y - last.y) < piece) continue;
    c.obstacles.push_back({last, points[i], weight});
    last = points[i];
  }
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
std::string hatching(const std::vector<Pixel>& line) {
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
  return d.empty() ? d : fmt::format("<path class=\"hatch\" d=\"{}\"/>\n", d);
}

void draw_chain(Canvas& c, const std::vector<Pixel>& points, Role role, bool closed, bool filled) {
  if (points.empty()) return;
  c.roles.insert(role);
  add_line(c, points, pen(role).weight, closed);
  if (role == Role::ground && !closed) c.behind += hatching(points);
  c.behind +=
      fmt::format("<path d=\"{}\" {}/>\n", path_data(points, closed), filled ? area_class(role) : line_class(role));
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
    const std::string value = quantity_shown(s.whole.value_or(force), si::N, c.display, 4);
    const std::string text = named(s.label, value);
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
    c.front += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" {}/>", tail.x, tail.y, tail.x + shaft * d.x,
                           tail.y + shaft * d.y, line_class(s.role));
    c.front += arrow_head(tip, d.x, d.y, head, p.name) + "\n";
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
        arrow_head(a, a.x - b.x, a.y - b.y, head, "dimension") + arrow_head(b, b.x - a.x, b.y - a.y, head, "dimension");
    c.front += "\n";
    add_line(c, {a, b}, 2);
    const std::string length = quantity_shown(l, c.layout.is_polygon ? si::N : si::m, c.display, 4);
    const std::string text = s.text.empty() || s.with_length ? named(s.text, length) : s.text;
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
    const std::string text = s.force ? named(s.text, quantity_shown(*s.force, si::N, c.display, 4)) : s.text;
    want_label(c, text, {.at = at, .toward = {}, .or_at = pixels_of(c.layout.fit, s.or_at), .may_cover = true});
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

/// Scale so that the machine fits into the room for it, times `shrink`; empty drawings and single points get a scale
/// of 1.
Layout layout_of(const Drawing& d, double shrink) {
  Layout layout;
  layout.is_polygon = d.unit.dimension == si::N.dimension;
  layout.fit.vertical = std::isfinite(d.vertical_scale) && d.vertical_scale > 0 ? d.vertical_scale : 1;
  std::vector<Point> points;
  for (const Shape& s : d.shapes)
    std::visit(Extent{.all = points, .is_polygon = layout.is_polygon, .vertical = layout.fit.vertical}, s);
  for (const Point& p : points) {
    if (is_finite(p)) layout.machine.add(Pixel{.x = p.x, .y = p.y});
  }
  const double high = layout.is_polygon ? polygon_height : drawing_height;
  const double w = layout.machine.empty() ? 0 : layout.machine.width();
  const double h = layout.machine.empty() ? 0 : layout.machine.height() * layout.fit.vertical;
  if (w > 0 || h > 0) {
    layout.fit.scale = shrink * std::min(w > 0 ? drawing_width / w : HUGE_VAL, h > 0 ? high / h : HUGE_VAL);
  }
  const double force = largest_force(d);
  if (force > 0) layout.force_scale = layout.is_polygon ? layout.fit.scale : longest_arrow / force;
  return layout;
}

/// One scale bar: a line of `pixels` with its text; returns the width it takes.
double scale_bar(std::string& out, Pixel at, double pixels, const std::string& text, bool is_force) {
  if (is_force) {
    out += fmt::format("<path d=\"M{:.1f} {:.1f}h{:.1f}\" {}/>", at.x, at.y, pixels - 6, line_class(Role::force));
    out += arrow_head({.x = at.x + pixels, .y = at.y}, 1, 0, 9, pen(Role::force).name);
  } else {
    out += fmt::format("<path class=\"bar\" d=\"M{0:.1f} {1:.1f}v8M{2:.1f} {3:.1f}v5M{0:.1f} {4:.1f}h{5:.1f}v-4v8\"/>",
                       at.x, at.y - 4, at.x + pixels / 2, at.y - 5, at.y, pixels);
  }
  out += fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", at.x + pixels + 7, at.y + 4,
                     escape(text));
  return pixels + 7 + text_width(text, font_size) + 20;
}

/// A round length of 30 to 90 pixels.
double round_length(double scale, const ShownUnit& unit) { return nice_below(90 / scale * unit.of(1)) / unit.of(1); }

std::string legend_words(const Drawing& d, Role role) {
  for (const auto& [r, words] : d.legend) {
    if (r == role) return words;
  }
  return std::string(pen(role).words);
}

/// A row that starts again at the left when it is full.
struct FootRow {
  Pixel at;
  double left, right;
  static constexpr double high = 20;
  void room(double needed) {
    if (at.x > left && at.x + needed > right) at = {.x = left, .y = at.y + high};
  }
};

/// The rows below a drawing: scale bars and legend.
struct DrawnFoot {
  std::string svg;
  double right = 0, bottom = 0;
};

/// The rows from `left` on. `with_bar`: no ruler shows the lengths.
DrawnFoot foot_from(const Canvas& c, const Drawing& d, bool with_bar, double left) {
  const double right = left + std::max(c.box.width(), paper_width - 2 * drawing_margin);
  FootRow row{.at = {.x = left, .y = c.box.bottom + 22}, .left = left, .right = right};
  std::string out;
  double widest = left;
  const auto next = [&](double taken) {
    row.at.x += taken;
    widest = std::max(widest, row.at.x - 12);
  };
  const ShownUnit unit = shown_unit(d.unit, c.display);
  const double bar = round_length(c.layout.fit.scale, unit);
  if (with_bar && std::isfinite(bar) && bar > 0) {
    next(scale_bar(out, row.at, bar * c.layout.fit.scale, quantity_shown(bar, d.unit, c.display), c.layout.is_polygon));
  }
  if (c.layout.force_scale > 0 && !c.layout.is_polygon) {
    const double force = round_length(c.layout.force_scale, shown_unit(si::N, c.display));
    row.room(190);
    next(scale_bar(out, row.at, force * c.layout.force_scale, quantity_shown(force, si::N, c.display), true));
  }
  std::vector<Role> named;
  for (const Role r : c.roles) {
    if (!legend_words(d, r).empty()) named.push_back(r);
  }
  if (named.size() < 2) named.clear();
  for (const Role r : named) {
    const std::string words = shortened(clean(legend_words(d, r)), longest_label);
    const double needed = 34 + text_width(words, font_size) + 12;
    row.room(needed);
    out += fmt::format("<path d=\"M{:.1f} {:.1f}h26\" {}/>", row.at.x, row.at.y, line_class(r));
    out += fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", row.at.x + 32, row.at.y + 4,
                       escape(words));
    next(needed);
  }
  return {.svg = std::move(out), .right = widest, .bottom = row.at.y + 10};
}

/// Puts the rows below the drawing, in its middle where they are wider.
void draw_foot(Canvas& c, const Drawing& d, bool with_bar) {
  double left = c.box.left;
  DrawnFoot foot = foot_from(c, d, with_bar, left);
  if (foot.svg.empty()) return;
  if (foot.right > c.box.right) {
    left -= (foot.right - c.box.right) / 2;
    foot = foot_from(c, d, with_bar, left);
  }
  c.box.add(Pixel{.x = left, .y = foot.bottom});
  c.box.add(Pixel{.x = foot.right, .y = foot.bottom});
  c.front += foot.svg;
}

/// Rulers along the sides that have room for two ticks; true: the lower one is there.
bool draw_rulers(Canvas& c, const Drawing& d) {
  if (c.layout.machine.empty() || d.across.empty() || d.upward.empty()) return false;
  const Box& m = c.layout.machine;
  const Pixel low = c.layout.fit.of({.x = m.left, .y = m.top}), high = c.layout.fit.of({.x = m.right, .y = m.bottom});
  const ShownUnit unit = shown_unit(d.unit, c.display);
  const auto ruler = [&](const std::string& name, double from, double to, double a, double b) {
    return EdgeRuler{.title = fmt::format("{}, {}", clean(name), unit_text(unit)),
                     .from = unit.of(from),
                     .to = unit.of(to),
                     .from_pixel = a,
                     .to_pixel = b};
  };
  const Box drawn = c.box;
  const Drawn side = ruler_upright(ruler(d.upward, m.top, m.bottom, low.y, high.y), drawn.left - 10);
  const Drawn foot = ruler_level(ruler(d.across, m.left, m.right, low.x, high.x), drawn.bottom + 10);
  c.front += side.svg + foot.svg;
  c.box.add(side.box);
  c.box.add(foot.box);
  return !foot.svg.empty();
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
  double shrink = 1;
  std::string body;
  Box box;
  bool tall = false;
  for (int round = 0; round < most_rounds; ++round) {  // arrows and labels take room that is known only when placed
    Canvas c{.display = display,
             .layout = layout_of(d, shrink),
             .behind = {},
             .front = {},
             .box = {},
             .obstacles = {},
             .labels = {},
             .roles = {}};
    for (const Shape& s : d.shapes) std::visit(Drawer{c}, s);
    if (c.box.empty()) c.box.add(Pixel{.x = 0, .y = 0});
    const Box machine = c.box;
    if (c.layout.is_polygon) turn_outward(c);
    const Placement placed =
        place_labels(c.labels, c.obstacles, {.frame = c.box, .bounds = {}, .taken = {}}, font_size);
    for (const Placed& p : placed.labels) c.box.add(p.box);
    const bool has_ruler = draw_rulers(c, d);
    const double list_top = c.box.bottom;
    c.front += list_svg(placed.list, {.x = c.box.left, .y = c.box.bottom + 12}, paper_width - 2 * drawing_margin,
                        font_size, c.box);
    const double list_height = c.box.bottom - list_top;
    draw_foot(c, d, !has_ruler);
    body = c.behind + c.front + to_svg(placed.labels, font_size);
    box = c.box.grown(drawing_margin);
    tall = box.height() > figure_height;
    const double too_wide = box.width() - paper_width;
    const double too_high = box.height() - list_height - figure_height;
    if (too_wide <= 0 && too_high <= 0) break;
    const double by_width = 1 - 1.04 * std::max(too_wide, 0.0) / std::max(machine.width(), 1.0);
    const double by_height = 1 - 1.04 * std::max(too_high, 0.0) / std::max(machine.height(), 1.0);
    shrink *= std::clamp(std::min(by_width, by_height), 0.5, 0.98);
  }
  return svg_element(tall ? "drawing tall" : "drawing", d.title, box, body);
}

std::string scale_words(const Drawing& d) {
  if (d.vertical_scale == 1 || !std::isfinite(d.vertical_scale) || !(d.vertical_scale > 0)) return {};
  return fmt::format("Heights are drawn {} times as large as lengths; angles are not true.",
                     number_shown(d.vertical_scale, 3));
}

}  // namespace taut::report
