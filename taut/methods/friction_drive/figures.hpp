#pragma once
#include <vector>

#include "taut/calc/figure.hpp"
#include "taut/methods/friction_drive/friction_drive.hpp"
#include "taut/units/display.hpp"

namespace taut::friction_drive {

/// Both sheaves of the drive as drawn: radii and distance of the centres (m) that give the wrap; `to_scale` is false
/// when no two sheaves with an open rope do.
struct Layout {
  double driving_radius = 1;
  double idler_radius = 1;
  double distance = 4;
  double wrap = 0;  ///< as drawn, rad
  bool to_scale = true;
};
Layout layout_of(const Input& in);

/// Both sheaves, branches and forces.
Drawing drive_drawing(const Input& in, const Output& out);
/// The same without tensions, for a drive that has no answer.
Drawing drive_without_answer(const Input& in);

/// Tension along the working arc of the driving sheave, from the slack side, with what Euler allows.
Plot arc_plot(const Input& in, const Output& out);

/// Cutting force that the pull takeup_no_slip passes on, over friction.
Plot friction_plot(const Input& in, const Output& out, const Display& display);

/// Pull on the idler that the cutting force asks for, over friction: without slip and by (18).
Plot pull_plot(const Input& in, const Output& out);

/// Cutting force passed on over speed, for a weight that pulls the idler and for a screw set at rest.
Plot speed_plot(const Input& in, const Output& out);

}  // namespace taut::friction_drive
