#include "taut/rope/length.hpp"

#include <cmath>

#include "taut/base/expects.hpp"
#include "taut/rope/catenary_shape.hpp"

namespace taut::rope {

RopeLengths operator+(const RopeLengths& a, const RopeLengths& b) {
  return {.unstretched = a.unstretched + b.unstretched,
          .installed = a.installed + b.installed,
          .stretched = a.stretched + b.stretched};
}

RopeLengths path_lengths(std::span<const TensionPiece> path, double stiffness, double thermal_strain) {
  expects(stiffness > 0 && thermal_strain > -1, "a rope has stiffness and keeps some length");
  RopeLengths sum;
  for (const TensionPiece& piece : path) {
    expects(piece.unstretched >= 0 && piece.T_from >= 0 && piece.T_to >= 0, "a rope has length and pulls");
    const double warm = piece.unstretched * (1 + thermal_strain);
    const double stretch = (piece.T_from + piece.T_to) / 2 / stiffness;
    sum = sum + RopeLengths{.unstretched = piece.unstretched, .installed = warm, .stretched = warm * (1 + stretch)};
  }
  return sum;
}

double unstretched_length(double stretched, double T_from, double T_to, double stiffness, double thermal_strain) {
  expects(stretched >= 0 && stiffness > 0 && thermal_strain > -1, "a rope has length and stiffness");
  return stretched / (1 + thermal_strain) / (1 + (T_from + T_to) / 2 / stiffness);
}

RopeLengths stretched_span(const CatenaryRope& rope, const CatenaryForce& force, double thermal_strain) {
  const CatenaryRope warm = heated(rope, thermal_strain);
  return {.unstretched = rope.length, .installed = warm.length, .stretched = stretched_length(warm, force)};
}

double unstretched_on_arc(double arc, double T_from, double T_to, double stiffness) {
  expects(arc >= 0 && T_from > 0 && T_to > 0 && stiffness > 0, "a rope lies taut on an arc");
  // dL = R dphi/(1 + T/EA), dphi proportional to dT/T
  const double mean = (T_from + T_to) / 2;
  const double log_ratio = std::log(T_to / T_from);
  if (std::isinf(stiffness)) return arc;
  if (std::abs(log_ratio) < 1e-4) return arc / (1 + mean / stiffness);
  return arc * (1 - std::log1p((T_to - T_from) / (stiffness + T_from)) / log_ratio);
}

double tension_of_stretch(double unstretched, double stretched, double stiffness) {
  expects(unstretched > 0 && stiffness > 0, "a rope has length and stiffness");
  return stiffness * (stretched - unstretched) / unstretched;
}

}  // namespace taut::rope
