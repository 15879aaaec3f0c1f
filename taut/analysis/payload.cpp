#include "taut/analysis/payload.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/base/expects.hpp"
#include "taut/math/roots.hpp"

namespace taut::analysis {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// The limit that is nearest, or broken worst.
struct Margin {
  double value = 1;    ///< below 0: broken; 1: no limit asked
  int reeving = -1;    ///< whose tension it is
  bool fails = false;  ///< no equilibrium
};

Margin margin_of(const model::Model& model, int body, const PayloadLimits& limits, const EquilibriumResult& r) {
  Margin margin;
  if (!r.outcome.ok()) return {-1, -1, true};
  for (std::size_t k = 0; k < limits.tension.size(); ++k) {
    const double left = 1 - r.ropes[k].T_max / limits.tension[k];
    if (left < margin.value) margin = {left, static_cast<int>(k), false};
  }
  const Vector3& place = r.state.bodies[at(body)].position;
  const double clearance = place.z() - ground_height(model.terrain, place.x());
  const double scale = std::max(1.0, std::abs(place.z()));
  if (clearance - limits.clearance < margin.value * scale) margin = {(clearance - limits.clearance) / scale, -1, false};
  return margin;
}

std::string words(const model::Model& model, int body, const Margin& margin, const PayloadLimits& limits) {
  if (margin.fails) return "no equilibrium with more";
  if (margin.reeving >= 0) return fmt::format("tension of '{}'", model.reevings[at(margin.reeving)].name);
  if (std::isfinite(limits.clearance)) return fmt::format("clearance of '{}'", model.bodies[at(body)].name);
  return fmt::format("no limit below {:.6g} kg", limits.most);
}

}  // namespace

Payload payload(const model::Model& model, int body, const PayloadLimits& limits, const EquilibriumOptions& options,
                const std::optional<model::State>& start) {
  expects(limits.tension.empty() || limits.tension.size() == model.reevings.size(), "a limit for every rope");
  expects(limits.most > 0 && std::isfinite(limits.most), "a largest payload to look for");
  Payload answer;
  model::Model loaded = model;
  const double own = model.bodies.at(at(body)).mass;
  std::optional<model::State> near = start;
  const auto solve = [&](double mass) {
    loaded.bodies[at(body)].mass = own + mass;
    EquilibriumResult r = equilibrium(loaded, options, near);
    if (r.outcome.ok()) near = r.state;
    return r;
  };
  answer.at = solve(0);
  const Margin empty = margin_of(model, body, limits, answer.at);
  if (empty.fails || empty.value < 0) {
    answer.outcome = empty.fails ? answer.at.outcome
                                 : infeasible(fmt::format("without any payload it is too much already: {}; raise the "
                                                          "line, give it more rope or a stronger one",
                                                          words(model, body, empty, limits)));
    answer.governing = words(model, body, empty, limits);
    answer.reeving = empty.reeving;
    return answer;
  }
  // the largest mass seen to hold, and the limit that stopped the next one
  double holds = 0;
  Margin stops;
  const auto left = [&](double mass) {
    const EquilibriumResult r = solve(mass);
    const Margin margin = margin_of(model, body, limits, r);
    if (margin.value >= 0 && mass >= holds) {
      holds = mass;
      answer.at = r;
    }
    if (margin.value < 0 || margin.value < stops.value) stops = margin;
    return margin.value;
  };
  if (left(limits.most) >= 0) {
    answer.mass = limits.most;
    answer.governing = words(model, body, {}, {.tension = {}, .most = limits.most});
    return answer;
  }
  static_cast<void>(find_root(left, 0, limits.most));
  answer.mass = holds;
  answer.reeving = stops.reeving;
  answer.governing = words(model, body, stops, limits);
  return answer;
}

std::vector<PayloadPoint> payload_path(const model::Model& model, const PayloadLimits& limits,
                                       const LoadPathOptions& options) {
  expects(options.steps >= 1, "a load path has a step");
  const model::Carriage& carriage = model.carriages.at(at(options.carriage));
  std::vector<PayloadPoint> points;
  std::optional<model::State> start;
  for (int i = 0; i <= options.steps; ++i) {
    PayloadPoint point;
    point.x = options.from + (options.to - options.from) * i / options.steps;
    EquilibriumOptions here = options.equilibrium;
    here.prescribed = Prescribed{options.carriage, point.x};
    point.payload = payload(model, carriage.body, limits, here, start);
    if (point.payload.at.outcome.ok()) {
      start = point.payload.at.state;
      point.z = start->bodies[at(carriage.body)].position.z();
      point.clearance = point.z - ground_height(model.terrain, point.x);
    }
    points.push_back(std::move(point));
  }
  return points;
}

}  // namespace taut::analysis
