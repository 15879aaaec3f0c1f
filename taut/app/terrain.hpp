#pragma once
#include <string>
#include <string_view>

#include "taut/base/diagnostic.hpp"
#include "taut/model/machine.hpp"

namespace taut::app {

/// Reads a ground profile into `terrain.x` and `terrain.z`, m. CSV with commas, semicolons or tabs; the first line
/// names the columns, among them x and z ("x", "x [m]", "x_m"); the others are left alone. Empty lines and lines that
/// begin with # are skipped. Mistakes: no such column, a cell that is no number, x that does not grow, fewer than two
/// points.
void read_terrain(std::string_view csv, const std::string& file, model::description::Terrain& terrain,
                  Diagnostics& mistakes);

}  // namespace taut::app
