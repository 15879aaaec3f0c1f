#include "taut/methods/closed_loop/case.hpp"

#include <cmath>
#include <numbers>

#include "taut/units/display.hpp"

namespace taut::closed_loop {
namespace {

template <class T>
void slope_of(const Input& in, Sheet<T>& s, Case<T>& c) {
  using std::abs;
  using std::atan;
  using std::tan;
  if (in.height_difference) {
    const T h = s.given(*in.height_difference);
    c.alpha_s = s.eq("", "alpha_s", si::rad, atan(h / c.l));
  } else {
    c.alpha_s = s.given(in.slope);
  }
  c.downhill = !(value(c.alpha_s) < 0);
  c.alpha = c.downhill ? c.alpha_s : s.eq("", "alpha", si::rad, abs(c.alpha_s));
  c.m = s.eq("", "m", si::one, tan(c.alpha_s));
}

template <class T>
T efficiency_of(const Input& in, Sheet<T>& s) {
  using std::pow;
  T eta = s.given(in.tail_efficiency);
  if (in.tail_sheaves > 1) eta = s.eq("", "eta_B", si::one, pow(eta, in.tail_sheaves));
  if (in.haul == Haul::out) {
    s.note("Out-haul: the rope runs from the lower to the upper branch, so 1/eta stands for eta.");
    eta = s.eq("", "eta_eff", si::one, 1.0 / eta);
  }
  return eta;
}

}  // namespace

std::string shown(const Display* display, double x, const Unit& unit) {
  static const Display of_print;  // asks for its factors once
  return (display != nullptr ? *display : of_print).brief(x, unit);
}

template <class T>
Case<T> make_case(const Input& in, const Setting& at, Sheet<T>& s) {
  using std::cos;
  using std::sin;
  Case<T> c;
  c.l = s.given(in.span);
  slope_of(in, s, c);
  c.cos_a = cos(c.alpha);
  c.sin_a = sin(c.alpha);
  c.sin_2a = sin(2.0 * c.alpha);
  c.x = at.x == nullptr ? s.eq("", "x", si::m, c.l / 2.0) : s.given(*at.x);
  c.y = s.eq("", "y", si::m, c.l - c.x);
  c.midspan = std::abs(value(c.x) - value(c.y)) <= midspan_tolerance * in.span;
  c.S = s.given(in.gathering_force);
  T gamma = s.given(in.gathering_angle);
  if (in.gathering_angle_from == AngleFrom::horizontal) {
    gamma = s.eq("", "gamma_v", si::rad, std::numbers::pi / 2 - gamma);
  }
  c.sin_g = sin(gamma);
  c.cos_g = cos(gamma);
  const bool own_b = in.return_weight && *in.return_weight == at.q_b;
  const bool own_T = in.traction_weight && *in.traction_weight == at.q_T;
  c.q_b = own_b ? s.given(*in.return_weight) : s.named("q_b", si::N_per_m, at.q_b);
  c.q_T = own_T ? s.given(*in.traction_weight) : s.named("q_T", si::N_per_m, at.q_T);
  c.w_b = s.eq("", "w_b", si::N_per_m, c.q_b / c.cos_a);
  c.w_T = s.eq("", "w_T", si::N_per_m, c.q_T / c.cos_a);
  c.eta = efficiency_of(in, s);
  c.W_c = s.given(in.carriage_weight);
  c.has_weight = in.carriage_weight > 0;
  c.roller = in.roller;
  c.display = at.display;
  c.EA_b = at.EA_b.value_or(in.return_stiffness);
  c.EA_T = at.EA_T.value_or(in.traction_stiffness);
  return c;
}

template Case<double> make_case(const Input&, const Setting&, Sheet<double>&);
template Case<Num> make_case(const Input&, const Setting&, Sheet<Num>&);

}  // namespace taut::closed_loop
