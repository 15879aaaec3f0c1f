#include "taut/report/figure/placement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace taut::report {
namespace {

constexpr double label_overlap_price = 40;  ///< per square pixel: two texts on each other are never right
constexpr double leader_from = 30;          ///< a label farther than this from its anchor needs a line to it

struct Candidate {
  Box box;
  Pixel anchor;
  double price = 0;
};

Box box_at(Pixel center, double w, double h) {
  return {.left = center.x - w / 2, .top = center.y - h / 2, .right = center.x + w / 2, .bottom = center.y + h / 2};
}

/// The text's box so that its nearest side stands `distance` away from the anchor in direction (ux, uy).
Box box_beside(Pixel anchor, double ux, double uy, double distance, double w, double h) {
  const double sx = std::abs(ux) < 0.3 ? 0 : std::copysign(1, ux);
  const double sy = std::abs(uy) < 0.3 ? 0 : std::copysign(1, uy);
  return box_at({.x = anchor.x + ux * distance + sx * w / 2, .y = anchor.y + uy * distance + sy * h / 2}, w, h);
}

Pixel nearest(const Box& b, Pixel p) {
  return {.x = std::clamp(p.x, b.left, b.right), .y = std::clamp(p.y, b.top, b.bottom)};
}

double price_of(const Box& box, Pixel anchor, const std::vector<Obstacle>& obstacles, const std::vector<Box>& others,
                const Box& frame) {
  const Box air = box.grown(2);
  double price = 0;
  for (const Box& o : others) price += label_overlap_price * overlap_area(air, o);
  for (const Obstacle& o : obstacles) {
    const double inside = length_inside(air, o.a, o.b);
    if (inside > 0) price += o.weight * (25 + 2 * inside);
  }
  const Pixel edge = nearest(box, anchor);
  const double far = std::hypot(edge.x - anchor.x, edge.y - anchor.y);
  if (far > leader_from) {  // the leader line should not run through other words
    price += 15;
    for (const Box& o : others) price += length_inside(o, edge, anchor) > 0 ? 60 : 0;
  }
  if (!frame.empty()) {
    const double out =
        std::max({0.0, frame.left - box.left, box.right - frame.right, frame.top - box.top, box.bottom - frame.bottom});
    price += 0.6 * out;
  }
  return price;
}

Candidate best_place(const Wanted& w, const std::vector<Obstacle>& obstacles, const std::vector<Box>& others,
                     const Box& frame, double font_size) {
  const double wide = width(w.runs) * font_size;
  const double high = 1.25 * font_size;
  constexpr std::array<double, 7> distances{6, 12, 20, 32, 48, 70, 100};
  constexpr int directions = 16;
  const double wanted = std::hypot(w.toward.x, w.toward.y);
  Candidate best;
  bool first = true;
  const auto consider = [&](const Box& box, Pixel anchor, double extra) {
    if (!first && extra >= best.price) return;
    const double price = extra + price_of(box, anchor, obstacles, others, frame);
    if (first || price < best.price) best = {.box = box, .anchor = anchor, .price = price};
    first = false;
  };
  const auto around = [&](Pixel anchor, double extra) {
    for (const double d : distances) {
      for (int k = 0; k < directions; ++k) {
        const double angle = 2 * std::numbers::pi * k / directions;
        const Pixel u{.x = std::cos(angle), .y = std::sin(angle)};
        const double turned = wanted > 0 ? 1 - (u.x * w.toward.x + u.y * w.toward.y) / wanted : 0;
        const double slanted = k % 4 == 0 ? 0 : 0.5;
        consider(box_beside(anchor, u.x, u.y, d, wide, high), anchor, extra + 0.9 * d + 9 * turned + slanted);
      }
    }
  };
  if (w.may_cover) consider(box_at(w.anchor, wide, high), w.anchor, 0);
  around(w.anchor, 0);
  for (const Pixel a : w.other_anchors) around(a, 5);
  return best;
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

std::vector<Placed> place_labels(const std::vector<Wanted>& wanted, const std::vector<Obstacle>& obstacles,
                                 const Box& frame, double font_size) {
  std::vector<Box> boxes;
  std::vector<Pixel> anchors;
  for (const Wanted& w : wanted) {
    const Candidate best = best_place(w, obstacles, boxes, frame, font_size);
    boxes.push_back(best.box);
    anchors.push_back(best.anchor);
  }
  for (int round = 0; round < 2; ++round) {  // a second look knows the later ones too
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      std::vector<Box> others = boxes;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
      const Candidate best = best_place(wanted[i], obstacles, others, frame, font_size);
      boxes[i] = best.box;
      anchors[i] = best.anchor;
    }
  }
  std::vector<Placed> all;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const Pixel edge = nearest(boxes[i], anchors[i]);
    const double far = std::hypot(edge.x - anchors[i].x, edge.y - anchors[i].y);
    all.push_back({wanted[i].runs, boxes[i], far > leader_from, edge, anchors[i]});
  }
  return all;
}

std::string to_svg(const std::vector<Placed>& labels, double font_size) {
  std::string out;
  for (const Placed& p : labels) {
    if (!p.has_leader) continue;
    out += fmt::format("<path class=\"leader\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>", p.leader_from.x, p.leader_from.y,
                       p.leader_to.x, p.leader_to.y);
  }
  for (const Placed& p : labels) {
    out +=
        fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n",
                    (p.box.left + p.box.right) / 2, (p.box.top + p.box.bottom) / 2 + 0.33 * font_size, to_svg(p.runs));
  }
  return out;
}

}  // namespace taut::report
