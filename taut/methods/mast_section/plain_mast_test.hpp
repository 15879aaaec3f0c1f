#pragma once
#include "taut/methods/mast_section/mast_section.hpp"

namespace taut::mast_section {

/// A mast of 8 m under 100 kN and 40 kN.
inline Input plain_mast() {
  Input in;
  in.skyline_force = 100e3;
  in.mainline_force = 40e3;
  in.skyline_block_height = 8;
  in.allowable_stress = 160e6;
  in.branch_angle = 0.2;
  return in;
}

}  // namespace taut::mast_section
