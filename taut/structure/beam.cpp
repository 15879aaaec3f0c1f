#include "taut/structure/beam.hpp"

#include <cmath>
#include <numbers>

#include "taut/base/expects.hpp"

namespace taut::structure {
BeamSection beam_section(const catalogue::SectionRow& row, const Elasticity& steel) {
  return {.area = row.area,
          .EA = steel.E * row.area,
          .EI_x = steel.E * row.I_y,
          .EI_y = steel.E * row.I_z,
          .GJ = steel.G * row.I_t,
          .W_x = row.W_el_y,
          .W_y = row.W_el_z,
          .weight = 0,
          .round = row.shape == catalogue::SectionShape::chs};
}

BeamSection tube_section(double diameter, double wall, const Elasticity& steel) {
  expects(diameter > 0 && wall > 0 && 2 * wall <= diameter, "a tube has a wall that fits into it");
  const double pi = std::numbers::pi, inner = diameter - 2 * wall;
  const double area = pi * (diameter - wall) * wall;
  const double I = pi / 64 * (std::pow(diameter, 4) - std::pow(inner, 4)), W = 2 * I / diameter;
  return {.area = area,
          .EA = steel.E * area,
          .EI_x = steel.E * I,
          .EI_y = steel.E * I,
          .GJ = 2 * steel.G * I,
          .W_x = W,
          .W_y = W,
          .weight = 0,
          .round = true};
}

double largest_stress(const BeamSection& section, double axial, double bends_to_x, double bends_to_y) {
  const double direct = std::abs(axial) / section.area;
  if (section.round) return direct + std::hypot(bends_to_x, bends_to_y) / section.W_x;
  return direct + std::abs(bends_to_x) / section.W_x + std::abs(bends_to_y) / section.W_y;
}

}  // namespace taut::structure
