#include "taut/report/figure/motion_strip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/report/figure/motion_view.hpp"
#include "taut/report/figure/pen.hpp"
#include "taut/report/text/text.hpp"

namespace taut::report {
namespace {

constexpr std::size_t most_moments = 6;
constexpr double panel_gap = 24;
constexpr double panel_height = 150;
constexpr double smallest_dot = 2.2;

std::size_t frame_at(const Animation& a, double t) {
  const auto after = std::lower_bound(a.t.begin(), a.t.end(), t);
  if (after == a.t.end()) return a.t.size() - 1;
  if (after == a.t.begin()) return 0;
  return static_cast<std::size_t>(after - a.t.begin()) - (*after - t > t - *(after - 1) ? 1 : 0);
}

void add_moment(std::vector<Moment>& all, std::size_t frame, const std::string& words) {
  const auto same = std::find_if(all.begin(), all.end(), [&](const Moment& m) { return m.frame == frame; });
  if (same == all.end()) {
    if (all.size() < most_moments) all.push_back({frame, words});
  } else if (!words.empty()) {
    same->words += (same->words.empty() ? "" : "; ") + words;
  }
}

}  // namespace

std::vector<Moment> moments_of(const Animation& a) {
  std::vector<Moment> all;
  if (a.t.empty()) return all;
  add_moment(all, 0, "start");
  add_moment(all, a.t.size() - 1, "end");
  for (const auto& [t, words] : a.events) {
    if (all.size() + 1 < most_moments) add_moment(all, frame_at(a, t), words);
  }
  const auto by_time = [](const Moment& x, const Moment& y) { return x.frame < y.frame; };
  while (all.size() < most_moments) {
    std::sort(all.begin(), all.end(), by_time);
    std::size_t widest = 0;
    for (std::size_t i = 1; i + 1 < all.size(); ++i) {
      const auto gap = [&](std::size_t k) { return a.t[all[k + 1].frame] - a.t[all[k].frame]; };
      if (gap(i) > gap(widest)) widest = i;
    }
    if (all.size() < 2) break;
    const std::size_t from = all[widest].frame, to = all[widest + 1].frame;
    const std::size_t middle = frame_at(a, (a.t[from] + a.t[to]) / 2);
    if (middle == from || middle == to) break;
    add_moment(all, middle, "");
  }
  std::sort(all.begin(), all.end(), by_time);
  return all;
}

std::string strip_svg(const Animation& a, const Display&) {
  if (a.t.size() < 2 || (a.lines.empty() && a.rounds.empty())) return "<p class=\"empty\">No motion to show.</p>";
  const std::vector<Moment> moments = moments_of(a);
  const double columns = 3;
  const double panel = (paper_width - (columns + 1) * panel_gap) / columns;
  const MotionView view = motion_view(a, panel, panel_height);
  std::string body;
  double bottom = 0;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const double column = static_cast<double>(i % 3), row = static_cast<double>(i / 3);
    const Pixel at{.x = panel_gap + column * (panel + panel_gap), .y = panel_gap + row * (view.high + 60)};
    body += fmt::format("<g transform=\"translate({:.1f} {:.1f})\">", at.x, at.y);
    for (const auto& line : a.lines) {
      std::vector<Pixel> points;
      for (const Point& p : line.points[std::min(moments[i].frame, line.points.size() - 1)])
        points.push_back(view.of(p));
      body += fmt::format("<path d=\"{}\" fill=\"none\" {}/>", path_data(points, false), stroke_of(pen(line.role)));
    }
    for (const auto& round : a.rounds) {
      const Pixel p = view.of(round.at[std::min(moments[i].frame, round.at.size() - 1)]);
      if (std::isfinite(p.x) && std::isfinite(p.y)) {
        body += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"none\" {}/>", p.x, p.y,
                            std::max(round.radius * view.scale, smallest_dot), stroke_of(pen(round.role)));
      }
    }
    body += fmt::format("<text class=\"label\" y=\"{:.1f}\">t = {}</text></g>\n", view.high + 18,
                        quantity_shown(a.t[moments[i].frame], si::s, Display{}, 4));
    bottom = std::max(bottom, at.y + view.high + 26);
  }
  return fmt::format(
      "<svg class=\"strip\" role=\"img\" aria-label=\"{}\" viewBox=\"0 0 {:.0f} {:.0f}\" width=\"{:.0f}\" "
      "height=\"{:.0f}\">\n{}</svg>\n",
      escape(a.title), paper_width, bottom, paper_width, bottom, body);
}

}  // namespace taut::report
