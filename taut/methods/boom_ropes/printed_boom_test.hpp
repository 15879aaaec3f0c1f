#pragma once
#include "taut/methods/boom_ropes/boom_ropes.hpp"

namespace taut::boom_ropes {

/// The boom of the paper's example, without its cases: figures as printed.
inline Input printed_boom() {
  Input in;
  in.section_weight = 8.44e3;
  in.pad_friction = 0.15;
  in.tackle_efficiency = 0.95;
  in.extension_stiffness = 2.72e6;
  in.retraction_stiffness = 1.61e6;
  return in;
}

}  // namespace taut::boom_ropes
