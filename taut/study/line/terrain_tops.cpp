#include "taut/study/line/terrain_tops.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "taut/study/load_path.hpp"

namespace taut::study {
namespace {

constexpr double rounding = 1e-9;  ///< of a height

/// Whether a point of the ground is an end of it, or stands above the line between its neighbours, but for rounding.
bool is_top(const Array<machine::GroundPoint>& ground, std::size_t k) {
  if (k == 0 || k + 1 == ground.size()) return true;
  const machine::GroundPoint &a = ground[k - 1], &b = ground[k], &c = ground[k + 1];
  const double between = a.z + (c.z - a.z) * (b.x - a.x) / (c.x - a.x);
  return b.z - between > rounding * std::max({1.0, std::abs(a.z), std::abs(b.z), std::abs(c.z)});
}

/// The clearance of a known place where it has one.
double known(const WayPlace& place) {
  return std::isnan(place.clearance) ? std::numeric_limits<double>::infinity() : place.clearance;
}

}  // namespace

WayPlace way_place(const machine::Model& model, int carriage, double x, const solve::EquilibriumResult& state) {
  const double missing = std::numeric_limits<double>::quiet_NaN();
  if (!state.outcome.ok()) return {.x = x, .chainage = missing, .z = missing, .clearance = missing};
  const Vector3& place = state.state.bodies[model.carriages[carriage].body].position;
  const double chainage = terrain_x(model, place);
  return {
      .x = x, .chainage = chainage, .z = place.z(), .clearance = place.z() - ground_height(model.terrain, chainage)};
}

TopsBetween::TopsBetween(const machine::Model& model, const WayPlace& from, const WayPlace& to, double bend)
    : places_{from, to}, bend_(bend) {
  const Array<machine::GroundPoint>& ground = model.terrain;
  const auto [low, high] = std::minmax(from.chainage, to.chainage);
  const double way = to.chainage - from.chainage;
  auto at =
      std::upper_bound(ground.begin(), ground.end(), low, [](double x, const auto& point) { return x < point.x; });
  for (; at != ground.end() && at->x < high; ++at) {
    if (!is_top(ground, static_cast<std::size_t>(at - ground.begin()))) continue;
    const double share = (at->x - from.chainage) / way;
    const double x = from.x + share * (to.x - from.x);
    if (x > std::min(from.x, to.x) && x < std::max(from.x, to.x)) tops_.push_back({.x = x, .z = at->z});
  }
}

double TopsBetween::height_at(double x) const {
  const auto right = std::find_if(places_.begin() + 1, places_.end() - 1, [&](const WayPlace& place) {
    return (place.x - x) * (places_.back().x - places_.front().x) >= 0;
  });
  const WayPlace &a = *(right - 1), &b = *right;
  const double chord = a.z + (b.z - a.z) * (x - a.x) / (b.x - a.x);
  return chord - bend_ / 2 * std::abs((x - a.x) * (b.x - x));
}

std::optional<double> TopsBetween::next() {
  if (tops_.empty()) return std::nullopt;
  double least = std::numeric_limits<double>::infinity();
  for (const WayPlace& place : places_) least = std::min(least, known(place));
  const auto over = [&](const machine::GroundPoint& top) { return height_at(top.x) - top.z; };
  const auto lowest = std::min_element(tops_.begin(), tops_.end(),
                                       [&](const auto& one, const auto& other) { return over(one) < over(other); });
  if (!(over(*lowest) < least - rounding * std::max(1.0, std::abs(lowest->z)))) return std::nullopt;
  const double x = lowest->x;
  tops_.erase(lowest);
  return x;
}

void TopsBetween::take(const WayPlace& place) {
  const auto behind = std::find_if(places_.begin() + 1, places_.end() - 1, [&](const WayPlace& one) {
    return (one.x - place.x) * (places_.back().x - places_.front().x) > 0;
  });
  places_.insert(behind, place);
}

double bend_of_step(const Array<WayPlace>& way, std::size_t i) {
  double bend = 0;
  for (std::size_t k = std::max<std::size_t>(i, 1); k <= i + 1 && k + 1 < way.size(); ++k) {
    const double step = way[k].x - way[k - 1].x;
    const double grows = way[k + 1].z - 2 * way[k].z + way[k - 1].z;
    if (step != 0 && std::isfinite(grows)) bend = std::max(bend, grows / (step * step));
  }
  return bend;
}

}  // namespace taut::study
