#include "taut/study/line/rope_clearance.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/math/roots.hpp"
#include "taut/rope/catenary_shape.hpp"
#include "taut/study/load_path.hpp"

namespace taut::study {
namespace {

constexpr double near = 1e-9;        ///< of a span's length
constexpr double buried_anchor = 3;  ///< m; what is fixed deeper below the ground is a mistake
constexpr double buried_rope = 6;    ///< m in plan from a fixed end; farther on a rope is out of the ground

/// How high a rope that comes down to a fixed end is to be at the distance r from it in plan, m: what is buried 3 m
/// deep and out of the ground 6 m away goes on rising like that. Below it the rope is along the ground, not on its way
/// down.
double line_down(double r) { return (r - buried_rope) * buried_anchor / buried_rope; }

/// A coordinate under a span, seen from its start: at the horizontal distance h from there it is from + rate h.
struct Under {
  double from = 0, rate = 0;
};

/// A part of a span in plan, m from its start.
struct Part {
  double first = 0, last = 0;

  bool empty() const { return !(first <= last); }

  /// What is left of it where a coordinate lies between a and b.
  Part within(const Under& u, double a, double b) const {
    if (u.rate == 0) return u.from >= a && u.from <= b ? *this : Part{.first = 1, .last = 0};
    const double p = (a - u.from) / u.rate, q = (b - u.from) / u.rate;
    return {.first = std::max(first, std::min(p, q)), .last = std::min(last, std::max(p, q))};
  }
};

class ClearanceSearch {
 public:
  ClearanceSearch(const machine::Model& model, const solve::BranchResult& branch)
      : model_(model), branch_(branch), ground_(model.terrain) {
    under_ = {.from = terrain_x(model, branch.start), .rate = model.terrain_along.dot(branch.shape.along)};
    length_ = std::hypot(branch.shape.chord.x(), branch.shape.chord.y());
  }

  /// Of the free rope.
  RopeClearance least() {
    take_end(branch_.from, 0, branch_.start);
    take_end(branch_.to, length_, branch_.end);
    // at a fixed end, but for rounding
    between({.first = near * length_, .last = (1 - near) * length_});
    take_edge(true);
    take_edge(false);
    along_ground();
    return found_;
  }

  /// Of what is in a window, ends counted.
  RopeClearance least(const RopeWindow& window) {
    const auto [low, high] = std::minmax(window.from, window.to);
    const Under across{.from = window.along.dot(branch_.start), .rate = window.along.dot(branch_.shape.along)};
    const Part part =
        Part{.first = 0, .last = length_}.within(across, low, high).within(under_, ground_.front().x, ground_.back().x);
    if (part.empty()) return found_;
    take_at(part.first);
    take_at(part.last);
    if (length_ == 0) take(under_.from, branch_.end);
    between(part);
    return found_;
  }

 private:
  bool straight() const { return branch_.slack || branch_.shape.rope.weight <= 0 || branch_.shape.force.H <= 0; }
  double x_at(double h) const { return under_.from + under_.rate * h; }

  /// Compares a place of the rope with the ground at x below it.
  void take(double x, const Vector3& place) {
    const double inside = std::clamp(x, ground_.front().x, ground_.back().x);
    const double rounding = near * std::max(1.0, length_);
    const double height = place.z() - ground_height(ground_, std::abs(inside - x) <= rounding ? inside : x);
    if (std::isnan(height) || height >= found_.height) return;
    found_ = {.height = height, .place = place, .to_end = {}};
  }

  /// An end of the branch, at the distance h: one that may not be on the ground; else one that is fixed deeper than an
  /// anchor is buried, or whose rope stays in the ground.
  void take_end(int node, double h, const Vector3& place) {
    const RopeClearance above = found_;
    take(x_at(h), place);
    if (!may_be_on_ground(model_, branch_.reeving, node)) return;
    if (found_.height >= -buried_anchor) found_ = above;
    if (!(length_ > buried_rope)) return;
    const RopeClearance end = found_;
    take_at(h == 0 ? buried_rope : length_ - buried_rope);
    if (found_.height >= 0) found_ = end;
  }

  /// Over the first or last place of the terrain: what is known of a rope may be lowest there. Where the rope goes on
  /// to an end that may be on the ground, it may come down to the ground, as it may behind any such end.
  void take_edge(bool first) {
    if (under_.rate == 0) return;
    const double h = ((first ? ground_.front().x : ground_.back().x) - under_.from) / under_.rate;
    if (!(h > near * length_ && h < (1 - near) * length_)) return;
    const RopeClearance above = found_;
    take_at(h);
    const bool to_start = first == (under_.rate > 0);
    if (!may_be_on_ground(model_, branch_.reeving, to_start ? branch_.from : branch_.to)) return;
    const bool buried = (h < buried_rope && may_be_on_ground(model_, branch_.reeving, branch_.from)) ||
                        (length_ - h < buried_rope && may_be_on_ground(model_, branch_.reeving, branch_.to));
    if (found_.height >= (buried ? -buried_anchor : 0)) found_ = above;
  }

  /// The rope at the distance h: by its sag under the chord.
  void take_at(double h) {
    if (length_ == 0) return take(under_.from, branch_.start);
    take(x_at(h), rope_at(h));
  }

  /// Of a rope that is not upright.
  Vector3 rope_at(double h) const {
    const Vector3 below(0, 0, straight() ? 0 : -rope::sag_at(branch_.shape, h));
    return branch_.start + h / length_ * branch_.shape.chord + below;
  }

  void between(const Part& part) {
    for (std::size_t k = 0; k + 1 < ground_.size(); ++k) parallel(ground_[k], ground_[k + 1], part);
    for (std::size_t k = 1; k + 1 < ground_.size(); ++k) hilltop(k, part);
  }

  /// Where the rope is parallel to a piece of ground: at slope m, V = m H.
  void parallel(const machine::GroundPoint& a, const machine::GroundPoint& b, const Part& part) {
    const auto h = at_slope(under_.rate * (b.z - a.z) / (b.x - a.x));
    if (!h) return;
    const double x = x_at(*h);
    if (*h > part.first && *h < part.last && x >= a.x && x <= b.x) take_at(*h);
  }

  /// A corner of the ground is nearest to the rope where the rope, whose slope grows along it, rises no more than the
  /// ground before it and no less than the ground behind it.
  void hilltop(std::size_t k, const Part& part) {
    if (under_.rate == 0) return;
    const machine::GroundPoint &a = ground_[k - 1], &b = ground_[k], &c = ground_[k + 1];
    const double h = (b.x - under_.from) / under_.rate;
    if (!(h > part.first && h < part.last)) return;
    const double one = under_.rate * (b.z - a.z) / (b.x - a.x), other = under_.rate * (c.z - b.z) / (c.x - b.x);
    const double before = under_.rate > 0 ? one : other, behind = under_.rate > 0 ? other : one;
    const double slope = slope_at(h);
    if (behind <= slope && slope <= before) take_at(h);
  }

  /// A place of the rope: its distance from the start in plan and its height over the ground, m.
  struct Place {
    double at = 0, height = 0;
  };

  bool fixed(int node) const { return may_be_on_ground(model_, branch_.reeving, node); }

  /// What is below the line down to a fixed end, farther from it than a rope may be buried.
  void along_ground() {
    const bool start = fixed(branch_.from), end = fixed(branch_.to);
    if (!start && !end) return;
    const double first = start ? buried_rope : near * length_,
                 last = end ? length_ - buried_rope : (1 - near) * length_;
    const Part part = Part{.first = first, .last = last}.within(under_, ground_.front().x, ground_.back().x);
    if (part.empty()) return;
    Array<double> places = {part.first, part.last};
    const auto add = [&](double h) {
      if (h > part.first && h < part.last) places.push_back(h);
    };
    if (start && end) add(length_ / 2);
    for (std::size_t k = 1; k + 1 < ground_.size() && under_.rate != 0; ++k)
      add((ground_[k].x - under_.from) / under_.rate);
    std::sort(places.begin(), places.end());
    Array<Place> known;
    for (const double h : places) known.push_back({.at = h, .height = height_at(h)});
    for (std::size_t k = 0; k + 1 < known.size(); ++k) {
      const bool to_start = start && (!end || known[k].at < length_ / 2);
      along_piece(known[k], known[k + 1], to_start);
    }
  }

  /// The same between two places over straight ground: there the height over the line is convex, so what is below it is
  /// one piece. Within that piece the rope is lowest where it is parallel to the ground, or at an end of it.
  void along_piece(const Place& first, const Place& last, bool to_start) {
    const auto to_end = [&](double h) { return to_start ? h : length_ - h; };
    const auto line = [&](double h) { return line_down(to_end(h)); };
    const auto over = [&](double h) { return height_at(h) - line(h); };
    const auto take_it = [&](double h) {
      const double before = found_.height;
      take_at(h);
      if (found_.height < before) found_.to_end = to_end(h);
    };
    const double a = first.height - line(first.at), b = last.height - line(last.at);
    if (a < 0 && first.height < found_.height) take_it(first.at);
    if (b < 0 && last.height < found_.height) take_it(last.at);
    // where the rope meets the line it is as high as that: no lower than at one end of the piece
    if (std::min(line(first.at), line(last.at)) >= found_.height) return;
    double inside = a < b ? first.at : last.at;
    if (a >= 0 && b >= 0) {
      const auto ground = [&](const Place& place) { return rope_at(place.at).z() - place.height; };
      const double rise = (ground(last) - ground(first)) / (last.at - first.at);
      const auto lowest = at_slope(rise + (to_start ? 1 : -1) * buried_anchor / buried_rope);
      if (!lowest || !(*lowest > first.at && *lowest < last.at && over(*lowest) < 0)) return;
      inside = *lowest;
    }
    for (const auto& [end, height] : {std::pair{first.at, a}, {last.at, b}}) {
      if (height < 0 || end == inside) continue;
      if (const auto root = find_root(over, std::min(inside, end), std::max(inside, end))) take_it(*root);
    }
  }

  double height_at(double h) const {
    const double x = std::clamp(x_at(h), ground_.front().x, ground_.back().x);
    return rope_at(h).z() - ground_height(ground_, x);
  }

  /// Slope of the rope at the distance h: V/H of the tension there.
  double slope_at(double h) const {
    if (straight()) return branch_.shape.chord.z() / length_;
    const rope::CatenaryRope& rope = branch_.shape.rope;
    const rope::RopePoint p = rope::point_at(rope, branch_.shape.force, rope::length_to(rope, branch_.shape.force, h));
    return p.V / p.H;
  }

  /// The distance h at which the rope has a slope; none where it has it nowhere.
  std::optional<double> at_slope(double slope) const {
    if (straight()) return std::nullopt;
    const rope::CatenaryRope& rope = branch_.shape.rope;
    const double s = rope.length / 2 + (slope * branch_.shape.force.H - branch_.shape.force.V) / rope.weight;
    if (!(s > 0 && s < rope.length)) return std::nullopt;
    return rope::point_at(branch_.shape, s).dot(branch_.shape.along);
  }

  const machine::Model& model_;
  const solve::BranchResult& branch_;
  const Array<machine::GroundPoint>& ground_;
  Under under_;        ///< the terrain's x
  double length_ = 0;  ///< of the span in plan, m
  RopeClearance found_{.height = std::numeric_limits<double>::infinity(), .place = Vector3::Zero(), .to_end = {}};
};

/// What the terrain's x of a rope runs over.
struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  bool empty() const { return !(low <= high); }
  void take(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

/// The part of a span in a window. A rope lies over its chord in plan.
void take_extent(const machine::Model& model, const solve::BranchResult& branch, const RopeWindow& window,
                 Extent& extent) {
  const double length = std::hypot(branch.shape.chord.x(), branch.shape.chord.y());
  const auto [low, high] = std::minmax(window.from, window.to);
  const Under across{.from = window.along.dot(branch.start), .rate = window.along.dot(branch.shape.along)};
  const Part part = Part{.first = 0, .last = length}.within(across, low, high);
  if (part.empty()) return;
  const double from = terrain_x(model, branch.start), rate = model.terrain_along.dot(branch.shape.along);
  extent.take(from + rate * part.first);
  extent.take(from + rate * part.last);
}

RopeClearance lower(const RopeClearance& a, const RopeClearance& b) {
  const bool second = std::isfinite(b.height) && !(a.height <= b.height);
  return second ? b : a;
}

double apart_in_plan(const Vector3& a, const Vector3& b) { return std::hypot(b.x() - a.x(), b.y() - a.y()); }

/// The points of a rope, those over the corners of the ground, and those that end what may be buried.
Array<Vector3> places_along(const machine::Model& model, const Array<Vector3>& rope) {
  Array<Vector3> places;
  for (std::size_t i = 0; i < rope.size(); ++i) {
    if (i > 0) {
      Array<double> shares;
      const double a = terrain_x(model, rope[i - 1]), b = terrain_x(model, rope[i]);
      for (const machine::GroundPoint& top : model.terrain) {
        if (top.x > std::min(a, b) && top.x < std::max(a, b)) shares.push_back((top.x - a) / (b - a));
      }
      for (const Vector3& end : {rope.front(), rope.back()}) {
        const double r = apart_in_plan(end, rope[i - 1]), q = apart_in_plan(end, rope[i]);
        if ((r - buried_rope) * (q - buried_rope) < 0) shares.push_back((buried_rope - r) / (q - r));
      }
      std::sort(shares.begin(), shares.end());
      for (const double share : shares) places.push_back(rope[i - 1] + share * (rope[i] - rope[i - 1]));
    }
    places.push_back(rope[i]);
  }
  return places;
}

/// What of a polyline is below the line down to a fixed end, farther from it than a rope may be buried. Between two
/// places rope and ground are straight.
RopeClearance along_ground(const Array<Vector3>& rope, const Array<Vector3>& places, const Array<double>& heights,
                           bool fixed_start, bool fixed_end) {
  const double far = std::numeric_limits<double>::infinity();
  const auto to_end = [&](const Vector3& place) {
    return std::min(fixed_start ? apart_in_plan(rope.front(), place) : far,
                    fixed_end ? apart_in_plan(rope.back(), place) : far);
  };
  RopeClearance least;
  if (!fixed_start && !fixed_end) return least;
  const auto take = [&](double height, const Vector3& place) {
    if (to_end(place) < buried_rope) return;
    least = lower(least, {.height = height, .place = place, .to_end = to_end(place)});
  };
  double before = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double over = heights[i] - line_down(to_end(places[i]));
    if (over < 0) take(heights[i], places[i]);
    if (over * before < 0) {
      const double share = before / (before - over);
      take(heights[i - 1] + share * (heights[i] - heights[i - 1]), places[i - 1] + share * (places[i] - places[i - 1]));
    }
    before = over;
  }
  return least;
}

}  // namespace

bool may_be_on_ground(const machine::Model& model, int reeving, int node) {
  const machine::Node& at = model.reevings[reeving].nodes[node];
  if (at.at.body != machine::ground && !model.bodies[at.at.body].free.empty()) return false;
  return !machine::is_saddle(at);
}

RopeClearance rope_clearance(const machine::Model& model, const solve::BranchResult& branch) {
  if (model.terrain.empty() || branch.slack) return {};
  return lower({}, ClearanceSearch(model, branch).least());
}

RopeClearance rope_clearance(const machine::Model& model, const Array<Vector3>& rope, int reeving, int from, int to) {
  const bool begins = !may_be_on_ground(model, reeving, from), ends = !may_be_on_ground(model, reeving, to);
  const Array<Vector3> places = places_along(model, rope);
  Array<double> heights;
  for (const Vector3& place : places) {
    heights.push_back(place.z() - ground_height(model.terrain, terrain_x(model, place)));
  }
  RopeClearance least = along_ground(rope, places, heights, !begins, !ends);
  const std::size_t last = places.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const bool end = i == 0 || i == last;
    const bool counts = end && (i == 0 ? begins : ends);
    // NaN: the terrain has ended
    const auto falls_from = [&](double next, bool counts_there) {
      return std::isnan(next) ? counts_there : next >= heights[i];
    };
    const bool lowest = !end && falls_from(heights[i - 1], begins) && falls_from(heights[i + 1], ends);
    const bool buried = (!begins && apart_in_plan(rope.front(), places[i]) < buried_rope) ||
                        (!ends && apart_in_plan(rope.back(), places[i]) < buried_rope);
    if (counts || lowest || heights[i] < (buried ? -buried_anchor : 0))
      least = lower(least, {.height = heights[i], .place = places[i], .to_end = {}});
  }
  return least;
}

RopeClearance rope_clearance(const machine::Model& model, const solve::EquilibriumResult& result) {
  RopeClearance least;
  for (const solve::BranchResult& branch : result.branches) least = lower(least, rope_clearance(model, branch));
  return least;
}

RopeClearance rope_clearance(const machine::Model& model, const Array<solve::BranchResult>& branches, int reeving,
                             const RopeWindow& window) {
  RopeClearance least;
  if (model.terrain.empty()) return least;
  for (const solve::BranchResult& branch : branches) {
    if (branch.reeving == reeving) least = lower(least, ClearanceSearch(model, branch).least(window));
  }
  return least;
}

TerrainGap terrain_gap(const machine::Model& model, double from, double to) {
  const auto [low, high] = std::minmax(from, to);
  if (model.terrain.empty()) return {.before = high - low, .after = 0};
  const double rounding = near * std::max({1.0, high - low, std::abs(low), std::abs(high)});
  const auto part = [&](double length) { return length > rounding ? length : 0; };
  const double first = model.terrain.front().x, last = model.terrain.back().x;
  return {.before = part(std::min(high, first) - low), .after = part(high - std::max(low, last))};
}

TerrainGap terrain_gap(const machine::Model& model, const Array<solve::BranchResult>& branches, int reeving,
                       const RopeWindow& window) {
  Extent extent;
  for (const solve::BranchResult& branch : branches) {
    if (branch.reeving == reeving) take_extent(model, branch, window, extent);
  }
  return extent.empty() ? TerrainGap{} : terrain_gap(model, extent.low, extent.high);
}

TerrainGap terrain_gap(const machine::Model& model, const solve::EquilibriumResult& result) {
  Extent extent;
  for (const solve::BranchResult& branch : result.branches) take_extent(model, branch, {}, extent);
  return extent.empty() ? TerrainGap{} : terrain_gap(model, extent.low, extent.high);
}

}  // namespace taut::study
