#pragma once
#include <optional>

#include "taut/machine/model.hpp"

namespace taut::machine {

/// Where a carriage is to be. What holds it follows from that: of a clamped carriage the place of its clamp, of one
/// that is fixed to a running rope the place of that grip; else its mainline's length or given tension (its haulback's
/// length where the mainline's tension is given and the haulback's is not); else a force along its track, which the
/// result gives as `hold`.
struct Prescribed {
  int carriage = 0;                  ///< index in the model
  double x = 0;                      ///< of its body's origin, along `along`, m
  Vector3 along = Vector3::UnitX();  ///< horizontal unit vector
  std::optional<double> z =
      std::nullopt;  ///< its height, m: the length or tension given of the rope it rides on follows
};

}  // namespace taut::machine
