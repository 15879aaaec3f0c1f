#pragma once
#include <numbers>

#include "taut/methods/friction_drive/friction_drive.hpp"

namespace taut::friction_drive {

/// A rope saw, without its rope.
inline Input saw_drive() {
  Input in;
  in.cutting_force = 4000;
  in.friction = 0.8;
  in.wrap = 200 * std::numbers::pi / 180;
  in.rope_mass = 0.35;
  in.speed = 15;
  in.grip_reserve = 1.3;
  return in;
}

}  // namespace taut::friction_drive
