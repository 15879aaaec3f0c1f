#include "taut/solve/rest/roll.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "taut/base/array.hpp"
#include "taut/math/index.hpp"

namespace taut::solve {
namespace {

constexpr int roll_places = 16;  ///< in the span
constexpr int roll_halvings = 12;

/// The k-th place, as a part of the span: they stand closer at its ends, where a slack rope's lowest point may be
/// (Chebyshev's nodes).
double roll_place(int k) { return (1 - std::cos(std::numbers::pi * (k + 0.5) / roll_places)) / 2; }

bool rolls_free(const machine::Model& model, const machine::Carriage& car) {
  const machine::Reeving& rides = model.reevings[car.reeving];
  if (car.mainline || car.haulback || car.grip) return false;
  if (rides.nodes[car.node].kind != machine::NodeKind::contact) return false;
  for (const machine::Reeving& rope : model.reevings) {
    for (const machine::Node& node : rope.nodes) {
      // a rope fixed to it, or over a sheave on it, may hold it
      const bool own = &rope == &rides && node.kind == machine::NodeKind::contact;
      if (node.at.body == car.body && !own) return false;
    }
  }
  return true;
}

std::string runs_to(const machine::Model& model, const machine::Carriage& car, const machine::Node& first,
                    const machine::Node& last, const std::string& end) {
  return fmt::format(
      "nothing holds carriage '{}' on '{}', and nowhere between '{}' and '{}' does it stand by itself: it runs to {}; "
      "give "
      "it a mainline, clamp it, or put it at an x",
      car.name, model.reevings[car.reeving].name, first.name, last.name, end);
}

/// The neighbours of a carriage on its rope.
struct Neighbours {
  const machine::Node *first, *last;
};

Neighbours neighbours(const machine::Model& model, const machine::Carriage& car) {
  const machine::Reeving& rope = model.reevings[car.reeving];
  const std::size_t count = rope.nodes.size();
  return {.first = &rope.nodes[(as_size(car.node) + count - 1) % count],
          .last = &rope.nodes[as_size(car.node + car.rollers) % count]};
}

class Roll {
 public:
  Roll(const machine::Model& model, int carriage, EquilibriumOptions options)
      : model_(model), options_(std::move(options)), car_(model.carriages[carriage]) {
    options_.band = false;
    options_.held = true;
    options_.prescribed = machine::Prescribed{.carriage = carriage, .x = 0};
    const Neighbours beside = neighbours(model, car_);
    first_ = beside.first;
    last_ = beside.last;
    const machine::State start = machine::initial_state(model);
    from_ = machine::in_ground(start, first_->at);
    chord_ = machine::in_ground(start, last_->at) - from_;
    chord_.z() = 0;
    if (chord_.norm() > 0) options_.prescribed->along = chord_.normalized();
  }

  std::optional<Rest> rest(int carriage) {
    if (chord_.norm() == 0) return std::nullopt;
    Rest rest;
    rest.carriage = carriage;
    Array<std::pair<double, double>> holds;  // place, force
    for (int k = 0; k < roll_places; ++k) {
      const double part = roll_place(k);
      const double force = hold(part);
      if (std::isnan(force)) continue;
      if (!holds.empty() && holds.back().second < 0 && force >= 0) {
        rest.state = halved(holds.back().first, part);
        return rest;
      }
      holds.emplace_back(part, force);
    }
    if (holds.empty()) return std::nullopt;
    const bool to_first = holds.front().second > 0, to_last = holds.back().second < 0;
    if (!to_first && !to_last) return std::nullopt;
    const std::string end = to_first && to_last ? fmt::format("an end, '{}' or '{}'", first_->name, last_->name)
                                                : fmt::format("the end at '{}'", (to_first ? first_ : last_)->name);
    rest.reason = runs_to(model_, car_, *first_, *last_, end);
    return rest;
  }

 private:
  /// The force along the span that holds the carriage at a part of it, N; NaN where that has no answer.
  double hold(double part) {
    const Vector3& along = options_.prescribed->along;
    options_.prescribed->x = along.dot(from_ + part * chord_);
    EquilibriumResult r = equilibrium(model_, options_, near_);
    if (!r.outcome.ok() && near_) r = equilibrium(model_, options_);
    if (!r.outcome.ok()) return std::nan("");
    near_ = r.state;
    return r.hold.dot(along);
  }

  /// The state near where the force changes its sign.
  std::optional<machine::State> halved(double low, double high) {
    for (int i = 0; i < roll_halvings; ++i) {
      const double middle = (low + high) / 2;
      const double force = hold(middle);
      if (std::isnan(force)) break;
      (force < 0 ? low : high) = middle;
    }
    return near_;
  }

  const machine::Model& model_;
  EquilibriumOptions options_;
  const machine::Carriage& car_;
  const machine::Node *first_ = nullptr, *last_ = nullptr;
  Vector3 from_ = Vector3::Zero(), chord_ = Vector3::Zero();
  std::optional<machine::State> near_;
};

}  // namespace

std::optional<Rest> roll_to_rest(const machine::Model& model, const EquilibriumOptions& options) {
  for (std::size_t i = 0; i < model.carriages.size(); ++i) {
    if (!rolls_free(model, model.carriages[i])) continue;
    const auto index = static_cast<int>(i);
    return Roll(model, index, options).rest(index);
  }
  return std::nullopt;
}

std::string rolled_away(const machine::Model& model, const machine::State& state) {
  for (const machine::Carriage& car : model.carriages) {
    if (!rolls_free(model, car)) continue;
    const Neighbours beside = neighbours(model, car);
    const Vector3 from = machine::in_ground(state, beside.first->at);
    Vector3 way = machine::in_ground(state, beside.last->at) - from;
    way.z() = 0;
    const double passed = (state.bodies[car.body].position - from).dot(way);
    if (way.norm() == 0 || (passed >= 0 && passed <= way.squaredNorm())) continue;
    const std::string& end = (passed < 0 ? beside.first : beside.last)->name;
    return runs_to(model, car, *beside.first, *beside.last, fmt::format("the end at '{}'", end));
  }
  return {};
}

}  // namespace taut::solve
