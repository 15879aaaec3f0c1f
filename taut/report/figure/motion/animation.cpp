#include "taut/report/figure/motion/animation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "taut/report/embedded/animation_js.hpp"
#include "taut/report/figure/event_lane.hpp"
#include "taut/report/figure/motion/motion_strip.hpp"
#include "taut/report/figure/motion/motion_view.hpp"
#include "taut/report/figure/pen.hpp"
#include "taut/report/figure/tension_scale.hpp"
#include "taut/report/figure/text_width.hpp"
#include "taut/report/text/text.hpp"

namespace taut::report {
namespace {

constexpr double largest_height = 420;
constexpr double animation_margin = 18;
constexpr double smallest_round = 2.5;  ///< pixels
constexpr double name_row = 19;
constexpr double most_names_width = 180;  ///< of the names in the margin
constexpr std::size_t most_numbers = 40000;
constexpr std::size_t most_times = 240;

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

/// Where everything stands in the picture that plays.
struct Stage {
  MotionView view;
  Pixel origin;  ///< of the view in the picture
  Pixel of(Point p) const {
    const Pixel q = view.of(p);
    return {.x = q.x + origin.x, .y = q.y + origin.y};
  }
  double radius(const Animation::Round& r) const { return std::max(r.radius * view.scale, smallest_round); }
};

/// Pixels to a tenth, as whole numbers.
std::string tenths(double pixels) { return fmt::format("{:.0f}", std::isfinite(pixels) ? pixels * 10 : -1e5); }

/// All equal frames are written once.
std::string frames_text(std::vector<std::string> frames) {
  if (std::all_of(frames.begin(), frames.end(), [&](const auto& f) { return f == frames.front(); })) frames.resize(1);
  return fmt::format("[{}]", fmt::join(frames, ","));
}

std::string line_data(const Animation::Line& line, const Stage& v, const std::vector<std::size_t>& kept) {
  std::vector<std::string> frames;
  for (const std::size_t i : kept) {
    std::string flat;
    for (const Point& p : line.points[i]) {
      const Pixel q = v.of(p);
      if (is_finite(p)) flat += fmt::format("{}{},{}", flat.empty() ? "" : ",", tenths(q.x), tenths(q.y));
    }
    frames.push_back("[" + flat + "]");
  }
  return frames_text(std::move(frames));
}

std::string round_data(const Animation::Round& round, const Stage& v, const std::vector<std::size_t>& kept) {
  std::vector<std::string> frames;
  for (const std::size_t i : kept) {
    const double angle = round.angle.empty() ? 0 : round.angle[i];
    // on the screen y points down: the same sense of rotation has the other sign
    const double degrees = std::isfinite(angle) ? -std::remainder(angle, 2 * M_PI) * 180 / M_PI : 0;
    const Pixel q = v.of(round.at[i]);
    frames.push_back(fmt::format("[{},{},{:.0f}]", tenths(q.x), tenths(q.y), degrees));
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

std::string svg_line(const Animation::Line& line, const Stage& v, const TensionScale& tensions) {
  std::string points;
  for (const Point& p : line.points.front()) {
    const Pixel q = v.of(p);
    if (is_finite(p)) points += fmt::format("{:.1f},{:.1f} ", q.x, q.y);
  }
  return fmt::format("<polyline class=\"{}\" points=\"{}\"/>\n", line_classes(line, 0, tensions), points);
}

/// A name beside its round: on one of its four corners, or, where it would touch something at some time, in the margin
/// on the right with a line to the round.
struct NamePlace {
  bool in_margin = true;
  bool left = false, below = false;
  Pixel at;  ///< of the left end of the line of text, in the margin
};

/// What a name on a corner covers at one time.
Box name_box(const Animation::Round& round, const Stage& v, std::size_t time, const NamePlace& place) {
  const Point& p = round.at[std::min(time, round.at.size() - 1)];
  if (!is_finite(p)) return {};
  const Pixel q = v.of(p);
  const double away = v.radius(round) + 3, wide = text_width(round.label, font_size);
  const double base = place.below ? q.y + v.radius(round) + font_size : q.y - v.radius(round) - 3;
  return {.left = place.left ? q.x - away - wide : q.x + away,
          .top = base - ascent(font_size),
          .right = place.left ? q.x - away : q.x + away + wide,
          .bottom = base + descent(font_size)};
}

bool stays_clear(const Animation& a, const Stage& v, std::size_t r, const NamePlace& place, const Box& picture,
                 const std::vector<NamePlace>& before) {
  const Animation::Round& round = a.rounds[r];
  for (std::size_t t = 0; t < a.t.size(); ++t) {
    const Box box = name_box(round, v, t, place);
    if (box.empty()) continue;
    if (box.left < picture.left || box.right > picture.right || box.top < picture.top || box.bottom > picture.bottom)
      return false;
    for (std::size_t other = 0; other < before.size(); ++other) {
      if (before[other].in_margin || a.rounds[other].label.empty()) continue;
      if (overlap_area(box, name_box(a.rounds[other], v, t, before[other])) > 0) return false;
    }
  }
  return true;
}

/// Places of all names; those in the margin from `margin_left` on, in the order of their rounds' heights. Returns the
/// lower end of the margin's names.
double place_names(const Animation& a, const Stage& v, const Box& picture, double margin_left,
                   std::vector<NamePlace>& places) {
  std::vector<std::size_t> aside;
  for (std::size_t r = 0; r < a.rounds.size(); ++r) {
    NamePlace place;
    for (const bool left : {false, true}) {
      for (const bool below : {false, true}) {
        const NamePlace corner{.in_margin = false, .left = left, .below = below, .at = {}};
        if (place.in_margin && stays_clear(a, v, r, corner, picture, places)) place = corner;
      }
    }
    places.push_back(place);
    if (place.in_margin && !a.rounds[r].label.empty()) aside.push_back(r);
  }
  const auto height = [&](std::size_t r) {
    const Point p = a.rounds[r].at.front();
    return is_finite(p) ? v.of(p).y : picture.bottom;
  };
  std::stable_sort(aside.begin(), aside.end(), [&](auto x, auto y) { return height(x) < height(y); });
  std::vector<double> at, high(aside.size(), name_row);
  at.reserve(aside.size());
  for (const std::size_t r : aside) at.push_back(height(r));
  const double needed = name_row * static_cast<double>(aside.size());
  const double bottom = std::max(picture.bottom, picture.top + needed);
  const std::vector<double> centers = spread(at, high, 0, picture.top, bottom);
  for (std::size_t i = 0; i < aside.size(); ++i) places[aside[i]].at = {.x = margin_left, .y = centers[i] + 4};
  return aside.empty() ? picture.bottom : bottom;
}

std::string svg_round(const Animation::Round& round, const Stage& v, const NamePlace& place) {
  const double radius = v.radius(round);
  const bool dot = round.radius * v.view.scale < smallest_round;
  const std::string name(pen(round.role).name);
  const std::string spoke =
      round.angle.empty() || dot ? "" : fmt::format("<path class=\"line {}\" d=\"M0 0H{:.1f}\"/>", name, radius);
  std::string label;
  if (!place.in_margin && !round.label.empty()) {
    label = fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\"{}>{}</text>",
                        place.left ? -radius - 3 : radius + 3, place.below ? radius + font_size : -radius - 3,
                        place.left ? " text-anchor=\"end\"" : "", escape(round.label));
  }
  const Pixel at = v.of(round.at.front());
  return fmt::format("<g transform=\"translate({:.1f} {:.1f})\"><circle class=\"{}\" r=\"{:.1f}\"/><g>{}</g>{}</g>\n",
                     at.x, at.y, dot ? "dot" : fmt::format("wheel line {}", name), radius, spoke, label);
}

/// Names in the margin with their lines, which the script moves; one path per round, empty where the name is beside it.
std::string margin_names(const Animation& a, const Stage& v, const std::vector<NamePlace>& places) {
  std::string lines, names;
  for (std::size_t r = 0; r < a.rounds.size(); ++r) {
    const bool shown = places[r].in_margin && !a.rounds[r].label.empty();
    const Pixel to = v.of(a.rounds[r].at.front());
    lines += shown && is_finite(a.rounds[r].at.front())
                 ? fmt::format("<path class=\"leader\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>", places[r].at.x - 4,
                               places[r].at.y - 4, to.x, to.y)
                 : "<path class=\"leader\" d=\"\"/>";
    if (!shown) continue;
    names += fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", places[r].at.x, places[r].at.y,
                         escape(a.rounds[r].label));
  }
  return lines + names;
}

std::string data_text(const Animation& a, const Stage& v, const Display& display,
                      const std::vector<std::size_t>& kept) {
  const TensionScale tensions = tension_scale(a);
  std::vector<std::string> times, lines, rounds, readouts, events, colours;
  for (const std::size_t i : kept) times.push_back(fmt::format("{:.6g}", a.t[i]));
  for (const auto& line : a.lines) {
    lines.push_back(line_data(line, v, kept));
    std::string letters;
    for (const std::size_t i : kept) letters += tension_letter(line, i, tensions);
    const bool same = letters.find_first_not_of(letters.front()) == std::string::npos;
    colours.push_back(same ? "0" : "\"" + letters + "\"");
  }
  for (const auto& round : a.rounds) rounds.push_back(round_data(round, v, kept));
  for (const auto& r : a.readouts) readouts.push_back(readout_data(r, display, kept));
  for (const auto& [t, words] : a.events) events.push_back(fmt::format("[{:.6g},{}]", t, json_text(words)));
  return fmt::format("{{t:[{}],l:[{}],k:[{}],c:[{}],r:[{}],e:[{}]}}", fmt::join(times, ","), fmt::join(lines, ","),
                     fmt::join(colours, ","), fmt::join(rounds, ","), fmt::join(readouts, ","), fmt::join(events, ","));
}

/// Labels that a deck may make as long as it likes.
Animation with_short_names(Animation a) {
  for (auto& round : a.rounds) round.label = shortened(clean(round.label), 24);
  return a;
}

}  // namespace

std::string animation_html(const Animation& animation, const Display& display, int number) {
  if (animation.t.size() < 2 || (animation.lines.empty() && animation.rounds.empty())) return {};
  const Animation a = with_short_names(animation);
  const MotionView view = motion_view(a, paper_width - 2 * animation_margin - most_names_width, largest_height);
  const Stage v{.view = view, .origin = {.x = animation_margin, .y = animation_margin}};
  const Box picture{
      .left = 2, .top = 2, .right = view.wide + 2 * animation_margin + 40, .bottom = view.high + 2 * animation_margin};
  std::vector<NamePlace> places;
  const double names_end = place_names(a, v, picture, picture.right + 14, places);
  const TensionScale tensions = tension_scale(a);
  std::string body;
  for (const auto& line : a.lines) body += svg_line(line, v, tensions);
  for (std::size_t r = 0; r < a.rounds.size(); ++r) body += svg_round(a.rounds[r], v, places[r]);
  body += margin_names(a, v, places);
  Box box = picture;
  box.left = box.top = 0;
  box.bottom = names_end;
  for (std::size_t r = 0; r < a.rounds.size(); ++r) {
    if (places[r].in_margin && !a.rounds[r].label.empty())
      box.add(Pixel{.x = places[r].at.x + text_width(a.rounds[r].label, font_size) + 4, .y = places[r].at.y + 6});
  }
  Box foot;
  body += length_bar(view, display, {.x = animation_margin, .y = box.bottom + 14}, foot);
  body += tension_legend(tensions, display, {.x = foot.right + 30, .y = box.bottom + 14}, foot);
  box.add(foot.grown(4));
  const std::string moving = svg_element("moving", a.title, box, body);
  const std::string controls =
      "<div class=\"motion\"><button type=\"button\" aria-label=\"play\">▶</button><input type=\"range\" min=\"0\" "
      "value=\"0\" step=\"1\" aria-label=\"time\"><output></output></div><div class=\"readings\"></div>\n";
  return fmt::format("<div class=\"plays\" id=\"motion{}\">{}{}{}</div><script>({})({},{})</script>\n", number,
                     strip_svg(a, display), moving, controls, embedded::animation_js, number,
                     data_text(a, v, display, kept_times(a)));
}

}  // namespace taut::report
