#pragma once
#include <optional>

#include "taut/machine/model.hpp"

namespace taut::machine {

/// A prescribed position of a carriage. One other quantity follows from it, the first that applies:
/// - clamped carriage: the place of its clamp;
/// - carriage fixed to a running rope: the place of that grip;
/// - carriage with a mainline: the length or given tension of the mainline (where the tension of the mainline is given
/// and that of the haulback is not: the length of the haulback);
/// - else: a force along its track, which the result gives as `hold`.
struct Prescribed {
  int carriage = 0;                        ///< index in the model
  double x = 0;                            ///< of its body's origin, along `along`, m
  Vector3 along = Vector3::UnitX();        ///< horizontal unit vector
  std::optional<double> z = std::nullopt;  ///< height, m: the given quantity of the rope on which it rides then follows
};

/// `x` as the deck counts it, m.
inline double told_x(const Model& model, const Prescribed& prescribed) {
  return prescribed.x + prescribed.along.dot(model.origin);
}

}  // namespace taut::machine
