#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "taut/base/diagnostic.hpp"
#include "taut/machine/description/machine.hpp"
#include "taut/machine/model.hpp"
#include "taut/units/display.hpp"

namespace taut::app {

/// Reads a ground profile into `terrain.x` and `terrain.z`, m, or a survey into `terrain.x`, `terrain.y` and
/// `terrain.z`. CSV with commas, semicolons or tabs; the first line names the columns ("x", "x [m]", "x_m"; chainage or
/// station for the x of a profile): x, y and z of a survey, else x and z of a profile; the others are left alone. In
/// metres, or in the unit of length that the name has in brackets, "x [ft]", as in the CSV files that taut writes.
/// Without names two columns are a profile, three a survey. Empty lines and lines that begin with # are skipped.
/// Mistakes: no such column, a cell that is no number, x of a profile that does not grow, fewer than two points.
void read_terrain(std::string_view csv, const std::string& file, machine::description::Terrain& terrain,
                  Diagnostics& mistakes);

/// Of rows of a survey that lie off the line in plan by more than the corridor; none where there are none.
std::optional<std::string> survey_warning(const machine::Model& model, const Display& display);

}  // namespace taut::app
