#pragma once
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/study/limits.hpp"
#include "taut/study/load_path.hpp"

namespace taut::study {

/// The largest payload at one position.
struct Payload {
  Outcome outcome;              ///< infeasible: a limit is exceeded even without payload, or there is no equilibrium
  double mass = 0;              ///< kg, in addition to the mass of the body
  std::string governing;        ///< the limit that governs, in words
  int reeving = -1;             ///< the rope whose tension governs; -1: another limit governs
  LimitState limit;             ///< the governing limit, with that payload
  solve::EquilibriumResult at;  ///< with that payload; without payload where a limit is exceeded even so
  std::optional<machine::State> unloaded;  ///< without payload; empty where there is no equilibrium
};

/// The largest mass that may be added at the origin of a body within the limits. With the mass the tensions grow and
/// the clearances fall, so the first limit reached governs. A mass without equilibrium counts as too large. `expected`:
/// a payload nearby, kg, which only saves time. `start`: a state near the one without payload. Throws ContractViolation
/// when `limits.tension` is neither empty nor of the size of the reevings, or `limits.most` is not positive and finite.
Payload payload(const machine::Model& model, int body, const PayloadLimits& limits,
                const solve::EquilibriumOptions& options = {},
                const std::optional<machine::State>& start = std::nullopt, double expected = 0);

/// The payload at each position of a load path; clearance is that of the body of the carriage.
struct PayloadPoint {
  double x = 0, z = 0;   ///< of the carriage with that payload, m
  double clearance = 0;  ///< m; NaN without terrain there
  Payload payload;
};
Array<PayloadPoint> payload_path(const machine::Model& model, const PayloadLimits& limits,
                                 const LoadPathOptions& options);

}  // namespace taut::study
