#include "taut/report/figure/placement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "taut/report/figure/label_grid.hpp"
#include "taut/report/figure/text_width.hpp"

namespace taut::report {
namespace {

constexpr double leader_from = 30;    ///< a label farther than this from its anchor needs a line to it
constexpr double air = 1.5;           ///< between two texts
constexpr double covered_anchor = 6;  ///< price of a text right on its anchor: beside it is better, far away is not
constexpr double many_labels = 16;    ///< from here on long leaders would make a tangle
/// Prices, in pixels of distance: a label across so many lines that it is better listed by number.
constexpr double unreadable = 420;
constexpr double unreadable_of_many = 100;
constexpr double per_line = 25;
constexpr double per_covered_pixel = 2;
constexpr double number_size = 12;  ///< pixels
constexpr double same_anchor = 3;
constexpr int most_rings = 40;  ///< around an anchor, for its number
constexpr int near_rings = 8;   ///< of these the place that covers least; farther out any free one
constexpr std::size_t columns_of_list = 4;
constexpr std::size_t most_listed = 80;  ///< with the drawing they fill a page

struct Candidate {
  Box box;
  Pixel anchor;
  double price = HUGE_VAL;
};

Box box_at(Pixel center, double w, double h) {
  return {.left = center.x - w / 2, .top = center.y - h / 2, .right = center.x + w / 2, .bottom = center.y + h / 2};
}

/// The text's box so that its nearest side stands `distance` away from the anchor in direction (ux, uy).
Box box_beside(Pixel anchor, Pixel u, double distance, double w, double h) {
  const double sx = std::abs(u.x) < 0.3 ? 0 : std::copysign(1, u.x);
  const double sy = std::abs(u.y) < 0.3 ? 0 : std::copysign(1, u.y);
  return box_at({.x = anchor.x + u.x * distance + sx * w / 2, .y = anchor.y + u.y * distance + sy * h / 2}, w, h);
}

Pixel nearest(const Box& b, Pixel p) {
  return {.x = std::clamp(p.x, b.left, b.right), .y = std::clamp(p.y, b.top, b.bottom)};
}

double apart(Pixel a, Pixel b) { return std::hypot(a.x - b.x, a.y - b.y); }

double out_of(const Box& frame, const Box& box) {
  if (frame.empty()) return 0;
  return std::max(
      {0.0, frame.left - box.left, box.right - frame.right, frame.top - box.top, box.bottom - frame.bottom});
}

bool is_inside(const Box& bounds, const Box& box) { return bounds.empty() || out_of(bounds, box) == 0; }

/// Sixteen directions; the four along the axes are the usual ones.
constexpr int directions = 16;
Pixel direction(int k) {
  const double angle = 2 * std::numbers::pi * k / directions;
  return {.x = std::cos(angle), .y = std::sin(angle)};
}

/// Everything that a label's place depends on.
struct LabelTable {
  LabelGrid grid;
  const LabelRoom& room;
  double font_size;

  /// HUGE_VAL: not allowed. Stops counting above `enough`.
  double price(int id, const Box& box, Pixel anchor, double enough) const {
    if (!is_inside(room.bounds, box) || !grid.is_free(box.grown(air), id)) return HUGE_VAL;
    double price = 0.6 * out_of(room.frame, box);
    const Pixel edge = nearest(box, anchor);
    if (apart(edge, anchor) > leader_from) price += 15 + 60 * grid.boxes_on(edge, anchor, id);
    if (price > enough) return price;
    return price + grid.cost_of_lines(box.grown(2), per_line, per_covered_pixel, enough - price);
  }

  /// None dearer than `limit`.
  Candidate best_place(int id, const Wanted& w, double limit) const {
    const double wide = text_width(w.runs, font_size);
    const double high = ascent(font_size) + descent(font_size);
    constexpr std::array<double, 7> distances{6, 12, 20, 32, 48, 70, 100};
    const double wanted = std::hypot(w.toward.x, w.toward.y);
    Candidate best{.box = {}, .anchor = {}, .price = limit};
    const auto consider = [&](const Box& box, Pixel anchor, double extra) {
      if (extra >= best.price) return;
      const double all = extra + price(id, box, anchor, best.price - extra);
      if (all < best.price) best = {.box = box, .anchor = anchor, .price = all};
    };
    const auto around = [&](Pixel anchor, double extra) {
      for (const double d : distances) {
        if (extra + 0.9 * d >= best.price) return;
        for (int k = 0; k < directions; ++k) {
          const Pixel u = direction(k);
          const double turned = wanted > 0 ? 1 - (u.x * w.toward.x + u.y * w.toward.y) / wanted : 0;
          consider(box_beside(anchor, u, d, wide, high), anchor, extra + 0.9 * d + 9 * turned + (k % 4 == 0 ? 0 : 0.5));
        }
      }
    };
    if (w.may_cover) consider(box_at(w.anchor, wide, high), w.anchor, covered_anchor);
    around(w.anchor, 0);
    for (const Pixel a : w.other_anchors) around(a, 5);
    return best;
  }

  /// A free place for a number: in rings around its anchor, the nearest free one that covers least.
  Candidate place_of_number(const std::string& number, Pixel anchor) const {
    const double wide = text_width(number, number_size) + 7;
    const double high = ascent(number_size) + descent(number_size);
    for (int ring = 0; ring < most_rings; ++ring) {
      const bool near = ring < near_rings;
      Candidate best{.box = {}, .anchor = {}, .price = near ? unreadable_of_many : HUGE_VAL};
      for (int k = 0; k < directions; ++k) {
        const Box box = box_beside(anchor, direction(k), 7 + 9 * ring, wide, high);
        const bool allowed = is_inside(room.bounds, box) && grid.is_free(box.grown(air), -1);
        const double all = near ? price(-1, box, anchor, best.price) : allowed ? k : HUGE_VAL;
        if (all < best.price) best = {.box = box, .anchor = anchor, .price = all};
      }
      if (!best.box.empty()) return best;
    }
    return {};
  }
};

Placed placed_at(const Runs& runs, const Candidate& c, double leader_length) {
  const Pixel edge = nearest(c.box, c.anchor);
  return {.runs = runs,
          .box = c.box,
          .has_leader = apart(edge, c.anchor) > leader_length,
          .leader_from = edge,
          .leader_to = c.anchor};
}

/// Labels without a place: those of one anchor together, from left to right.
std::vector<std::vector<std::size_t>> groups_of(const std::vector<Wanted>& wanted, std::vector<std::size_t> homeless) {
  const auto key = [&](std::size_t i) {
    const Pixel p = wanted[i].anchor;
    return std::pair(std::round(p.x / same_anchor), std::round(p.y / same_anchor));
  };
  std::stable_sort(homeless.begin(), homeless.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  std::vector<std::vector<std::size_t>> groups;
  for (const std::size_t i : homeless) {
    if (groups.empty() || key(groups.back().front()) != key(i)) groups.emplace_back();
    groups.back().push_back(i);
  }
  return groups;
}

Box area_of(const std::vector<Wanted>& wanted, const std::vector<Obstacle>& obstacles, const LabelRoom& room) {
  Box area = room.frame;
  for (const Wanted& w : wanted) area.add(w.anchor);
  for (const Obstacle& o : obstacles) {
    area.add(o.a);
    area.add(o.b);
  }
  return area.grown(60);
}

/// Lines of at most `wide` pixels, broken at spaces; a longer word stays whole.
std::vector<Runs> broken(const Runs& runs, double wide, double font_size) {
  std::vector<Runs> lines(1);
  double used = 0;
  for (const Run& run : runs) {
    for (std::size_t i = 0; i < run.text.size();) {
      const std::size_t end = std::min(run.text.find(' ', i), run.text.size() - 1) + 1;
      const Run word{.text = run.text.substr(i, end - i), .style = run.style};
      const double length = text_width(Runs{word}, font_size);
      const bool may_break = i > 0 || (!lines.back().empty() && lines.back().back().text.ends_with(' '));
      if (used + length > wide && used > 0 && may_break) {
        lines.emplace_back();
        used = 0;
      }
      if (!lines.back().empty() && lines.back().back().style == word.style) {
        lines.back().back().text += word.text;
      } else {
        lines.back().push_back(word);
      }
      used += length;
      i = end;
    }
  }
  return lines;
}

}  // namespace

void Box::add(Pixel p) {
  left = std::min(left, p.x);
  right = std::max(right, p.x);
  top = std::min(top, p.y);
  bottom = std::max(bottom, p.y);
}

void Box::add(const Box& other) {
  if (other.empty()) return;
  add(Pixel{.x = other.left, .y = other.top});
  add(Pixel{.x = other.right, .y = other.bottom});
}

double overlap_area(const Box& a, const Box& b) {
  const double w = std::min(a.right, b.right) - std::max(a.left, b.left);
  const double h = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
  return w > 0 && h > 0 ? w * h : 0;
}

double length_inside(const Box& box, Pixel a, Pixel b) {
  double from = 0;
  double to = 1;
  const auto clip = [&](double start, double delta, double low, double high) {
    if (delta == 0) return start >= low && start <= high;
    double t0 = (low - start) / delta;
    double t1 = (high - start) / delta;
    if (t0 > t1) std::swap(t0, t1);
    from = std::max(from, t0);
    to = std::min(to, t1);
    return from < to;
  };
  const bool inside =
      clip(a.x, b.x - a.x, box.left, box.right) && clip(a.y, b.y - a.y, box.top, box.bottom) && from < to;
  return inside ? (to - from) * std::hypot(b.x - a.x, b.y - a.y) : 0;
}

Placement place_labels(const std::vector<Wanted>& wanted, const std::vector<Obstacle>& obstacles, const LabelRoom& room,
                       double font_size) {
  LabelTable table{
      .grid = LabelGrid(obstacles, area_of(wanted, obstacles, room)), .room = room, .font_size = font_size};
  const auto first_other = static_cast<int>(wanted.size());
  for (std::size_t i = 0; i < room.taken.size(); ++i) table.grid.put(first_other + static_cast<int>(i), room.taken[i]);
  int next_id = first_other + static_cast<int>(room.taken.size());

  const double limit = static_cast<double>(wanted.size()) > many_labels ? unreadable_of_many : unreadable;
  std::vector<Candidate> places(wanted.size());
  for (int round = 0; round < 2; ++round) {  // a second look knows the later ones too
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const auto id = static_cast<int>(i);
      if (!places[i].box.empty()) table.grid.remove(id, places[i].box);
      places[i] = table.best_place(id, wanted[i], limit);
      if (!places[i].box.empty()) table.grid.put(id, places[i].box);
    }
  }

  Placement result;
  std::vector<std::size_t> homeless;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (places[i].box.empty()) {
      homeless.push_back(i);
    } else {
      result.labels.push_back(placed_at(wanted[i].runs, places[i], leader_from));
    }
  }
  if (homeless.size() > most_listed) {
    result.left_out = homeless.size() - most_listed;
    homeless.resize(most_listed);
  }
  int number = 0;
  for (const auto& group : groups_of(wanted, homeless)) {
    const Pixel anchor = wanted[group.front()].anchor;
    const Candidate place = table.place_of_number(fmt::format("{}", number + 1), anchor);
    Listed line;
    if (!place.box.empty()) {
      line.number = ++number;
      table.grid.put(next_id++, place.box);
      Placed dot = placed_at({{.text = fmt::format("{}", number), .style = Run::Style::plain}}, place, 9);
      dot.is_number = true;
      result.labels.push_back(std::move(dot));
    }
    for (const std::size_t i : group) {
      if (!line.runs.empty()) line.runs.push_back({.text = "; ", .style = Run::Style::plain});
      line.runs.insert(line.runs.end(), wanted[i].runs.begin(), wanted[i].runs.end());
    }
    result.list.push_back(std::move(line));
  }
  if (result.left_out > 0) {
    result.list.push_back(
        {.number = 0,
         .runs = {{.text = fmt::format("and {} more: see the tables", result.left_out), .style = Run::Style::plain}}});
  }
  return result;
}

std::string to_svg(const std::vector<Placed>& labels, double font_size) {
  std::string out;
  for (const Placed& p : labels) {
    if (!p.has_leader) continue;
    out += fmt::format("<path class=\"leader\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>", p.leader_from.x, p.leader_from.y,
                       p.leader_to.x, p.leader_to.y);
  }
  for (const Placed& p : labels) {
    const double size = p.is_number ? number_size : font_size;
    const double x = (p.box.left + p.box.right) / 2, base = p.box.bottom - descent(size);
    if (p.is_number) {
      out += fmt::format("<rect class=\"pill\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" rx=\"7\"/>",
                         p.box.left, p.box.top + 0.5, p.box.width(), p.box.height() - 1);
    }
    out += fmt::format("<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n",
                       p.is_number ? "number" : "label", x, p.is_number ? base - 0.5 : base, to_svg(p.runs));
  }
  return out;
}

std::string list_svg(const std::vector<Listed>& list, Pixel left_top, double wide, double font_size, Box& box) {
  if (list.empty()) return {};
  constexpr double number_column = 30;
  constexpr double gap = 16;
  const double row = ascent(font_size) + descent(font_size);
  std::vector<Listed> lines;
  double widest = 0;
  for (const Listed& l : list) {
    int number = l.number;
    for (Runs& part : broken(l.runs, wide - number_column, font_size)) {
      if (l.number > 0) widest = std::max(widest, text_width(part, font_size));
      lines.push_back({.number = std::exchange(number, 0), .runs = std::move(part)});
    }
  }
  const double column = std::min(widest + number_column + gap, wide);
  const bool whole = lines.size() == list.size();  // a line that goes on below must not go on in the next column
  const auto columns =
      whole ? std::clamp<std::size_t>(static_cast<std::size_t>((wide + gap) / column), 1, columns_of_list) : 1;
  const std::size_t rows = (lines.size() + columns - 1) / columns;
  std::string out;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::size_t of_column = i / rows, of_row = i % rows;
    const Pixel at{.x = left_top.x + static_cast<double>(of_column) * column,
                   .y = left_top.y + static_cast<double>(of_row) * row};
    const double base = at.y + ascent(font_size);
    if (lines[i].number > 0) {
      out += fmt::format("<text class=\"number\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>",
                         at.x + number_column - 8, base, lines[i].number);
    }
    out += fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", at.x + number_column, base,
                       to_svg(lines[i].runs));
    box.add(Box{.left = at.x,
                .top = at.y,
                .right = at.x + number_column + text_width(lines[i].runs, font_size),
                .bottom = at.y + row});
  }
  return out;
}

}  // namespace taut::report
