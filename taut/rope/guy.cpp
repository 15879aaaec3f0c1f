#include "taut/rope/guy.hpp"

#include <cmath>

#include "taut/base/expects.hpp"

namespace taut::rope {
namespace {

/// (w L cos theta)^2 EA: the square of the weight across the chord times EA.
double sag_term(const GuyLine& guy) {
  expects(guy.length > 0 && guy.weight >= 0 && guy.stiffness > 0, "a guy has length, weight and stiffness");
  const double across = guy.weight * guy.length * std::cos(guy.slope);
  return across * across * guy.stiffness;
}

}  // namespace

double ernst_stiffness(const GuyLine& guy) { return ernst_secant_stiffness(guy, guy.tension, guy.tension); }

double ernst_secant_stiffness(const GuyLine& guy, double T_1, double T_2) {
  expects(T_1 > 0 && T_2 > 0, "a guy is taut");
  return guy.stiffness / (1 + sag_term(guy) * (T_1 + T_2) / (24 * T_1 * T_1 * T_2 * T_2));
}

GuyStiffness horizontal_stiffness(const GuyLine& guy) {
  const double c = std::cos(guy.slope), s = std::sin(guy.slope);
  const double across = guy.tension / guy.length;
  return {.in_plane = ernst_stiffness(guy) / guy.length * c * c + across * s * s, .across = across};
}

RingStiffness operator+(const RingStiffness& a, const RingStiffness& b) {
  return {.xx = a.xx + b.xx, .xy = a.xy + b.xy, .yy = a.yy + b.yy};
}

RingStiffness in_ring(const GuyStiffness& guy, double azimuth) {
  const double c = std::cos(azimuth), s = std::sin(azimuth);
  return {.xx = guy.in_plane * c * c + guy.across * s * s,
          .xy = (guy.in_plane - guy.across) * c * s,
          .yy = guy.in_plane * s * s + guy.across * c * c};
}

GuyPull pull_on_mast(const GuyLine& guy) {
  return {.horizontal = guy.tension * std::cos(guy.slope), .downwards = guy.tension * std::sin(guy.slope)};
}

}  // namespace taut::rope
