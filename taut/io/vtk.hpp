#pragma once
#include <string>
#include <utility>
#include <vector>

#include "taut/calc/result.hpp"

namespace taut::io {

/// A scene as VTK XML files, name and text: "NAME_0000.vtp" for each time (lines and points with the arrays `tension`
/// in N, `velocity` in m/s, `radius` in m by point, and `part` by cell: the number of the line or point, lines first),
/// last "NAME.pvd" that names them with their times. Numbers in as many digits as bring the same number back.
std::vector<std::pair<std::string, std::string>> to_vtk(const Scene& scene);

}  // namespace taut::io
