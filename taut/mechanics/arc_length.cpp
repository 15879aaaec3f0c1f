#include "taut/mechanics/arc_length.hpp"

#include <cmath>
#include <utility>

namespace taut::mechanics {
namespace {

constexpr double as_good_as_equal = 1e-6;  ///< ln(T_x/T_e), below which the tension is one

ArcLength by_mean(const Arc& a) {
  const double stretch = 1 + (a.T_in + a.T_out) / 2 / a.stiffness;
  ArcLength l;
  l.length = a.radius * a.wrap / stretch;
  l.by_in = l.by_out = -l.length / stretch / a.stiffness / 2;
  l.by_wrap = a.radius / stretch;
  return l;
}

/// In the order in which the rope runs: `by_in` by the tension with which it comes on.
ArcLength as_it_runs(const Arc& a, double T_e, double T_x) {
  const double q = std::log(T_x / T_e), EA = a.stiffness;
  const double ends = std::log1p((T_x - T_e) / (EA + T_e));  // ln((EA + T_x)/(EA + T_e))
  const double rest = EA / (EA + T_e);                       // 1/(1 + T_e/EA)
  const double slips = std::abs(q) / a.friction;             // rad
  ArcLength l;
  if (std::abs(q) < as_good_as_equal) {  // the limit of what follows
    l.length = a.radius * a.wrap * rest;
    l.by_in = -l.length * rest / EA;
    l.by_wrap = a.radius * rest;
    return l;
  }
  if (slips >= a.wrap) {
    // by the law of what slips as a whole, whatever it is on the way there
    const double R = a.radius, theta = a.wrap;
    l.length = R * theta * (1 - ends / q);
    l.by_in = R * theta * (1 / ((EA + T_e) * q) - ends / (q * q * T_e));
    l.by_out = R * theta * (ends / (q * q * T_x) - 1 / ((EA + T_x) * q));
    l.by_wrap = R * (1 - ends / q);
    return l;
  }
  const double s = q > 0 ? 1 : -1;
  l.length = a.radius * ((a.wrap - slips) * rest + slips - s * ends / a.friction);
  l.by_in = -a.radius * (a.wrap - slips) * rest * rest / EA;
  l.by_out = a.radius * s / a.friction * (T_e / (T_x * (EA + T_e)) - 1 / (EA + T_x));
  if (std::isinf(a.friction)) l.by_out = 0;
  l.by_wrap = a.radius * rest;
  return l;
}

}  // namespace

ArcLength arc_length(const Arc& a) {
  if (a.radius == 0) return {};
  const bool runs = a.flow != 0 && std::isfinite(a.stiffness) && a.wrap > 0 && a.T_in > 0 && a.T_out > 0;
  if (!runs || !(a.friction > 0)) return by_mean(a);
  const bool along = a.flow > 0;
  ArcLength l = as_it_runs(a, along ? a.T_in : a.T_out, along ? a.T_out : a.T_in);
  if (!along) std::swap(l.by_in, l.by_out);
  return l;
}

}  // namespace taut::mechanics
