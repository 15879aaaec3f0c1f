#include "taut/report/figure/svg_profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "taut/report/figure/pen.hpp"
#include "taut/report/figure/placement.hpp"
#include "taut/report/figure/text_width.hpp"
#include "taut/report/figure/ticks.hpp"
#include "taut/report/text/text.hpp"

namespace taut::report {
namespace {

constexpr double left_room = 62;  ///< for the names and numbers of the axes
constexpr double right_room = 16;
constexpr double least_line_height = 0.2;  ///< of the picture of the line, as a share of the width
constexpr double most_line_height = 0.34;
constexpr double band_height = 0.18;
constexpr double room_for_words = 0.14;  ///< above the highest value, as a share of it
constexpr double almost_one = 0.05;      ///< a scale of heights that no eye tells from that of lengths
constexpr double head_room = 16;         ///< above both pictures, pixels
constexpr std::size_t most_kinds = 6;    ///< colours: classes kind-0 to kind-5 of assets/figure.css
constexpr int longest_kind = 60;         ///< characters of a name in the legend

/// Smallest and largest of numbers that may be missing.
struct LineExtent {
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  void add(double v) {
    if (!std::isfinite(v)) return;
    low = std::min(low, v);
    high = std::max(high, v);
  }
  bool empty() const { return high < low; }
  double size() const { return high - low; }
};

/// What both pictures share, in metres: x, and the heights of the one above.
struct ProfileExtents {
  LineExtent x, z;
};

ProfileExtents extents_of(const Profile& p) {
  ProfileExtents e;
  const auto add = [&](const Point& point) {
    if (!is_finite(point)) return;
    e.x.add(point.x);
    e.z.add(point.y);
  };
  for (const Point& point : p.ground) add(point);
  for (const Profile::Rope& rope : p.ropes) {
    for (const Point& point : rope.points) add(point);
  }
  for (const Profile::Support& s : p.supports) {
    add(s.top);
    if (std::isfinite(s.ground)) add({.x = s.top.x, .y = s.ground});
  }
  for (const Profile::Place& place : p.places) {
    e.x.add(place.x);
    add({.x = place.x, .y = place.z});
  }
  return e;
}

/// Pixels of the upper picture.
struct ProfileLayout {
  std::vector<double> x_ticks, z_ticks, value_ticks;  ///< in shown units
  ShownUnit length;
  ShownUnit value;
  Box line;  ///< axes of the line's picture
  Box band;  ///< axes of what it bears
  double stretched = 1;

  double x(double metres) const {
    const double t = (length.of(metres) - x_ticks.front()) / (x_ticks.back() - x_ticks.front());
    return line.left + t * line.width();
  }
  double z(double metres) const {
    const double t = (length.of(metres) - z_ticks.front()) / (z_ticks.back() - z_ticks.front());
    return line.bottom - t * line.height();
  }
  double y(double stored) const {
    const double t = (value.of(stored) - value_ticks.front()) / (value_ticks.back() - value_ticks.front());
    return band.bottom - t * band.height();
  }
  Pixel pixel(Point p) const { return {.x = x(p.x), .y = z(p.y)}; }
};

/// Height of the upper picture for these sizes in metres, and how many times heights are larger than lengths in it.
std::pair<double, double> height_of_line(double paper, double wide, double high) {
  const double scale = (paper - left_room - right_room) / wide;
  const double height = std::clamp(high * scale, least_line_height * paper, most_line_height * paper);
  return {height, high > 0 ? height / (high * scale) : 1};
}

std::vector<double> ticks_over(LineExtent e, int count) {
  if (e.empty()) e = {.low = 0, .high = 1};
  if (e.size() <= 1e-9 * std::max(std::abs(e.low), std::abs(e.high)) || e.size() <= 0) {
    e.low -= 1;
    e.high += 1;
  }
  return nice_ticks(e.low, e.high, count);
}

/// Axes as long as what they show: x has no empty step at its ends.
std::vector<double> ticks_within(double low, double high, int count) {
  std::vector<double> all;
  for (const double t : nice_ticks(low, high, count)) {
    if (t >= low - 1e-9 * (high - low) && t <= high + 1e-9 * (high - low)) all.push_back(t);
  }
  return all;
}

ProfileLayout profile_layout(const Profile& p, const Display& display, double paper, double legend_height) {
  const ProfileExtents e = extents_of(p);
  ProfileLayout l{.x_ticks = {},
                  .z_ticks = {},
                  .value_ticks = {},
                  .length = shown_unit(si::m, display),
                  .value = shown_unit(p.value.unit, display),
                  .line = {},
                  .band = {}};
  const auto shown = [&](const LineExtent& metres) {
    LineExtent s;
    if (!metres.empty()) {
      s.add(l.length.of(metres.low));
      s.add(l.length.of(metres.high));
    }
    return s;
  };
  const LineExtent x = shown(e.x);
  l.x_ticks = {x.low, x.high};
  l.z_ticks = ticks_over(shown(e.z), 5);
  const double per_metre = l.length.of(1) - l.length.of(0);
  const auto [height, stretched] =
      height_of_line(paper, e.x.size(), (l.z_ticks.back() - l.z_ticks.front()) / per_metre);
  l.stretched = stretched;
  LineExtent values;
  values.add(0);
  for (const Profile::Place& place : p.places) {
    if (std::isfinite(place.value)) values.add(l.value.of(place.value));
  }
  if (std::isfinite(p.limit)) values.add(l.value.of(p.limit));
  values.high += room_for_words * values.size();
  l.value_ticks = ticks_over(values, 4);
  l.line = {.left = left_room, .top = head_room, .right = paper - right_room, .bottom = head_room + height};
  const double top = l.line.bottom + 22 + legend_height;
  l.band = {.left = l.line.left, .top = top, .right = l.line.right, .bottom = top + band_height * paper};
  return l;
}

std::string profile_tick(double v, const std::vector<double>& ticks) {
  std::string text = fmt::format("{:.{}f}", v == 0 ? 0.0 : v, tick_decimals(ticks));
  if (text.starts_with('-')) text = "−" + text.substr(1);
  return text;
}

/// Grid, numbers and the name of the vertical axis.
std::string vertical_axis(const Box& a, const std::vector<double>& ticks, const std::string& name) {
  std::string out;
  for (const double v : ticks) {
    const double y = a.bottom - (v - ticks.front()) / (ticks.back() - ticks.front()) * a.height();
    out += fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>", a.left, y, a.right);
    out += fmt::format("<text class=\"tick\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n", a.left - 7,
                       y + 4, profile_tick(v, ticks));
  }
  return out + fmt::format(
                   "<text class=\"label\" transform=\"translate(13 {:.1f}) rotate(-90)\" "
                   "text-anchor=\"middle\">{}</text>\n",
                   (a.top + a.bottom) / 2, escape(name));
}

std::string with_unit(const std::string& name, const ShownUnit& unit) {
  const std::string text = unit_text(unit);
  return text.empty() ? name : fmt::format("{} in {}", name, text);
}

std::string profile_axes(const Profile& p, const ProfileLayout& l) {
  std::string out = vertical_axis(l.line, l.z_ticks, with_unit("height", l.length));
  out += vertical_axis(l.band, l.value_ticks, with_unit(clean(p.value.label), l.value));
  const auto ticks = ticks_within(l.x_ticks.front(), l.x_ticks.back(), 8);
  for (const double v : ticks) {
    const double x = l.line.left + (v - l.x_ticks.front()) / (l.x_ticks.back() - l.x_ticks.front()) * l.line.width();
    for (const Box& a : {l.line, l.band})
      out += fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>", x, a.top, a.bottom);
    out += fmt::format("<text class=\"tick\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n", x,
                       l.band.bottom + 17, profile_tick(v, ticks));
  }
  return out + fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n",
                           (l.band.left + l.band.right) / 2, l.band.bottom + 37,
                           escape(with_unit("x of the carriage and of the line", l.length)));
}

/// The picture as it grows, and what its words may not cover.
struct ProfileSheet {
  const Profile& p;
  const ProfileLayout& l;
  const Display& display;
  std::string svg;
  std::vector<Obstacle> obstacles;
  std::vector<Wanted> words;

  void line(const std::vector<Pixel>& points, double weight) {
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (std::isfinite(points[i - 1].x) && std::isfinite(points[i].x))
        obstacles.push_back({points[i - 1], points[i], weight});
    }
  }
  void say(Pixel at, const std::string& text, Pixel toward, std::vector<Pixel> others = {}) {
    words.push_back({at, std::move(others), prose_runs(shortened(clean(text), longest_kind)), toward});
  }
  std::string length(double metres) const { return quantity_shown(metres, si::m, display, 3); }
};

std::vector<Pixel> pixels_of(const std::vector<Point>& points, const ProfileLayout& l) {
  std::vector<Pixel> all;
  all.reserve(points.size());
  for (const Point& p : points) all.push_back(is_finite(p) ? l.pixel(p) : Pixel{.x = NAN, .y = NAN});
  return all;
}

void draw_profile_ground(ProfileSheet& s) {
  if (s.p.ground.size() < 2) return;
  std::vector<Pixel> edge = pixels_of(s.p.ground, s.l);
  const Pen& own = pen(Role::ground);
  const std::string top = path_data(edge, false);
  s.svg += fmt::format("<path class=\"earth\" d=\"{}L{:.1f} {:.1f}L{:.1f} {:.1f}Z\"/>\n", top, edge.back().x,
                       s.l.line.bottom, edge.front().x, s.l.line.bottom);
  s.svg += fmt::format("<path {} d=\"{}\"/>\n", line_class(Role::ground), top);
  s.line(edge, own.weight);
}

void draw_profile_supports(ProfileSheet& s) {
  for (const Profile::Support& one : s.p.supports) {
    const Pixel top = s.l.pixel(one.top);
    std::string text = one.name;
    if (std::isfinite(one.ground)) {
      const Pixel foot = s.l.pixel({.x = one.top.x, .y = one.ground});
      s.svg += fmt::format("<path {} d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>", line_class(Role::structure), foot.x, foot.y,
                           top.x, top.y);
      s.obstacles.push_back({foot, top, 2});
      text += fmt::format(", {}", s.length(one.top.y - one.ground));
    }
    s.svg += fmt::format("<circle class=\"dot\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\"/>\n", top.x, top.y);
    s.say(top, text, {.x = 0, .y = -1});
  }
}

void draw_profile_ropes(ProfileSheet& s) {
  for (const Profile::Rope& rope : s.p.ropes) {
    const std::vector<Pixel> points = pixels_of(rope.points, s.l);
    s.svg += fmt::format("<path {} d=\"{}\"/>\n", line_class(rope.role), path_data(points, false));
    s.line(points, pen(rope.role).weight);
    std::vector<Pixel> finite;
    for (const Pixel& p : points) {
      if (std::isfinite(p.x)) finite.push_back(p);
    }
    if (finite.empty()) continue;
    std::vector<Pixel> others;
    for (const std::size_t part : {1U, 2U, 4U, 5U}) others.push_back(finite[part * (finite.size() - 1) / 6]);
    s.say(finite[finite.size() / 2], rope.name, {.x = 0, .y = -1}, others);
  }
}

/// The way of the carriage, the clearance that is asked for below it, and where it is least.
void draw_profile_way(ProfileSheet& s) {
  std::vector<Pixel> way, asked;
  const Profile::Place* lowest = nullptr;
  for (const Profile::Place& place : s.p.places) {
    const bool known = std::isfinite(place.z);
    way.push_back(known ? s.l.pixel({.x = place.x, .y = place.z}) : Pixel{.x = NAN, .y = NAN});
    const bool ground = known && std::isfinite(place.ground);
    asked.push_back(ground && std::isfinite(s.p.clearance)
                        ? s.l.pixel({.x = place.x, .y = place.ground + s.p.clearance})
                        : Pixel{.x = NAN, .y = NAN});
    if (ground && (lowest == nullptr || place.z - place.ground < lowest->z - lowest->ground)) lowest = &place;
  }
  s.svg += fmt::format("<path class=\"way\" d=\"{}\"/>\n", path_data(way, false));
  s.line(way, 2);
  const std::string line = path_data(asked, false);
  if (!line.empty()) {
    s.svg += fmt::format("<path class=\"limit\" d=\"{}\"/>\n", line);
    s.line(asked, 2);
  }
  if (lowest == nullptr) return;
  const Pixel above = s.l.pixel({.x = lowest->x, .y = lowest->z}),
              below = s.l.pixel({.x = lowest->x, .y = lowest->ground});
  s.svg +=
      fmt::format("<path class=\"dimension\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>", above.x, above.y, below.x, below.y);
  for (const auto& [tip, down] : {std::pair{above, -1.0}, std::pair{below, 1.0}})
    s.svg += arrow_head(tip, 0, down, 6, "dimension");
  s.obstacles.push_back({above, below, 2});
  s.say({.x = above.x, .y = (above.y + below.y) / 2}, "least clearance " + s.length(lowest->z - lowest->ground),
        {.x = 1, .y = 0});
}

void draw_profile_carriage(ProfileSheet& s) {
  if (!is_finite(s.p.carriage_at)) return;
  const Pixel at = s.l.pixel(s.p.carriage_at);
  s.svg += fmt::format("<rect class=\"carriage\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"14\" height=\"9\" rx=\"2\"/>\n",
                       at.x - 7, at.y - 1);
  s.obstacles.push_back({{.x = at.x - 8, .y = at.y + 4}, {.x = at.x + 8, .y = at.y + 4}, 4});
  s.say(at, s.p.carriage, {.x = 0, .y = 1});
}

/// What governs, each kind once, in the order of x; those without a colour of their own share the last one.
std::vector<std::string> kinds_of(const Profile& p) {
  std::vector<std::string> all;
  for (const Profile::Place& place : p.places) {
    if (!place.governs.empty() && std::find(all.begin(), all.end(), place.governs) == all.end())
      all.push_back(place.governs);
  }
  return all;
}

std::size_t tint_of(const std::vector<std::string>& kinds, const std::string& kind) {
  const auto at = static_cast<std::size_t>(std::find(kinds.begin(), kinds.end(), kind) - kinds.begin());
  return std::min(at, most_kinds - 1);
}

/// A sample of a colour or of a line, and its name.
struct ProfileEntry {
  std::string kind;  ///< class of the sample
  std::string name;
  bool line = false;
};

std::vector<ProfileEntry> profile_entries(const Profile& p, const std::vector<std::string>& kinds,
                                          const Display& display) {
  std::vector<ProfileEntry> all;
  const auto known = [&](auto&& of) { return std::any_of(p.places.begin(), p.places.end(), of); };
  if (known([](const auto& one) { return std::isfinite(one.z); }))
    all.push_back({.kind = "way", .name = fmt::format("way of {}", clean(p.carriage)), .line = true});
  if (std::isfinite(p.clearance)) {
    const std::string asked = quantity_shown(p.clearance, si::m, display, 3);
    all.push_back({.kind = "limit", .name = fmt::format("clearance asked for, {}", asked), .line = true});
  }
  for (std::size_t i = 0; i < kinds.size() && i < most_kinds; ++i) {
    const bool shared = i + 1 == most_kinds && kinds.size() > most_kinds;
    const std::string name = shared ? "other limits" : shortened(clean(kinds[i]), longest_kind);
    all.push_back({.kind = fmt::format("kind-{}", i), .name = (i == 0 ? "governs: " : "") + name});
  }
  if (known([](const auto& one) { return std::isnan(one.value); })) all.push_back({.kind = "gap", .name = "no answer"});
  return all;
}

/// Rows of samples with names from the place `from` on; the height that they take.
double profile_legend(std::string& out, const std::vector<ProfileEntry>& entries, Pixel from, double right) {
  double x = from.x, y = from.y + 9;
  for (const ProfileEntry& e : entries) {
    const Runs runs = prose_runs(e.name);
    const double needed = 24 + text_width(runs, font_size) + 20;
    if (x > from.x && x + needed > right) {
      x = from.x;
      y += 19;
    }
    out += e.line ? fmt::format("<path class=\"{}\" d=\"M{:.1f} {:.1f}h17\"/>", e.kind, x, y)
                  : fmt::format("<rect class=\"sample {}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"17\" height=\"11\"/>",
                                e.kind, x, y - 6);
    out += fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x + 23, y + 4, to_svg(runs));
    x += needed;
  }
  return entries.empty() ? 0 : y + 12 - from.y;
}

/// The x at which the place's share of the band begins and ends: half way to its neighbours.
std::pair<double, double> share_of(const Profile& p, std::size_t i) {
  const double x = p.places[i].x;
  const double before = i == 0 ? x : (p.places[i - 1].x + x) / 2;
  const double behind = i + 1 == p.places.size() ? x : (p.places[i + 1].x + x) / 2;
  return {before, behind};
}

double value_between(const Profile& p, std::size_t i, std::size_t j) {
  const double other = p.places[j].value;
  return std::isnan(other) ? p.places[i].value : (p.places[i].value + other) / 2;
}

/// A stretch of the band with one colour: its upper edge from the left to the right.
struct BandStretch {
  std::string kind;
  std::vector<Pixel> top;
};

void draw_band(ProfileSheet& s, const std::vector<std::string>& kinds) {
  const Profile& p = s.p;
  const double zero = s.l.y(0);
  std::vector<Pixel> edge;
  std::vector<BandStretch> stretches;
  for (std::size_t i = 0; i < p.places.size(); ++i) {
    const Profile::Place& place = p.places[i];
    const auto [from, to] = share_of(p, i);
    const double a = s.l.x(from), b = s.l.x(to);
    if (std::isnan(place.value)) {
      s.svg += fmt::format("<rect class=\"gap\" x=\"{:.2f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"{:.1f}\"/>", a,
                           s.l.band.top, std::max(0.6, b - a), s.l.band.height());
      edge.push_back({.x = NAN, .y = NAN});
      stretches.emplace_back();
      continue;
    }
    const double left = i == 0 ? place.value : value_between(p, i, i - 1);
    const double right = i + 1 == p.places.size() ? place.value : value_between(p, i, i + 1);
    const Pixel here{.x = s.l.x(place.x), .y = s.l.y(place.value)};
    // a place where nothing is carried would not be seen
    const double least = place.value <= 0 && !place.governs.empty() ? 5 : 0;
    const std::string kind = fmt::format("kind-{}", tint_of(kinds, place.governs));
    if (stretches.empty() || stretches.back().kind != kind) stretches.push_back({.kind = kind, .top = {}});
    for (const Pixel q : {Pixel{.x = a, .y = s.l.y(left)}, here, Pixel{.x = b, .y = s.l.y(right)}})
      stretches.back().top.push_back({.x = q.x, .y = q.y - least});
    edge.push_back(here);
  }
  for (const BandStretch& one : stretches) {
    if (one.top.empty()) continue;
    s.svg += fmt::format("<path class=\"{}\" d=\"M{:.2f} {:.1f}", one.kind, one.top.front().x, zero);
    for (const Pixel q : one.top) s.svg += fmt::format("L{:.2f} {:.1f}", q.x, q.y);
    s.svg += fmt::format("L{:.2f} {:.1f}Z\"/>\n", one.top.back().x, zero);
  }
  s.svg += fmt::format("<path class=\"edge\" d=\"{}\"/>\n", path_data(edge, false));
  s.line(edge, 3);
}

void draw_limit_of_band(ProfileSheet& s) {
  if (!std::isfinite(s.p.limit)) return;
  const double y = s.l.y(s.p.limit);
  s.svg += fmt::format("<path class=\"limit\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>\n", s.l.band.left, y, s.l.band.right);
}

/// The line of the decisive place through one of the two pictures; the legend between them stays free.
void mark_decisive(ProfileSheet& s, const Box& frame) {
  if (s.p.decisive >= s.p.places.size() || std::isnan(s.p.places[s.p.decisive].value)) return;
  const double x = s.l.x(s.p.places[s.p.decisive].x);
  s.svg += fmt::format("<path class=\"event\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>\n", x, frame.top, frame.bottom);
  s.obstacles.push_back({{.x = x, .y = frame.top}, {.x = x, .y = frame.bottom}, 2});
}

void draw_decisive(ProfileSheet& s) {
  if (s.p.decisive >= s.p.places.size()) return;
  const Profile::Place& place = s.p.places[s.p.decisive];
  if (std::isnan(place.value)) return;
  const Pixel at{.x = s.l.x(place.x), .y = s.l.y(place.value)};
  mark_decisive(s, s.l.band);
  s.svg += fmt::format("<circle class=\"mark\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4.2\"/>\n", at.x, at.y);
  s.obstacles.push_back({{.x = at.x - 5, .y = at.y}, {.x = at.x + 5, .y = at.y}, 3});
  s.say(at, fmt::format("{} at x = {}", quantity_shown(place.value, s.p.value.unit, s.display, 3), s.length(place.x)),
        {.x = 0, .y = -1});
}

/// The words of one of the two pictures, in its frame. Those without a place come into `list`, numbered.
std::string placed_words(ProfileSheet& s, const Box& frame, std::vector<Listed>& list) {
  for (const double y : {frame.top, frame.bottom})
    s.obstacles.push_back({{.x = frame.left, .y = y}, {.x = frame.right, .y = y}, 3});
  for (const double x : {frame.left, frame.right})
    s.obstacles.push_back({{.x = x, .y = frame.top}, {.x = x, .y = frame.bottom}, 3});
  const Box inside = frame.grown(-3);
  Placement placed = place_labels(s.words, s.obstacles, {.frame = inside, .bounds = inside, .taken = {}}, font_size);
  const std::string out = to_svg(placed.labels, font_size);
  std::move(placed.list.begin(), placed.list.end(), std::back_inserter(list));
  s.words.clear();
  s.obstacles.clear();
  return out;
}

bool can_be_shown(const Profile& p) {
  const ProfileExtents e = extents_of(p);
  return !e.x.empty() && e.x.size() > 0 && !e.z.empty();
}

std::string frame_svg(const Box& a) {
  return fmt::format("<rect class=\"frame\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n", a.left,
                     a.top, a.width(), a.height());
}

}  // namespace

std::string profile_svg(const Profile& p, const Display& display, double wide) {
  if (!can_be_shown(p)) return "<p class=\"empty\">Nothing to draw.</p>";
  const std::vector<std::string> kinds = kinds_of(p);
  const std::vector<ProfileEntry> entries = profile_entries(p, kinds, display);
  std::string legend;
  const double legend_height = profile_legend(legend, entries, {.x = left_room, .y = 0}, wide);
  const ProfileLayout l = profile_layout(p, display, wide, legend_height);
  legend.clear();
  profile_legend(legend, entries, {.x = left_room, .y = l.line.bottom + 12}, wide);
  ProfileSheet s{.p = p, .l = l, .display = display, .svg = profile_axes(p, l), .obstacles = {}, .words = {}};
  draw_profile_ground(s);
  draw_profile_supports(s);
  draw_profile_way(s);
  draw_profile_ropes(s);
  mark_decisive(s, l.line);
  draw_profile_carriage(s);
  std::vector<Listed> list;
  std::string body = placed_words(s, l.line, list);
  draw_band(s, kinds);
  draw_limit_of_band(s);
  draw_decisive(s);
  body += placed_words(s, l.band, list);
  Box box{.left = 0, .top = 0, .right = wide, .bottom = l.band.bottom + 46};
  body += list_svg(list, {.x = left_room, .y = box.bottom + 6}, wide - left_room, font_size, box);
  return svg_element("profile", p.title, box, s.svg + frame_svg(l.line) + frame_svg(l.band) + legend + body);
}

std::string profile_scale_words(const Profile& p, double wide) {
  if (!can_be_shown(p)) return {};
  const double stretched = profile_layout(p, Display(), wide, 0).stretched;
  if (std::abs(stretched - 1) < almost_one) return {};
  return fmt::format("Heights are drawn {} times as large as lengths; angles are not true.",
                     number_shown(stretched, 2));
}

}  // namespace taut::report
