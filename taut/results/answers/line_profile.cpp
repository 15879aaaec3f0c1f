#include "taut/results/answers/line_profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "taut/calc/none.hpp"
#include "taut/study/load_path.hpp"

namespace taut::results {
namespace {

constexpr int points_on_span = 24;
constexpr double apart = 0.03;   ///< supports nearer than this share of the length need one name
constexpr double margin = 0.04;  ///< of ground beyond the ropes, as a share of the length

Point seen_along(const study::Way& way, const Vector3& v) { return {.x = v.dot(way.along), .y = v.z()}; }

void add_branch(const solve::BranchResult& branch, const study::Way& way, std::vector<Point>& points) {
  if (!points.empty()) points.push_back({none, none});
  if (branch.slack || branch.shape.rope.weight <= 0 || !(branch.shape.rope.length > 0)) {
    points.push_back(seen_along(way, branch.start));
    points.push_back(seen_along(way, branch.end));
    return;
  }
  for (int i = 0; i <= points_on_span; ++i) {
    const double share = static_cast<double>(i) / points_on_span;  // 1 at the end, without rounding
    const double s = branch.shape.rope.length * share;
    points.push_back(seen_along(way, branch.start + rope::point_at(branch.shape, s)));
  }
}

void add_ropes(const DrawnLine& line, Profile& p) {
  const int ridden = line.model.carriages[line.way.carriage].reeving;
  for (std::size_t i = 0; i < line.model.reevings.size(); ++i) {
    Profile::Rope rope{.name = line.model.reevings[i].name,
                       .role = static_cast<int>(i) == ridden ? Role::rope : Role::second_rope,
                       .points = {}};
    for (const solve::BranchResult& branch : line.state.branches) {
      if (branch.reeving == static_cast<int>(i)) add_branch(branch, line.way, rope.points);
    }
    if (!rope.points.empty()) p.ropes.push_back(std::move(rope));
  }
}

/// Smallest and largest x of the ropes, m.
std::pair<double, double> extent(const Profile& p) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Profile::Rope& rope : p.ropes) {
    for (const Point& point : rope.points) {
      if (std::isnan(point.x)) continue;
      low = std::min(low, point.x);
      high = std::max(high, point.x);
    }
  }
  return {low, high};
}

/// The ground below the ropes, where it lies along the way.
void add_ground(const DrawnLine& line, Profile& p) {
  const machine::Model& m = line.model;
  if (m.terrain.empty() || std::abs(line.way.along.dot(m.terrain_along)) < 1 - 1e-9) return;
  const auto [low, high] = extent(p);
  const double beyond = margin * (high - low);
  const auto at = [&](double chainage, double z) {
    return Point{.x = (m.terrain_from + chainage * m.terrain_along).dot(line.way.along), .y = z};
  };
  for (const auto& surveyed : m.terrain) {
    const Point here = at(surveyed.x, surveyed.z);
    if (here.x >= low - beyond && here.x <= high + beyond) p.ground.push_back(here);
  }
  // the ends of the picture lie between two points of the survey
  for (const double end : {low - beyond, high + beyond}) {
    const double chainage = (end - m.terrain_from.dot(line.way.along)) / m.terrain_along.dot(line.way.along);
    const double z = study::ground_height(m.terrain, chainage);
    if (!std::isnan(z)) p.ground.push_back({end, z});
  }
  std::sort(p.ground.begin(), p.ground.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
}

/// What holds the ropes, those of the carriage's rope first; what stands beside one that is named needs no name.
void add_supports(const DrawnLine& line, Profile& p) {
  const machine::Model& m = line.model;
  const machine::Carriage& carriage = m.carriages[line.way.carriage];
  const auto [low, high] = extent(p);
  std::vector<int> order(m.reevings.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_partition(order.begin(), order.end(), [&](int i) { return i == carriage.reeving; });
  for (const int i : order) {
    for (const machine::Node& node : m.reevings[i].nodes) {
      const bool is_carriage =
          std::any_of(m.carriages.begin(), m.carriages.end(), [&](const auto& c) { return node.at.body == c.body; });
      if (is_carriage || node.kind == machine::NodeKind::load) continue;
      const Vector3 place = machine::in_ground(line.state.state, node.at);
      const Point top = seen_along(line.way, place);
      const double same = apart * (high - low);
      const bool known = std::any_of(p.supports.begin(), p.supports.end(), [&](const Profile::Support& s) {
        return s.name == node.name || std::hypot(s.top.x - top.x, s.top.y - top.y) < same;
      });
      if (known) continue;
      const double ground = p.ground.empty() ? none : study::ground_height(m.terrain, machine::terrain_x(m, place));
      p.supports.push_back({.name = node.name, .top = top, .ground = ground});
    }
  }
  std::sort(p.supports.begin(), p.supports.end(), [](const auto& a, const auto& b) { return a.top.x < b.top.x; });
}

/// What the rope that bears most of all bears in a state.
struct Borne {
  double value = none;
  std::string rope;
};

Borne borne(const machine::Model& m, const solve::EquilibriumResult& e, bool as_share) {
  Borne most;
  for (std::size_t i = 0; i < m.reevings.size(); ++i) {
    const double strength = m.reevings[i].breaking_force;
    if (as_share && !(strength > 0)) continue;
    const double value = as_share ? e.ropes[i].T_max / strength : e.ropes[i].T_max;
    if (std::isnan(most.value) || value > most.value) most = {.value = value, .rope = m.reevings[i].name};
  }
  return most;
}

/// A load path's place with the model it was solved with.
struct PathPlace {
  const machine::Model* model = nullptr;
  const study::LoadPathPoint* point = nullptr;
};

}  // namespace

Profile line_profile(const DrawnLine& line) {
  Profile p;
  const machine::Carriage& carriage = line.model.carriages[line.way.carriage];
  p.carriage = carriage.name;
  p.carriage_at = seen_along(line.way, line.state.state.bodies[carriage.body].position);
  p.clearance = none;
  p.limit = none;
  add_ropes(line, p);
  add_ground(line, p);
  add_supports(line, p);
  return p;
}

double lowest(const solve::EquilibriumResult& answer, int body) {
  double z = answer.state.bodies[body].position.z();
  for (const solve::EquilibriumResult& bound : answer.bounds) {
    if (bound.outcome.ok()) z = std::min(z, bound.state.bodies[body].position.z());
  }
  return z;
}

void sort_places(Profile& profile) {
  if (profile.places.empty()) return;
  const double x = profile.places[profile.decisive].x;
  std::stable_sort(profile.places.begin(), profile.places.end(),
                   [](const auto& a, const auto& b) { return a.x < b.x; });
  const auto at = std::find_if(profile.places.begin(), profile.places.end(), [&](const auto& p) { return p.x == x; });
  profile.decisive = static_cast<std::size_t>(at - profile.places.begin());
}

Profile load_path_profile(const MachineRun& run, const study::LoadPathRun& path) {
  const auto& reevings = run.model.reevings;
  const bool as_share =
      std::any_of(reevings.begin(), reevings.end(), [](const auto& one) { return one.breaking_force > 0; });
  std::vector<PathPlace> places;
  for (const study::LoadPathPart& part : path.parts) {
    for (const study::LoadPathPoint& point : part.result.points) places.push_back({&part.model, &point});
  }
  const PathPlace* worst = nullptr;
  double most = none;
  std::vector<Profile::Place> shown;
  std::size_t decisive = 0;
  for (const PathPlace& one : places) {
    const bool ok = one.point->at.outcome.ok();
    const Borne own = ok ? borne(*one.model, one.point->at, as_share) : Borne{};
    if (ok && (worst == nullptr || own.value > most)) {
      worst = &one;
      most = own.value;
      decisive = shown.size();
    }
    shown.push_back({.x = one.point->x,
                     .z = ok ? lowest(one.point->at, one.model->carriages[path.way.carriage].body) : none,
                     .ground = ok ? one.point->z - one.point->clearance : none,
                     .value = own.value,
                     .governs = own.rope});
  }
  if (worst == nullptr) return {};
  Profile p = line_profile({.model = *worst->model, .state = worst->point->at, .way = path.way});
  p.name = "load_path_profile" + path.ending;
  p.title = fmt::format("The line and what its ropes bear (motion: {})", path.words);
  p.caption =
      fmt::format("Drawn where the {} is largest, carriage at x = {}.",
                  as_share ? "tension over breaking force" : "tension", run.display.brief(worst->point->x, si::m));
  p.value = as_share ? Axis{.label = "tension over breaking force", .unit = si::one}
                     : Axis{.label = "largest tension", .unit = si::N};
  p.places = std::move(shown);
  p.decisive = decisive;
  sort_places(p);
  return p;
}

}  // namespace taut::results
