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

/// A piece of rope over the terrain, by the distance h from its start in plan.
class Curve {
 public:
  Curve(const machine::Model& model, RopePiece piece) : ground_(model.terrain), piece_(std::move(piece)) {
    chord_ = piece_.end - piece_.start;
    length_ = std::hypot(chord_.x(), chord_.y());
    const Vector3 way(chord_.x(), chord_.y(), 0);
    const Vector3 along = piece_.shape ? piece_.shape->along : length_ > 0 ? Vector3(way / length_) : Vector3::UnitX();
    under_ = {.from = terrain_x(model, piece_.start), .rate = model.terrain_along.dot(along)};
    along_ = along;
    if (hangs()) reach_ = rope::end_position(piece_.shape->rope, piece_.shape->force).x;
  }

  const Vector3& start() const { return piece_.start; }
  const Vector3& end() const { return piece_.end; }
  const Vector3& along() const { return along_; }
  const Under& under() const { return under_; }
  double length() const { return length_; }  ///< in plan, m
  double x_at(double h) const { return under_.from + under_.rate * h; }

  Vector3 rope_at(double h) const {
    if (length_ == 0) return piece_.start;
    return piece_.start + h / length_ * chord_ - sag_at(h) * up();
  }

  /// The rope over the ground at x below it, m; over an end of the terrain but for rounding. NaN: there is none.
  double height_of(double x, const Vector3& place) const {
    const double inside = std::clamp(x, ground_.front().x, ground_.back().x);
    const double rounding = near * std::max(1.0, length_);
    return place.z() - ground_height(ground_, std::abs(inside - x) <= rounding ? inside : x);
  }

  double slope_at(double h) const {
    if (!hangs()) return (chord_.z() - 4 * piece_.sag * (1 - 2 * h / length_)) / length_;
    const rope::CatenaryRope& rope = piece_.shape->rope;
    const rope::CatenaryForce& force = piece_.shape->force;
    const rope::RopePoint p = rope::point_at(rope, force, rope::length_to(rope, force, std::min(h, reach_)));
    return p.V / p.H;
  }

  /// The distance h at which the rope has a slope; none where it has it nowhere.
  std::optional<double> at_slope(double slope) const {
    if (hangs()) {
      const rope::CatenaryRope& rope = piece_.shape->rope;
      const double s = rope.length / 2 + (slope * piece_.shape->force.H - piece_.shape->force.V) / rope.weight;
      if (!(s > 0 && s < rope.length)) return std::nullopt;
      return rope::point_at(*piece_.shape, s).dot(piece_.shape->along);
    }
    if (!(piece_.sag > 0)) return std::nullopt;
    const double share = (1 - (chord_.z() - slope * length_) / (4 * piece_.sag)) / 2;
    return share > 0 && share < 1 ? std::optional(share * length_) : std::nullopt;
  }

  /// The lowest place of a rope that hangs upright in a loop.
  std::optional<Vector3> loop() const {
    if (!piece_.shape || hangs() || !(piece_.shape->rope.weight > 0)) return std::nullopt;
    const double s = rope::lowest_point(piece_.shape->rope, piece_.shape->force);
    if (!(s > 0 && s < piece_.shape->rope.length)) return std::nullopt;
    return piece_.start + rope::point_at(*piece_.shape, s);
  }

 private:
  bool hangs() const {
    return piece_.shape && !piece_.shape->slack && piece_.shape->rope.weight > 0 && piece_.shape->force.H > 0;
  }
  double sag_at(double h) const {
    // an end that rounding has set beyond the rope is at its end
    if (hangs()) return rope::sag_at(piece_.shape->rope, piece_.shape->force, std::clamp(h, 0.0, reach_));
    const double share = h / length_;
    return 4 * piece_.sag * share * (1 - share);
  }

  const Array<machine::GroundPoint>& ground_;
  RopePiece piece_;
  Vector3 chord_ = Vector3::Zero(), along_ = Vector3::UnitX();
  Under under_;        ///< the terrain's x
  double length_ = 0;  ///< in plan, m
  double reach_ = 0;   ///< the same of a catenary, as its force has it, m
};

RopePiece piece_of(const solve::BranchResult& branch) {
  return {.start = branch.start, .end = branch.end, .shape = branch.shape, .sag = 0};
}

/// The nodes of a rope's ends.
struct RopeEnds {
  int reeving = 0, from = 0, to = 0;
};

RopeEnds ends_of(const solve::BranchResult& branch) {
  return {.reeving = branch.reeving, .from = branch.from, .to = branch.to};
}

class ClearanceSearch {
 public:
  ClearanceSearch(const machine::Model& model, const RopePiece& piece, const RopeEnds& ends)
      : model_(model),
        ends_(ends),
        ground_(model.terrain),
        rope_(model, piece),
        under_(rope_.under()),
        length_(rope_.length()) {}

  /// Of the free rope.
  RopeClearance least() {
    take_end(ends_.from, 0, rope_.start());
    take_end(ends_.to, length_, rope_.end());
    take_loop();
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
    const Under across{.from = window.along.dot(rope_.start()), .rate = window.along.dot(rope_.along())};
    const Part part =
        Part{.first = 0, .last = length_}.within(across, low, high).within(under_, ground_.front().x, ground_.back().x);
    if (part.empty()) return found_;
    take_at(part.first);
    take_at(part.last);
    if (length_ == 0) take(under_.from, rope_.end());
    take_loop();
    between(part);
    return found_;
  }

 private:
  double x_at(double h) const { return rope_.x_at(h); }

  /// Compares a place of the rope with the ground at x below it.
  void take(double x, const Vector3& place) {
    const double height = rope_.height_of(x, place);
    if (std::isnan(height) || height >= found_.height) return;
    found_ = {.height = height, .place = place, .to_end = {}};
  }

  /// An end of the branch, at the distance h: one that may not be on the ground; else one that is fixed deeper than an
  /// anchor is buried, or whose rope stays in the ground.
  void take_end(int node, double h, const Vector3& place) {
    const RopeClearance above = found_;
    take(x_at(h), place);
    if (!may_be_on_ground(model_, ends_.reeving, node)) return;
    if (found_.height >= -buried_anchor) found_ = above;
    if (!(length_ > buried_rope)) return;
    const RopeClearance end = found_;
    take_at(h == 0 ? buried_rope : length_ - buried_rope);
    if (found_.height >= 0) found_ = end;
  }

  void take_loop() {
    if (const auto lowest = rope_.loop()) take(under_.from, *lowest);
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
    if (!fixed(to_start ? ends_.from : ends_.to)) return;
    const bool buried = (h < buried_rope && fixed(ends_.from)) || (length_ - h < buried_rope && fixed(ends_.to));
    if (found_.height >= (buried ? -buried_anchor : 0)) found_ = above;
  }

  /// The rope at the distance h.
  void take_at(double h) {
    if (length_ == 0) return take(under_.from, rope_.start());
    take(x_at(h), rope_.rope_at(h));
  }

  void between(const Part& part) {
    for (std::size_t k = 0; k + 1 < ground_.size(); ++k) parallel(ground_[k], ground_[k + 1], part);
    for (std::size_t k = 1; k + 1 < ground_.size(); ++k) hilltop(k, part);
  }

  /// Where the rope is parallel to a piece of ground: at slope m, V = m H.
  void parallel(const machine::GroundPoint& a, const machine::GroundPoint& b, const Part& part) {
    const auto h = rope_.at_slope(under_.rate * (b.z - a.z) / (b.x - a.x));
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
    const double slope = rope_.slope_at(h);
    if (behind <= slope && slope <= before) take_at(h);
  }

  /// A place of the rope: its distance from the start in plan and its height over the ground, m.
  struct Place {
    double at = 0, height = 0;
  };

  bool fixed(int node) const { return may_be_on_ground(model_, ends_.reeving, node); }

  /// What is below the line down to a fixed end, farther from it than a rope may be buried.
  void along_ground() {
    const bool start = fixed(ends_.from), end = fixed(ends_.to);
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
      const auto ground = [&](const Place& place) { return rope_.rope_at(place.at).z() - place.height; };
      const double rise = (ground(last) - ground(first)) / (last.at - first.at);
      const auto lowest = rope_.at_slope(rise + (to_start ? 1 : -1) * buried_anchor / buried_rope);
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
    return rope_.rope_at(h).z() - ground_height(ground_, x);
  }

  const machine::Model& model_;
  RopeEnds ends_;
  const Array<machine::GroundPoint>& ground_;
  Curve rope_;
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

/// The same of a rope in pieces. Between two neighbours of its places the height over the ground only rises or falls.
class ChainSearch {
 public:
  ChainSearch(const machine::Model& model, const Array<RopePiece>& pieces, const RopeEnds& ends)
      : model_(model),
        pieces_(pieces),
        front_(pieces.front().start),
        back_(pieces.back().end),
        fixed_start_(may_be_on_ground(model, ends.reeving, ends.from)),
        fixed_end_(may_be_on_ground(model, ends.reeving, ends.to)) {}

  RopeClearance least() {
    for (const RopePiece& piece : pieces_) {
      curves_.emplace_back(model_, piece);
      add_piece(curves_.size() - 1);
    }
    along_ground();
    const std::size_t last = places_.size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {
      const Place& place = places_[i];
      const bool end = i == 0 || i == last;
      const bool counts = end && !(i == 0 ? fixed_start_ : fixed_end_);
      // NaN: the terrain has ended
      const auto falls_from = [&](double next, bool counts_there) {
        return std::isnan(next) ? counts_there : next >= place.height;
      };
      const bool lowest =
          !end && falls_from(places_[i - 1].height, !fixed_start_) && falls_from(places_[i + 1].height, !fixed_end_);
      const bool buried = (fixed_start_ && apart_in_plan(front_, place.at) < buried_rope) ||
                          (fixed_end_ && apart_in_plan(back_, place.at) < buried_rope);
      if (counts || lowest || place.height < (buried ? -buried_anchor : 0)) take(place.height, place.at, {});
    }
    return least_;
  }

 private:
  struct Place {
    std::size_t piece = 0;
    double h = 0;  ///< from the start of its piece, m
    Vector3 at = Vector3::Zero();
    double height = 0;
  };

  void take(double height, const Vector3& place, std::optional<double> to_end) {
    least_ = lower(least_, {.height = height, .place = place, .to_end = to_end});
  }

  void add(std::size_t piece, double h, const Vector3& at) {
    const double height = curves_[piece].height_of(terrain_x(model_, at), at);
    places_.push_back({.piece = piece, .h = h, .at = at, .height = height});
  }

  /// The ends of a piece, and where between them its height over the ground or over the line down to a fixed end may
  /// turn, and where a rope may no longer be buried.
  void add_piece(std::size_t piece) {
    const Curve& rope = curves_[piece];
    Array<double> inside;
    const auto keep = [&](double h) {
      if (h > 0 && h < rope.length()) inside.push_back(h);
    };
    const Under& under = rope.under();
    const auto& ground = model_.terrain;
    for (std::size_t k = 0; k < ground.size() && under.rate != 0; ++k) keep((ground[k].x - under.from) / under.rate);
    for (std::size_t k = 0; k + 1 < ground.size(); ++k) {
      const double rise = under.rate * (ground[k + 1].z - ground[k].z) / (ground[k + 1].x - ground[k].x);
      for (const double line : {-1.0, 0.0, 1.0}) {
        const auto h = rope.at_slope(rise + line * buried_anchor / buried_rope);
        if (h && rope.x_at(*h) >= ground[k].x && rope.x_at(*h) <= ground[k + 1].x) keep(*h);
      }
    }
    keep_near_ends(rope, keep);
    std::sort(inside.begin(), inside.end());
    if (piece == 0) add(piece, 0, rope.start());
    for (const double h : inside) add(piece, h, rope.rope_at(h));
    if (const auto lowest = rope.loop()) add(piece, 0, *lowest);
    add(piece, rope.length(), rope.end());
  }

  /// Where it is as far from an end of the rope as that may be buried, and as far from one as from the other.
  template <class Keep>
  void keep_near_ends(const Curve& rope, const Keep& keep) const {
    for (const Vector3& end : {front_, back_}) {
      const double nearest = (end - rope.start()).dot(rope.along());
      const double off = apart_in_plan(end, rope.start() + nearest * rope.along());
      if (off >= buried_rope) continue;
      const double half = std::sqrt(buried_rope * buried_rope - off * off);
      keep(nearest - half);
      keep(nearest + half);
    }
    const Vector3 between = back_ - front_ - (back_ - front_).dot(up()) * up();
    const double rate = between.dot(rope.along());
    if (rate != 0) keep(between.dot((front_ + back_) / 2 - rope.start()) / rate);
  }

  double to_end(const Vector3& place) const {
    const double far = std::numeric_limits<double>::infinity();
    return std::min(fixed_start_ ? apart_in_plan(front_, place) : far, fixed_end_ ? apart_in_plan(back_, place) : far);
  }

  /// What is below the line down to a fixed end, farther from it than a rope may be buried.
  void along_ground() {
    if (!fixed_start_ && !fixed_end_) return;
    const auto over = [&](const Vector3& at, double height) { return height - line_down(to_end(at)); };
    const auto take_it = [&](double height, const Vector3& at) {
      // at that distance but for rounding
      if (to_end(at) >= (1 - near) * buried_rope) take(height, at, to_end(at));
    };
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const Place& place = places_[i];
      const double own = over(place.at, place.height);
      if (own < 0) take_it(place.height, place.at);
      const double before = i == 0 ? own : over(places_[i - 1].at, places_[i - 1].height);
      if (!(own * before < 0)) continue;
      const Curve& rope = curves_[place.piece];
      const double from = places_[i - 1].piece == place.piece ? places_[i - 1].h : 0;
      const auto height_at = [&](double h) { return rope.height_of(rope.x_at(h), rope.rope_at(h)); };
      const auto root = find_root([&](double h) { return over(rope.rope_at(h), height_at(h)); }, from, place.h);
      if (root) take_it(height_at(*root), rope.rope_at(*root));
    }
  }

  const machine::Model& model_;
  const Array<RopePiece>& pieces_;
  Vector3 front_, back_;
  bool fixed_start_, fixed_end_;
  std::vector<Curve> curves_;
  std::vector<Place> places_;
  RopeClearance least_;
};

}  // namespace

bool may_be_on_ground(const machine::Model& model, int reeving, int node) {
  const machine::Node& at = model.reevings[reeving].nodes[node];
  if (at.at.body != machine::ground && !model.bodies[at.at.body].free.empty()) return false;
  return !machine::is_saddle(at);
}

RopeClearance rope_clearance(const machine::Model& model, const solve::BranchResult& branch) {
  if (model.terrain.empty() || branch.slack) return {};
  return lower({}, ClearanceSearch(model, piece_of(branch), ends_of(branch)).least());
}

RopeClearance rope_clearance(const machine::Model& model, const Array<RopePiece>& pieces, int reeving, int from,
                             int to) {
  if (model.terrain.empty() || pieces.empty()) return {};
  const RopeEnds ends{.reeving = reeving, .from = from, .to = to};
  if (pieces.size() == 1) return lower({}, ClearanceSearch(model, pieces.front(), ends).least());
  return ChainSearch(model, pieces, ends).least();
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
    if (branch.reeving == reeving)
      least = lower(least, ClearanceSearch(model, piece_of(branch), ends_of(branch)).least(window));
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
