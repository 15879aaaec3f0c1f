#include "taut/study/payload.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/base/array.hpp"
#include "taut/base/expects.hpp"
#include "taut/math/index.hpp"
#include "taut/math/roots.hpp"

namespace taut::study {
namespace {

constexpr double first_part = 1.0 / 64;  ///< of the most that is looked for: tried first where nothing is expected
constexpr double more = 1.3;             ///< than expected: likely too much

/// The payload that is looked for: what holds, what does not, and the limit that stops it.
class PayloadSearch {
 public:
  PayloadSearch(const machine::Model& model, int body, const PayloadLimits& limits,
                const solve::EquilibriumOptions& options, const std::optional<machine::State>& start)
      : model_(model), loaded_(model), body_(body), limits_(limits), options_(options), near_(start) {}

  /// The margin of the nearest limit with this payload, and what it is.
  double margin(double mass) {
    loaded_.bodies[body_].mass = model_.bodies[body_].mass + mass;
    solve::EquilibriumResult r = solve::equilibrium(loaded_, options_, near_);
    LimitState nearest;
    for (const LimitState& one : limits_at(loaded_, body_, limits_, r)) {
      if (one.margin < nearest.margin) nearest = one;
    }
    if (mass == 0 && r.outcome.ok()) unloaded = r.state;
    if (nearest.margin >= 0 && mass >= holds) {
      // From states that hold only: under too much a rope of given tension runs out, and what is found from there may
      // hang far below the line even without payload.
      near_ = r.state;
      holds = mass;
      held = nearest;
      result = std::move(r);
    } else if (nearest.margin < 0 && mass <= stops) {
      stops = mass;
      stopped = nearest;
      if (mass == 0) result = std::move(r);
    }
    return nearest.margin;
  }

  double holds = -1;
  double stops = std::numeric_limits<double>::infinity();
  LimitState held, stopped;
  solve::EquilibriumResult result;
  std::optional<machine::State> unloaded;

 private:
  const machine::Model& model_;
  machine::Model loaded_;
  int body_;
  const PayloadLimits& limits_;
  const solve::EquilibriumOptions& options_;
  std::optional<machine::State> near_;
};

/// A limit that stops the payload, at the payload that still holds.
LimitState governing_of(const PayloadSearch& search, const Array<LimitState>& held) {
  const LimitState& stopped = search.stopped;
  const auto same = std::find_if(held.begin(), held.end(), [&](const LimitState& one) {
    return one.kind == stopped.kind && one.reeving == stopped.reeving && one.node == stopped.node;
  });
  return stopped.fails || same == held.end() ? stopped : *same;
}

}  // namespace

Payload payload(const machine::Model& model, int body, const PayloadLimits& limits,
                const solve::EquilibriumOptions& options, const std::optional<machine::State>& start, double expected) {
  expects(limits.tension.empty() || limits.tension.size() == model.reevings.size(), "a limit for every rope");
  expects(limits.most > 0 && std::isfinite(limits.most), "a largest payload to look for");
  expects(body >= 0 && as_size(body) < model.bodies.size(), "a body of the model");
  Payload answer;
  PayloadSearch search(model, body, limits, options, start);
  const double margin = search.margin(0);
  answer.unloaded = search.unloaded;
  if (margin < 0) {
    answer.limit = search.stopped;
    answer.at = std::move(search.result);
    answer.governing = limit_words(model, body, search.stopped);
    answer.reeving = search.stopped.kind == LimitKind::tension ? search.stopped.reeving : -1;
    answer.outcome = search.stopped.fails
                         ? answer.at.outcome
                         : infeasible(fmt::format("without any payload it is too much already: {}; raise the line, "
                                                  "give it more rope or a stronger one",
                                                  answer.governing));
    return answer;
  }
  // upwards until something stops it
  double tried = std::min(limits.most, expected > 0 ? more * expected : first_part * limits.most);
  while (search.margin(tried) >= 0 && tried < limits.most) tried = std::min(limits.most, 2 * tried);
  if (std::isinf(search.stops)) {
    answer.mass = limits.most;
    answer.governing = fmt::format("no limit below {:.6g} kg", limits.most);
    answer.limit = search.held;
    answer.at = std::move(search.result);
    return answer;
  }
  static_cast<void>(find_root([&](double mass) { return search.margin(mass); }, search.holds, search.stops));
  answer.mass = search.holds;
  answer.at = std::move(search.result);
  answer.limit = governing_of(search, limits_at(model, body, limits, answer.at));
  answer.governing = limit_words(model, body, search.stopped);
  answer.reeving = search.stopped.kind == LimitKind::tension ? search.stopped.reeving : -1;
  return answer;
}

Array<PayloadPoint> payload_path(const machine::Model& model, const PayloadLimits& limits,
                                 const LoadPathOptions& options) {
  expects(options.steps >= 1, "a load path has a step");
  const machine::Carriage& carriage = model.carriages.at(as_size(options.carriage));
  Array<PayloadPoint> points;
  std::optional<machine::State> start;
  double expected = 0;
  for (int i = 0; i <= options.steps; ++i) {
    PayloadPoint point;
    point.x = options.from + (options.to - options.from) * i / options.steps;
    if (options.go_on && !options.go_on(point.x)) break;
    solve::EquilibriumOptions here = options.equilibrium;
    here.prescribed = machine::Prescribed{options.carriage, point.x, options.along};
    point.payload = payload(model, carriage.body, limits, here, start, expected);
    if (point.payload.at.outcome.ok()) {
      start = point.payload.unloaded;
      expected = point.payload.mass;
      const Vector3& place = point.payload.at.state.bodies[carriage.body].position;
      point.z = place.z();
      point.clearance = point.z - ground_height(model.terrain, terrain_x(model, place));
    }
    points.push_back(std::move(point));
  }
  return points;
}

}  // namespace taut::study
