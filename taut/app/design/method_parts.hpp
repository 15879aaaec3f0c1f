#pragma once
#include "taut/app/methods.hpp"

/// What a design may put into the inputs of the published methods.
namespace taut::app {

/// Pa, of steel ropes on the metallic area, as the methods take it themselves.
inline constexpr double method_modulus = 100e9;

MethodDesign design_of_loop();
MethodDesign design_of_drive();
MethodDesign design_of_boom();
MethodDesign design_of_mast();

}  // namespace taut::app
