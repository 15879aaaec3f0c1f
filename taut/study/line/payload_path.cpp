#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "taut/base/array.hpp"
#include "taut/base/number.hpp"
#include "taut/study/line/terrain_tops.hpp"
#include "taut/study/payload.hpp"

/// The payload place by place.
namespace taut::study {
namespace {

/// Where the carriage stands with the payload that was found.
void place_point(const machine::Model& model, const machine::Carriage& carriage, PayloadPoint& point) {
  if (!point.payload.at.outcome.ok()) return;
  const Vector3& place = point.payload.at.state.bodies[carriage.body].position;
  point.z = place.z();
  point.clearance = point.z - ground_height(model.terrain, terrain_x(model, place));
}

solve::EquilibriumOptions options_at(const LoadPathOptions& options, double x) {
  solve::EquilibriumOptions here = options.equilibrium;
  here.prescribed = machine::Prescribed{.carriage = options.carriage, .x = x, .along = options.along};
  return here;
}

/// The points of a path of payloads with those between them over the tops of the ground.
class PayloadsOverTops {
 public:
  PayloadsOverTops(const machine::Model& model, const PayloadLimits& limits, const LoadPathOptions& options)
      : model_(model), limits_(limits), options_(options), carriage_(model.carriages[options.carriage]) {}

  Array<PayloadPoint> with_tops(Array<PayloadPoint> points) const {
    Array<WayPlace> way;
    way.reserve(points.size());
    for (const PayloadPoint& point : points) way.push_back(place_of(point));
    Array<PayloadPoint> all;
    for (std::size_t i = 0; i < points.size(); ++i) {
      Array<PayloadPoint> between;
      const bool step = i + 1 < points.size() && answered(points[i]) && answered(points[i + 1]);
      if (step) between = tops_between(points[i], points[i + 1], bend_of_step(way, i));
      all.push_back(std::move(points[i]));
      std::move(between.begin(), between.end(), std::back_inserter(all));
    }
    return all;
  }

 private:
  static bool answered(const PayloadPoint& point) { return point.payload.at.outcome.ok(); }

  WayPlace place_of(const PayloadPoint& point) const {
    return way_place(model_, options_.carriage, point.x, point.payload.at);
  }

  /// The places of a step over its tops that carry less, or are nearer to the ground, than both its ends.
  Array<PayloadPoint> tops_between(const PayloadPoint& a, const PayloadPoint& b, double bend) const {
    TopsBetween tops(model_, place_of(a), place_of(b), bend);
    Array<PayloadPoint> found;
    double least = std::min(a.payload.mass, b.payload.mass);
    while (const auto x = tops.next()) {
      const PayloadPoint& near = std::abs(*x - a.x) <= std::abs(*x - b.x) ? a : b;
      found.push_back(payload_at(model_, limits_, options_, *x, near.payload.unloaded, near.payload.mass));
      if (!answered(found.back())) break;
      tops.take(place_of(found.back()));
      if (found.back().payload.mass < least) {
        least = found.back().payload.mass;
        lower_to(least, a, b, found, tops.places());
      }
    }
    return kept(a, b, std::move(found));
  }

  /// The known places as they are with this payload: where the ground limits it, each of them stands at the limit with
  /// its own, and the way with the least one is what the other tops are seen from.
  void lower_to(double mass, const PayloadPoint& a, const PayloadPoint& b, const Array<PayloadPoint>& found,
                Array<WayPlace>& places) const {
    const auto point_at = [&](double x) -> const PayloadPoint& {
      if (x == a.x || x == b.x) return x == a.x ? a : b;
      return *std::find_if(found.begin(), found.end(), [&](const auto& one) { return one.x == x; });
    };
    machine::Model loaded = model_;
    loaded.bodies[carriage_.body].mass += mass;
    for (WayPlace& place : places) {
      const PayloadPoint& known = point_at(place.x);
      if (known.payload.mass == mass) continue;
      const auto there = solve::equilibrium(loaded, options_at(options_, place.x), known.payload.at.state);
      if (!there.outcome.ok()) continue;
      const double rise = there.state.bodies[carriage_.body].position.z() - place.z;
      place.z += rise;
      place.clearance += rise;
    }
  }

  static Array<PayloadPoint> kept(const PayloadPoint& a, const PayloadPoint& b, Array<PayloadPoint> found) {
    const auto mass = [](const PayloadPoint& one) { return one.payload.mass; };
    const auto height = [](const PayloadPoint& one) {
      return std::isnan(one.clearance) ? std::numeric_limits<double>::infinity() : one.clearance;
    };
    std::optional<std::size_t> lightest, lowest;
    for (std::size_t k = 0; k < found.size(); ++k) {
      if (!answered(found[k])) continue;
      if (mass(found[k]) < std::min(mass(a), mass(b)) && (!lightest || mass(found[k]) < mass(found[*lightest])))
        lightest = k;
      if (height(found[k]) < std::min(height(a), height(b)) && (!lowest || height(found[k]) < height(found[*lowest])))
        lowest = k;
    }
    Array<PayloadPoint> all;
    for (std::size_t k = 0; k < found.size(); ++k) {
      if (!answered(found[k]) || k == lightest || k == lowest) all.push_back(std::move(found[k]));
    }
    std::sort(all.begin(), all.end(),
              [&](const auto& one, const auto& other) { return (one.x < other.x) == (a.x < b.x) && one.x != other.x; });
    return all;
  }

  const machine::Model& model_;
  const PayloadLimits& limits_;
  const LoadPathOptions& options_;
  const machine::Carriage& carriage_;
};

}  // namespace

PayloadPoint payload_at(const machine::Model& model, const PayloadLimits& limits, const LoadPathOptions& options,
                        double x, const std::optional<machine::State>& start, double expected) {
  const machine::Carriage& carriage = carriage_on_path(model, options);
  const solve::EquilibriumOptions here = options_at(options, x);
  PayloadPoint point;
  point.x = x;
  const auto by_itself = [&] {
    return payload(standing_at(model, options, x), carriage.body, limits, here, std::nullopt, expected);
  };
  point.payload = start ? payload(model, carriage.body, limits, here, start, expected) : by_itself();
  if (start && !point.payload.outcome.ok() && point.payload.limit.fails) {
    // a start too far from the place: it may have an answer by itself
    Payload other = by_itself();
    if (other.outcome.ok() || !other.limit.fails) point.payload = std::move(other);
  }
  place_point(model, carriage, point);
  return point;
}

Array<PayloadPoint> payload_path(const machine::Model& model, const PayloadLimits& limits,
                                 const LoadPathOptions& options) {
  const machine::Carriage& carriage = carriage_on_path(model, options);
  Array<PayloadPoint> points;
  std::optional<machine::State> start;
  double expected = 0;
  for (int i = 0; i <= options.steps; ++i) {
    const double x = step_between(options.from, options.to, i, options.steps);
    if (options.go_on && !options.go_on(x)) break;
    PayloadPoint point;
    if (!start && i == 0) {
      point.x = x;
      point.payload = payload(model, carriage.body, limits, options_at(options, x), std::nullopt, expected);
      place_point(model, carriage, point);
    } else {
      point = payload_at(model, limits, options, x, start, expected);
    }
    if (point.payload.at.outcome.ok()) {
      start = point.payload.unloaded;
      expected = point.payload.mass;
    }
    points.push_back(std::move(point));
  }
  return PayloadsOverTops(model, limits, options).with_tops(std::move(points));
}

}  // namespace taut::study
