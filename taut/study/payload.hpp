#pragma once
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/study/limits.hpp"
#include "taut/study/load_path.hpp"

namespace taut::study {

/// The largest payload at one place.
struct Payload {
  Outcome outcome;              ///< infeasible: some limit is broken without any payload, or there is no equilibrium
  double mass = 0;              ///< kg, on top of the body's own
  std::string governing;        ///< in words: which limit ends it
  int reeving = -1;             ///< whose tension governs; -1: something else does
  LimitState limit;             ///< the one that governs, with that payload
  solve::EquilibriumResult at;  ///< with that payload; where a limit is broken without payload, without it
  std::optional<machine::State> unloaded;  ///< without payload, where that has an equilibrium
};

/// The largest mass that may be added to a body at its origin within the limits: tensions grow and clearance falls with
/// it, so the first limit reached governs. A payload without equilibrium counts as too much. `expected`: a payload
/// nearby, kg; it saves time only. `start`: near the state without payload.
Payload payload(const machine::Model& model, int body, const PayloadLimits& limits,
                const solve::EquilibriumOptions& options = {},
                const std::optional<machine::State>& start = std::nullopt, double expected = 0);

/// The payload at each position of a load path (limits on the carriage's body).
struct PayloadPoint {
  double x = 0, z = 0;   ///< of the carriage with that payload, m
  double clearance = 0;  ///< m; NaN without terrain there
  Payload payload;
};
Array<PayloadPoint> payload_path(const machine::Model& model, const PayloadLimits& limits,
                                 const LoadPathOptions& options);

}  // namespace taut::study
