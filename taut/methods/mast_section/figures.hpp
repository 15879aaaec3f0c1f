#pragma once
#include <optional>
#include <vector>

#include "taut/calc/figure.hpp"
#include "taut/methods/mast_section/mast_section.hpp"
#include "taut/methods/mast_section/position.hpp"
#include "taut/methods/mast_section/sizing.hpp"

namespace taut::mast_section {

/// The mast to scale with its ropes, the forces on its blocks and at its clamp.
Drawing mast_drawing(const Input& in, const Output& out);

/// The mast as its deck describes it, with the forces of its ropes at their drums and no section.
Drawing mast_without_answer(const Input& in, const Output& out);

/// Where the mainline's block is: at the skyline's without an own one, m.
double mainline_height(const Input& in);

/// The triangles of forces of both blocks, one after the other, adding up to Q and N.
Drawing force_polygon(const Input& in, const Output& out);

/// Bending moment over the height of the mast, m and N m.
Plot moment_plot(const Input& in, const Output& out);

/// Largest stress over the height, in the catalogue section where there is one, else in the tube D_tube.
Plot stress_plot(const Input& in, const Output& out, const std::optional<Assessment>& section);

/// Sizes over the branch angle, with the one at hand marked: how much depends on that angle.
Plot angle_plot(const Input& in, const Output& out);

/// Sizes, axial force and moment over the carriage's position.
Plot position_size_plot(const std::vector<Position>& positions, const Output& out);
Plot position_force_plot(const std::vector<Position>& positions, const Output& out);
Plot position_moment_plot(const std::vector<Position>& positions, const Output& out);

}  // namespace taut::mast_section
