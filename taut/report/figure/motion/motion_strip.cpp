#include "taut/report/figure/motion/motion_strip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/report/figure/motion/motion_view.hpp"
#include "taut/report/figure/pen.hpp"
#include "taut/report/figure/tension_scale.hpp"
#include "taut/report/figure/text_width.hpp"
#include "taut/report/text/text.hpp"

namespace taut::report {
namespace {

constexpr std::size_t most_moments = 6;
constexpr std::size_t most_events = 2;  ///< so that moments between them have room
constexpr double panel_gap = 26;
constexpr double strip_height = 375;  ///< of all panels with their words
constexpr double caption_row = 17;
constexpr double caption_rows = 3.5;
constexpr double smallest_dot = 2.2;

std::size_t frame_at(const Animation& a, double t) {
  const auto after = std::lower_bound(a.t.begin(), a.t.end(), t);
  if (after == a.t.end()) return a.t.size() - 1;
  if (after == a.t.begin()) return 0;
  return static_cast<std::size_t>(after - a.t.begin()) - (*after - t > t - *(after - 1) ? 1 : 0);
}

double largest_tension(const Animation& a, std::size_t frame) {
  double most = NAN;
  for (const auto& line : a.lines) {
    if (frame < line.tension.size()) most = std::fmax(most, line.tension[frame]);
  }
  return most;
}

void add_moment(std::vector<Moment>& all, std::size_t frame, const std::string& words) {
  const auto same = std::find_if(all.begin(), all.end(), [&](const Moment& m) { return m.frame == frame; });
  if (same == all.end()) {
    if (all.size() < most_moments) all.push_back({frame, words});
  } else if (!words.empty()) {
    same->words += (same->words.empty() ? "" : "; ") + words;
  }
}

/// The frame in the middle of the longest time between two moments; none when no frame lies between.
bool fill_longest_gap(const Animation& a, std::vector<Moment>& all) {
  std::size_t best = 0;
  double longest = 0;
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    const std::size_t from = all[i].frame, to = all[i + 1].frame;
    const std::size_t middle = frame_at(a, (a.t[from] + a.t[to]) / 2);
    if (middle == from || middle == to || !(a.t[to] - a.t[from] > longest)) continue;
    longest = a.t[to] - a.t[from];
    best = middle;
  }
  if (longest > 0) add_moment(all, best, "");
  return longest > 0;
}

/// How the panels stand: as large as the page allows.
struct Panels {
  std::size_t columns = 1;
  MotionView view;
  double wide = 0;  ///< of one panel
};

Panels panels_of(const Animation& a, std::size_t count) {
  Panels best;
  for (const std::size_t columns : {2U, 3U, 4U}) {
    if (columns > count && columns != 2U) break;
    const auto rows = static_cast<double>((count + columns - 1) / columns);
    const double wide = paper_width / static_cast<double>(columns) - panel_gap;
    const MotionView view = motion_view(a, wide, strip_height / rows - caption_rows * caption_row - panel_gap);
    if (view.scale > best.view.scale || best.wide == 0) best = {.columns = columns, .view = view, .wide = wide};
  }
  return best;
}

std::string picture_at(const Animation& a, std::size_t frame, const MotionView& view, const TensionScale& tensions) {
  std::string out;
  for (const auto& line : a.lines) {
    if (line.points.empty()) continue;
    std::vector<Pixel> points;
    for (const Point& p : line.points[std::min(frame, line.points.size() - 1)]) points.push_back(view.of(p));
    const std::string d = path_data(points, false);
    if (!d.empty()) out += fmt::format("<path class=\"{}\" d=\"{}\"/>", line_classes(line, frame, tensions), d);
  }
  for (const auto& round : a.rounds) {
    if (round.at.empty()) continue;
    const Pixel p = view.of(round.at[std::min(frame, round.at.size() - 1)]);
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) continue;
    const double radius = round.radius * view.scale;
    out += fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>",
                       radius < smallest_dot ? "dot" : fmt::format("line {}", pen(round.role).name), p.x, p.y,
                       std::max(radius, smallest_dot));
  }
  return out;
}

/// Names of the first panel.
Placement names_of(const Animation& a, std::size_t frame, const MotionView& view, double aside) {
  std::vector<Wanted> wanted;
  std::vector<Obstacle> lines;
  for (const auto& line : a.lines) {
    if (line.points.empty()) continue;
    const auto& points = line.points[std::min(frame, line.points.size() - 1)];
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (is_finite(points[i - 1]) && is_finite(points[i]))
        lines.push_back({view.of(points[i - 1]), view.of(points[i]), pen(line.role).weight});
    }
  }
  for (const auto& round : a.rounds) {
    if (round.label.empty() || round.at.empty()) continue;
    const Point p = round.at[std::min(frame, round.at.size() - 1)];
    if (!is_finite(p)) continue;
    wanted.push_back({.anchor = view.of(p),
                      .other_anchors = {},
                      .runs = label_runs(shortened(clean(round.label), 24)),
                      .toward = {},
                      .may_cover = false});
  }
  const double side = panel_gap / 2 - 2;
  const Box panel{
      .left = -aside - side, .top = -panel_gap + 6, .right = view.wide + aside + side, .bottom = view.high + 4};
  return place_labels(wanted, lines, {.frame = panel, .bounds = panel, .taken = {}}, font_size);
}

/// The words below a panel: its time, the largest tension, what happens in at most two lines.
std::vector<Runs> caption_of(const Animation& a, const Moment& m, const Display& display, double wide) {
  const auto fitted = [&](const std::string& text) {
    int letters = 60;
    Runs runs = label_runs(shortened(clean(text), letters));
    while (letters > 6 && text_width(runs, font_size) > wide) runs = label_runs(shortened(clean(text), letters -= 2));
    return runs;
  };
  std::vector<Runs> lines = {fitted("t = " + quantity_shown(a.t[m.frame], si::s, display, 4))};
  const double T = largest_tension(a, m.frame);
  if (std::isfinite(T)) lines.push_back(fitted("T max " + quantity_shown(T, si::N, display, 3)));
  if (m.words.empty()) return lines;
  const std::vector<std::string> words = wrapped(clean(m.words), static_cast<int>(wide / (0.55 * font_size)));
  lines.push_back(fitted(words.front()));
  if (words.size() > 1) lines.push_back(fitted(words[1] + (words.size() > 2 ? " ..." : "")));
  return lines;
}

}  // namespace

std::vector<Moment> moments_of(const Animation& a) {
  std::vector<Moment> all;
  if (a.t.empty()) return all;
  add_moment(all, 0, "start");
  add_moment(all, a.t.size() - 1, "end");
  std::size_t peak = 0;
  for (std::size_t i = 0; i < a.t.size(); ++i) {
    if (largest_tension(a, i) > largest_tension(a, peak)) peak = i;
  }
  if (std::isfinite(largest_tension(a, peak))) add_moment(all, peak, "largest tension");
  std::size_t events = 0;
  for (const auto& [t, words] : a.events) {
    if (t > a.t.back() || t < a.t.front() || events == most_events) continue;
    add_moment(all, frame_at(a, t), words);
    ++events;
  }
  const auto sorted = [&] {
    std::sort(all.begin(), all.end(), [](const Moment& x, const Moment& y) { return x.frame < y.frame; });
  };
  sorted();
  while (all.size() > 1 && all.size() < most_moments && fill_longest_gap(a, all)) sorted();
  return all;
}

std::string strip_svg(const Animation& a, const Display& display) {
  if (a.t.size() < 2 || (a.lines.empty() && a.rounds.empty())) return "<p class=\"empty\">No motion to show.</p>";
  const std::vector<Moment> moments = moments_of(a);
  const Panels panels = panels_of(a, moments.size());
  const TensionScale tensions = tension_scale(a);
  std::string body;
  Box box{.left = 0, .top = 0, .right = paper_width, .bottom = 0};
  double top = panel_gap;
  std::vector<Listed> list;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const std::size_t column = i % panels.columns;
    if (column == 0 && i > 0) top = box.bottom + panel_gap;
    const double left = panel_gap / 2 + static_cast<double>(column) * (panels.wide + panel_gap);
    const double aside = (panels.wide - panels.view.wide) / 2;
    body += fmt::format("<g transform=\"translate({:.1f} {:.1f})\">", left + aside, top);
    body += picture_at(a, moments[i].frame, panels.view, tensions);
    body += "</g>";
    double base = top + panels.view.high + 22;
    for (const Runs& line : caption_of(a, moments[i], display, panels.wide)) {
      body += fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", left, base, to_svg(line));
      box.bottom = std::max(box.bottom, base + descent(font_size));
      base += caption_row;
    }
    if (i > 0) continue;
    Placement names = names_of(a, moments[i].frame, panels.view, aside);
    list = std::move(names.list);
    for (Placed& p : names.labels) {
      const auto move = [&](Pixel& q) { q = {.x = q.x + left + aside, .y = q.y + top}; };
      p.box = {.left = p.box.left + left + aside,
               .top = p.box.top + top,
               .right = p.box.right + left + aside,
               .bottom = p.box.bottom + top};
      move(p.leader_from);
      move(p.leader_to);
    }
    body += to_svg(names.labels, font_size);
  }
  body += list_svg(list, {.x = panel_gap / 2, .y = box.bottom + 10}, paper_width - panel_gap, font_size, box);
  const Pixel foot{.x = panel_gap / 2, .y = box.bottom + 22};
  Box bar;
  body += length_bar(panels.view, display, foot, bar);
  body += tension_legend(tensions, display, {.x = bar.right + 30, .y = foot.y}, bar);
  box.add(bar);
  box.bottom += 6;
  return svg_element(box.height() > figure_height ? "strip tall" : "strip", a.title, box, body);
}

}  // namespace taut::report
