#include "taut/study/load_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "taut/base/array.hpp"
#include "taut/base/expects.hpp"
#include "taut/base/number.hpp"
#include "taut/machine/compile/carriage_span.hpp"
#include "taut/machine/compile/guides.hpp"
#include "taut/study/line/terrain_tops.hpp"

namespace taut::study {

double ground_height(const Array<machine::GroundPoint>& terrain, double x) {
  const auto right =
      std::lower_bound(terrain.begin(), terrain.end(), x, [](const auto& point, double at) { return point.x < at; });
  if (right == terrain.end()) return std::numeric_limits<double>::quiet_NaN();
  if (right->x == x) return right->z;
  if (right == terrain.begin()) return std::numeric_limits<double>::quiet_NaN();
  const auto left = right - 1;
  return left->z + (right->z - left->z) * (x - left->x) / (right->x - left->x);
}

namespace {

/// The last three of equal steps; without a third one `first` is `before`.
struct LastStates {
  const machine::State &last, &before, &first;
  bool curved = false;  ///< three of them

  /// The next value on the parabola, or the line, through the last ones.
  double next(double a, double b, double c) const { return curved ? 3 * a - 3 * b + c : 2 * a - b; }
  Vector3 next(const Vector3& a, const Vector3& b, const Vector3& c) const {
    return curved ? Vector3(3 * (a - b) + c) : Vector3(2 * a - b);
  }
};

/// None where its length would shrink to a quarter and below.
std::optional<machine::BranchState> next_branch(const LastStates& s, std::size_t rope, std::size_t branch) {
  const machine::BranchState &a = s.last.branches[rope][branch], &b = s.before.branches[rope][branch],
                             &c = s.first.branches[rope][branch];
  machine::BranchState next = a;
  next.length = s.next(a.length, b.length, c.length);
  if (next.length < a.length / 4) return std::nullopt;
  if (!a.force || !b.force || !c.force) return next;
  next.force = rope::CatenaryForce{.H = s.next(a.force->H, b.force->H, c.force->H),
                                   .V = s.next(a.force->V, b.force->V, c.force->V)};
  if (next.force->H <= 0) next.force = a.force;
  return next;
}

/// A start for the next of equal steps: the parabola through the last three states, or what there is of it. Branch
/// lengths stay positive; what touches and how bodies are turned stays as it was last.
std::optional<machine::State> ahead(const Array<LoadPathPoint>& points) {
  const std::size_t n = points.size();
  if (n == 0 || !points[n - 1].at.outcome.ok()) return std::nullopt;
  const machine::State& last = points[n - 1].at.state;
  if (n < 2 || !points[n - 2].at.outcome.ok()) return last;
  const bool curved = n >= 3 && points[n - 3].at.outcome.ok();
  const LastStates s{.last = last,
                     .before = points[n - 2].at.state,
                     .first = points[curved ? n - 3 : n - 2].at.state,
                     .curved = curved};
  if (s.last.touched != s.before.touched || s.last.touched != s.first.touched) return last;
  machine::State next = last;
  for (std::size_t b = 0; b < next.bodies.size(); ++b) {
    next.bodies[b].position =
        s.next(s.last.bodies[b].position, s.before.bodies[b].position, s.first.bodies[b].position);
  }
  for (std::size_t r = 0; r < next.branches.size(); ++r) {
    for (std::size_t k = 0; k < next.branches[r].size(); ++k) {
      const auto branch = next_branch(s, r, k);
      if (!branch) return last;
      next.branches[r][k] = *branch;
    }
  }
  return next;
}

/// The answer at one place, under the condition where there is one; without it `model` of the answer is empty.
solve::Conditioned answer_at(const machine::Model& model, const LoadPathOptions& options,
                             const solve::EquilibriumOptions& here, const std::optional<machine::State>& start) {
  if (options.condition) return solve::equilibrium_under(model, *options.condition, here, start);
  return {.model = {}, .result = solve::equilibrium(model, here, start)};
}

}  // namespace

namespace {

/// Whether all ropes meet the same nodes in the same order: a state of one model is one of the other.
bool same_paths(const machine::Model& a, const machine::Model& b) {
  const auto same_node = [](const machine::Node& m, const machine::Node& n) { return m.name == n.name; };
  const auto same_rope = [&](const machine::Reeving& r, const machine::Reeving& s) {
    return std::equal(r.nodes.begin(), r.nodes.end(), s.nodes.begin(), s.nodes.end(), same_node);
  };
  return std::equal(a.reevings.begin(), a.reevings.end(), b.reevings.begin(), b.reevings.end(), same_rope);
}

}  // namespace

machine::Model standing_at(const machine::Model& model, const LoadPathOptions& options, double x) {
  machine::Model there = machine::with_carriage_at(model, options.carriage, x, options.along);
  const bool same_span = there.carriages[options.carriage].node == model.carriages[options.carriage].node &&
                         machine::same_guides(there, model) && same_paths(there, model);
  return same_span ? there : model;
}

const machine::Carriage& carriage_on_path(const machine::Model& model, const LoadPathOptions& options) {
  expects(options.steps >= 1, "a load path has a step");
  expects(options.carriage >= 0 && static_cast<std::size_t>(options.carriage) < model.carriages.size(),
          "a carriage of the model moves");
  expects(std::isfinite(options.from) && std::isfinite(options.to), "a load path begins and ends somewhere");
  return model.carriages[options.carriage];
}

double Way::x(int i) const { return step_between(from, to, i, steps); }

namespace {

/// Of a place without equilibrium.
Outcome no_answer(const machine::Carriage& carriage, const LoadPathPoint& point) {
  return {
      .status = point.at.outcome.status,
      .message = fmt::format("'{}' at x = {} m: {}", carriage.name, place_number(point.x), point.at.outcome.message)};
}

/// The points of a load path with those between them over the tops of the ground.
class OverTops {
 public:
  /// `model`: with what a condition has varied.
  OverTops(const machine::Model& model, const LoadPathOptions& options)
      : model_(model), options_(options), carriage_(model.carriages[options.carriage]) {}

  void add_to(LoadPath& path) {
    Array<WayPlace> way;
    way.reserve(path.points.size());
    for (const LoadPathPoint& point : path.points) way.push_back(place_of(point));
    Array<LoadPathPoint> all;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      std::optional<LoadPathPoint> between;
      const bool step = i + 1 < path.points.size() && path.points[i].at.outcome.ok();
      if (step && path.points[i + 1].at.outcome.ok()) between = least_between(path, way, i);
      all.push_back(std::move(path.points[i]));
      if (!between) continue;
      if (!between->at.outcome.ok() && path.outcome.ok()) path.outcome = no_answer(carriage_, *between);
      all.push_back(*std::move(between));
    }
    path.points = std::move(all);
  }

 private:
  WayPlace place_of(const LoadPathPoint& point) const {
    return way_place(model_, options_.carriage, point.x, point.at);
  }

  /// The place of a step that is nearest to the ground, or one without an answer; none where that is an end of the
  /// step.
  std::optional<LoadPathPoint> least_between(const LoadPath& path, const Array<WayPlace>& way, std::size_t i) {
    TopsBetween tops(model_, way[i], way[i + 1], bend_of_step(way, i));
    std::optional<LoadPathPoint> least;
    while (const auto x = tops.next()) {
      const bool nearer = std::abs(*x - way[i].x) <= std::abs(*x - way[i + 1].x);
      LoadPathPoint point = load_path_at(model_, options_, *x, path.points[nearer ? i : i + 1].at.state);
      if (!point.at.outcome.ok()) return point;
      tops.take(place_of(point));
      if (std::isnan(point.clearance)) continue;
      if (!least || point.clearance < least->clearance) least = std::move(point);
    }
    const auto above = [&](const WayPlace& end) { return !(end.clearance <= least->clearance); };
    return least && above(way[i]) && above(way[i + 1]) ? least : std::nullopt;
  }

  const machine::Model& model_;
  const LoadPathOptions& options_;
  const machine::Carriage& carriage_;
};

}  // namespace

LoadPathPoint load_path_at(const machine::Model& model, const LoadPathOptions& options, double x,
                           const std::optional<machine::State>& start) {
  const machine::Carriage& carriage = carriage_on_path(model, options);
  LoadPathPoint point;
  point.x = x;
  solve::EquilibriumOptions here = options.equilibrium;
  here.prescribed = machine::Prescribed{.carriage = options.carriage, .x = x, .along = options.along};
  if (start) point.at = answer_at(model, options, here, start).result;
  if (!start || !point.at.outcome.ok())
    point.at = answer_at(standing_at(model, options, x), options, here, std::nullopt).result;
  if (!point.at.outcome.ok()) return point;
  const Vector3& place = point.at.state.bodies[carriage.body].position;
  point.z = place.z();
  point.clearance = point.z - ground_height(model.terrain, terrain_x(model, place));
  return point;
}

LoadPath load_path(const machine::Model& model, const LoadPathOptions& options) {
  const machine::Carriage& carriage = carriage_on_path(model, options);
  LoadPath path;
  machine::Model varied = options.condition ? model : machine::Model{};
  path.points.reserve(static_cast<std::size_t>(options.steps) + 1);
  for (int i = 0; i <= options.steps; ++i) {
    LoadPathPoint point;
    point.x = step_between(options.from, options.to, i, options.steps);
    if (options.go_on && !options.go_on(point.x)) break;
    solve::EquilibriumOptions here = options.equilibrium;
    here.prescribed = machine::Prescribed{.carriage = options.carriage, .x = point.x, .along = options.along};
    const std::optional<machine::State> start = ahead(path.points);
    // without a state before it a place does not begin from the first one
    const bool alone = !start && i > 0;
    const machine::Model& last = options.condition ? varied : model;
    solve::Conditioned found = answer_at(alone ? standing_at(last, options, point.x) : last, options, here, start);
    if (!found.result.outcome.ok() && start) {
      // a step too wide for its start: the place may have an answer by itself
      solve::Conditioned by_itself = answer_at(standing_at(last, options, point.x), options, here, std::nullopt);
      if (by_itself.result.outcome.ok()) found = std::move(by_itself);
    }
    point.at = std::move(found.result);
    if (options.condition && point.at.outcome.ok()) varied = std::move(found.model);
    if (point.at.outcome.ok()) {
      const Vector3& place = point.at.state.bodies[carriage.body].position;
      point.z = place.z();
      point.clearance = point.z - ground_height(model.terrain, terrain_x(model, place));
    } else if (path.outcome.ok()) {
      path.outcome = no_answer(carriage, point);
    }
    path.points.push_back(std::move(point));
  }
  OverTops(options.condition ? varied : model, options).add_to(path);
  return path;
}

}  // namespace taut::study
