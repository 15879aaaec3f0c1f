#pragma once
#include <string>

#include "taut/math/vector.hpp"

namespace taut::machine {

/// Index that stands for the ground instead of a body.
inline constexpr int ground = -1;

/// A point of a body, or of the ground.
struct Place {
  int body = ground;
  Vector3 at = Vector3::Zero();  ///< in the body's frame (ground: in the ground frame), m
};

/// A place that the deck names: a point, marker, sheave, support or drum.
struct NamedPlace {
  std::string name;
  Place place;
};

}  // namespace taut::machine
