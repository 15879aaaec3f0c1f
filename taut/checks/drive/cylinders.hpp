#pragma once
#include <map>
#include <string>

#include "taut/calc/result.hpp"
#include "taut/machine/model.hpp"
#include "taut/solve/motion/transient.hpp"
#include "taut/units/display.hpp"

namespace taut::checks {

/// A moment of a motion in words.
struct CylinderMoment {
  std::string words;
  bool slowly = false;  ///< it is at rest
  const Display& display;
};

/// Cylinders that do not do what their speed, force or law asks, each with the first moment of it: at their force limit
/// they give way, or are locked beyond it. In a slow motion one with a law may bear more than that gives.
void take_cylinders(const machine::Model& model, const solve::TransientFrame& frame, const CylinderMoment& moment,
                    std::map<Part, std::string>& told);

}  // namespace taut::checks
