#include "taut/report/figure/animation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "taut/report/embedded/animation_js.hpp"
#include "taut/report/figure/pen.hpp"
#include "taut/report/figure/placement.hpp"
#include "taut/report/figure/ticks.hpp"
#include "taut/report/text/text.hpp"

namespace taut::report {
namespace {

constexpr double largest_height = 420;
constexpr double animation_margin = 18;
constexpr double smallest_round = 2.5;  ///< pixels
constexpr std::size_t most_numbers = 40000;
constexpr std::size_t most_times = 240;

/// Metres to pixels: the whole motion fits.
struct View {
  double scale = 1;
  double left = 0, top = 0;  ///< of the machine, m
  double width = 0, height = 0;
  double x(double m) const { return animation_margin + (m - left) * scale; }
  double y(double m) const { return animation_margin + (top - m) * scale; }
};

View view_of(const Animation& a) {
  double low_x = HUGE_VAL, high_x = -HUGE_VAL, low_y = HUGE_VAL, high_y = -HUGE_VAL;
  const auto add = [&](const Point& p, double r) {
    if (!is_finite(p)) return;
    low_x = std::min(low_x, p.x - r), high_x = std::max(high_x, p.x + r);
    low_y = std::min(low_y, p.y - r), high_y = std::max(high_y, p.y + r);
  };
  for (const auto& line : a.lines) {
    for (const auto& frame : line.points) {
      for (const Point& p : frame) add(p, 0);
    }
  }
  for (const auto& round : a.rounds) {
    for (const Point& p : round.at) add(p, round.radius);
  }
  View v;
  if (high_x < low_x) return v;
  const double w = std::max(high_x - low_x, 1e-9), h = std::max(high_y - low_y, 1e-9);
  v.scale = std::min((paper_width - 2 * animation_margin) / w, largest_height / h);
  v.left = low_x;
  v.top = high_y;
  v.width = std::max(w * v.scale + 2 * animation_margin, 320.0);
  v.height = h * v.scale + 2 * animation_margin + 24;  // a row for the scale bar
  v.left -= (v.width - 2 * animation_margin - w * v.scale) / 2 / v.scale;
  return v;
}

/// Which times are kept: evenly spaced, the first and the last among them.
std::vector<std::size_t> kept_times(const Animation& a) {
  std::size_t numbers = 2 + a.readouts.size();
  for (const auto& line : a.lines) {
    std::size_t longest = 0;
    for (const auto& frame : line.points) longest = std::max(longest, frame.size());
    numbers += 2 * longest;
  }
  numbers += 3 * a.rounds.size();
  const std::size_t wanted = std::clamp<std::size_t>(most_numbers / numbers, 2, most_times);
  const std::size_t count = std::min(wanted, a.t.size());
  std::vector<std::size_t> kept;
  kept.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    kept.push_back(i * (a.t.size() - 1) / std::max<std::size_t>(count - 1, 1));
  }
  return kept;
}

/// Pixels to a tenth, as whole numbers.
std::string tenths(double pixels) { return fmt::format("{:.0f}", std::isfinite(pixels) ? pixels * 10 : -1e5); }

/// All equal frames are written once.
std::string frames_text(std::vector<std::string> frames) {
  if (std::all_of(frames.begin(), frames.end(), [&](const auto& f) { return f == frames.front(); })) frames.resize(1);
  return fmt::format("[{}]", fmt::join(frames, ","));
}

std::string line_data(const Animation::Line& line, const View& v, const std::vector<std::size_t>& kept) {
  std::vector<std::string> frames;
  for (const std::size_t i : kept) {
    std::string flat;
    for (const Point& p : line.points[i]) {
      if (is_finite(p)) flat += fmt::format("{}{},{}", flat.empty() ? "" : ",", tenths(v.x(p.x)), tenths(v.y(p.y)));
    }
    frames.push_back("[" + flat + "]");
  }
  return frames_text(std::move(frames));
}

std::string round_data(const Animation::Round& round, const View& v, const std::vector<std::size_t>& kept) {
  std::vector<std::string> frames;
  for (const std::size_t i : kept) {
    const double angle = round.angle.empty() ? 0 : round.angle[i];
    // on the screen y points down: the same sense of rotation has the other sign
    const double degrees = std::isfinite(angle) ? -std::remainder(angle, 2 * M_PI) * 180 / M_PI : 0;
    frames.push_back(fmt::format("[{},{},{:.0f}]", tenths(v.x(round.at[i].x)), tenths(v.y(round.at[i].y)), degrees));
  }
  return frames_text(std::move(frames));
}

std::string json_text(const std::string& text) {
  std::string out = "\"";
  for (const char c : clean(text)) {
    if (c == '"' || c == '\\') out += '\\';
    out += c == '<' ? "\\u003c" : std::string(1, c);
  }
  return out + "\"";
}

std::string readout_data(const Animation::Readout& r, const Display& display, const std::vector<std::size_t>& kept) {
  const ShownUnit unit = shown_unit(r.unit, display);
  std::vector<std::string> values;
  values.reserve(kept.size());
  for (const std::size_t i : kept) values.push_back(json_text(number_shown(unit.of(r.value[i]), 4)));
  return fmt::format("[{},{},[{}]]", json_text(r.label), json_text(unit_text(unit)), fmt::join(values, ","));
}

std::string svg_line(const Animation::Line& line, const View& v) {
  std::string points;
  for (const Point& p : line.points.front()) {
    if (is_finite(p)) points += fmt::format("{:.1f},{:.1f} ", v.x(p.x), v.y(p.y));
  }
  return fmt::format("<polyline points=\"{}\" fill=\"none\" {}/>\n", points, stroke_of(pen(line.role)));
}

/// Where the name stands beside its round: above it to the right as a rule.
struct LabelPlace {
  bool left = false, below = false;
};

/// What the name covers at one time, pixels.
Box label_box(const Animation::Round& round, const View& v, std::size_t time, LabelPlace place) {
  const Point& p = round.at[std::min(time, round.at.size() - 1)];
  if (!is_finite(p)) return {};
  const double away = std::max(round.radius * v.scale, smallest_round) + 3, x = v.x(p.x), y = v.y(p.y);
  const double width = 0.56 * font_size * length(round.label);
  Box box;
  box.add(Pixel{.x = place.left ? x - away - width : x + away, .y = place.below ? y + away : y - away - font_size});
  box.add(Pixel{.x = place.left ? x - away : x + away + width, .y = place.below ? y + away + font_size : y - away});
  return box;
}

/// How often a round's name at that place touches, over all times, the names before it or the picture's edge.
double label_cost(const Animation& a, const View& v, LabelPlace place, const std::vector<LabelPlace>& before) {
  constexpr std::size_t looks = 60;
  constexpr double edge = 10;  ///< times as bad as another name
  const std::size_t every = std::max<std::size_t>(1, a.t.size() / looks);
  const Animation::Round& round = a.rounds[before.size()];
  double cost = 0;
  for (std::size_t t = 0; t < a.t.size(); t += every) {
    const Box box = label_box(round, v, t, place);
    if (box.empty()) continue;
    if (box.left < 0 || box.right > v.width || box.top < 0 || box.bottom > v.height) cost += edge;
    for (std::size_t other = 0; other < before.size(); ++other) {
      if (a.rounds[other].label.empty()) continue;
      if (overlap_area(box, label_box(a.rounds[other], v, t, before[other])) > 0) ++cost;
    }
  }
  return cost;
}

/// A place for each name that keeps clear of the names before it and of the picture's edge.
std::vector<LabelPlace> label_places(const Animation& a, const View& v) {
  std::vector<LabelPlace> places;
  for (std::size_t r = 0; r < a.rounds.size(); ++r) {
    LabelPlace best;
    double least = std::numeric_limits<double>::infinity();
    for (const LabelPlace place : {LabelPlace{.left = false, .below = false},
                                   {.left = false, .below = true},
                                   {.left = true, .below = false},
                                   {.left = true, .below = true}}) {
      const double cost = label_cost(a, v, place, places);
      if (cost >= least) continue;
      least = cost;
      best = place;
    }
    places.push_back(best);
  }
  return places;
}

std::string round_label(const Animation::Round& round, LabelPlace place, double radius) {
  if (round.label.empty()) return {};
  return fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\"{}>{}</text>",
                     place.left ? -radius - 3 : radius + 3, place.below ? radius + font_size : -radius - 2,
                     place.left ? " text-anchor=\"end\"" : "", escape(round.label));
}

std::string svg_round(const Animation::Round& round, const View& v, LabelPlace place) {
  const Pen& p = pen(round.role);
  const double radius = std::max(round.radius * v.scale, smallest_round);
  const bool dot = round.radius * v.scale < smallest_round;
  const std::string spoke =
      round.angle.empty() || dot ? "" : fmt::format("<path d=\"M0 0H{:.1f}\" {}/>", radius, stroke_of(p));
  const Point at = round.at.front();
  return fmt::format("<g transform=\"translate({:.1f} {:.1f})\"><circle r=\"{:.1f}\" fill=\"{}\" {}/><g>{}</g>{}</g>\n",
                     v.x(at.x), v.y(at.y), radius, dot ? p.stroke : "#fff", stroke_of(p), spoke,
                     round_label(round, place, radius));
}

std::string scale_bar(const View& v, const Display& display) {
  const ShownUnit unit = shown_unit(si::m, display);
  const double length = nice_below(90 / v.scale * unit.of(1)) / unit.of(1);
  const double y = v.height - 12, x = animation_margin;
  return fmt::format(
      "<path class=\"bar\" d=\"M{0:.1f} {1:.1f}v6M{0:.1f} {2:.1f}h{3:.1f}M{4:.1f} {1:.1f}v6\"/><text class=\"label\" "
      "x=\"{5:.1f}\" y=\"{6:.1f}\">{7}</text>\n",
      x, y - 3, y, length * v.scale, x + length * v.scale, x + length * v.scale + 6, y + 4,
      escape(quantity_shown(length, si::m, display)));
}

std::string data_text(const Animation& a, const View& v, const Display& display, const std::vector<std::size_t>& kept) {
  std::vector<std::string> times, lines, rounds, readouts, events;
  for (const std::size_t i : kept) times.push_back(fmt::format("{:.6g}", a.t[i]));
  for (const auto& line : a.lines) lines.push_back(line_data(line, v, kept));
  for (const auto& round : a.rounds) rounds.push_back(round_data(round, v, kept));
  for (const auto& r : a.readouts) readouts.push_back(readout_data(r, display, kept));
  for (const auto& [t, words] : a.events) events.push_back(fmt::format("[{:.6g},{}]", t, json_text(words)));
  return fmt::format("{{t:[{}],l:[{}],c:[{}],r:[{}],e:[{}]}}", fmt::join(times, ","), fmt::join(lines, ","),
                     fmt::join(rounds, ","), fmt::join(readouts, ","), fmt::join(events, ","));
}

constexpr std::string_view style =
    "<style>.motion{display:none;align-items:center;gap:10px;font-size:13px}.motion input{flex:1}.motion "
    "output{min-width:7em;"
    "font-variant-numeric:tabular-nums}.readings{display:none;gap:4px 22px;flex-wrap:wrap;font-size:13px;"
    "font-variant-numeric:tabular-nums}@media print{.motion,.readings{display:none!important}}</style>\n";

}  // namespace

std::string animation_html(const Animation& a, const Display& display, int number) {
  if (a.t.size() < 2 || (a.lines.empty() && a.rounds.empty())) return {};
  const View v = view_of(a);
  const std::vector<std::size_t> kept = kept_times(a);
  std::string body;
  for (const auto& line : a.lines) body += svg_line(line, v);
  const std::vector<LabelPlace> places = label_places(a, v);
  for (std::size_t r = 0; r < a.rounds.size(); ++r) body += svg_round(a.rounds[r], v, places[r]);
  const std::string svg = fmt::format(
      "<svg class=\"moving\" id=\"motion{}\" role=\"img\" aria-label=\"{}\" viewBox=\"0 0 {:.0f} {:.0f}\" "
      "width=\"{:.0f}\" height=\"{:.0f}\">\n{}{}</svg>\n",
      number, escape(a.title), v.width, v.height, v.width, v.height, body, scale_bar(v, display));
  const std::string controls =
      "<div class=\"motion\"><button type=\"button\" aria-label=\"play\">▶</button><input type=\"range\" min=\"0\" "
      "value=\"0\" step=\"1\" aria-label=\"time\"><output></output></div><div class=\"readings\"></div>\n";
  return fmt::format("{}{}{}<script>({})({},{})</script>\n", number == 0 ? style : "", svg, controls,
                     embedded::animation_js, number, data_text(a, v, display, kept));
}

}  // namespace taut::report
