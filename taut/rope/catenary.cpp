#include "taut/rope/catenary.hpp"

#include <cmath>

#include "taut/base/expects.hpp"
#include "taut/rope/exact_end.hpp"

namespace taut::rope {
namespace {

/// log(1 + y)/y, 1 at y = 0.
double log1p_ratio(double y) { return y == 0 ? 1 : std::log1p(y) / y; }

Ends<double> ends_of(const CatenaryRope& rope, const CatenaryForce& f) {
  const double half = rope.weight * rope.length / 2;
  Ends<double> e{};
  e.V0 = f.V - half;
  e.V1 = f.V + half;
  e.T0 = std::sqrt(f.H * f.H + e.V0 * e.V0);
  e.T1 = std::sqrt(f.H * f.H + e.V1 * e.V1);
  e.sum = e.T0 + e.T1;
  return e;
}

/// I, the integral of ds/T over the unstretched rope: asinh(V1/H) - asinh(V0/H) = 2 atanh(w L/(T0 + T1)), with the gap.
double inverse_tension(const CatenaryRope& rope, double gap) {
  const double q = 2 * rope.length / gap;
  return std::isinf(q) ? q : q * log1p_ratio(rope.weight * q);
}

/// Integrals over the unstretched rope: I of 1/T, V^2/T^3 and H^2/T^3.
struct Integrals {
  double I, vertical, horizontal;
};

Integrals integrals(const CatenaryRope& rope, double H, const Ends<double>& e) {
  const double wL = e.V1 - e.V0;
  const double L = rope.length;
  const double gap = gap_of(e, H * H);
  Integrals r{};
  r.I = inverse_tension(rope, gap);
  const double sin0 = e.T0 > 0 ? e.V0 / e.T0 : 0;
  const double sin1 = e.T1 > 0 ? e.V1 / e.T1 : 0;
  // with u = asinh(V/H) and D = u1 - u0: tanh(D)/w
  const double tanh_ratio = L / (wL + gap / (2 * wL / gap + 2));
  const double both = e.V0 * e.V1;
  const double TT = e.T0 * e.T1;
  const double across = both > 0 ? H * H * (H * H + e.V0 * e.V0 + e.V1 * e.V1) / (TT * (TT + both)) : 1 - sin0 * sin1;
  r.horizontal = tanh_ratio * across;
  const double D = rope.weight * r.I;
  if (D < 0.1) {  // (D - tanh D)/w by its series: the difference of two nearly equal numbers
    const double d = D * D;
    const double series =
        d *
        (1 / 3.0 - d * (2 / 15.0 - d * (17 / 315.0 - d * (62 / 2835.0 - d * (1382 / 155925.0 - d * 21844 / 6081075)))));
    r.vertical = r.I * series + tanh_ratio * sin0 * sin1;
  } else {
    r.vertical = r.I - tanh_ratio * across;
  }
  return r;
}

}  // namespace

CatenaryRope heated(const CatenaryRope& rope, double thermal_strain) {
  expects(thermal_strain > -1, "a rope keeps some length");
  return {.length = rope.length * (1 + thermal_strain),
          .weight = rope.weight / (1 + thermal_strain),
          .stiffness = rope.stiffness};
}

std::string_view to_text(NoCatenary why) {
  switch (why) {
    case NoCatenary::too_short:
      return "the rope does not reach: it does not stretch and is not longer than the chord";
    case NoCatenary::slack:
      return "a rope without weight that is longer than the chord hangs in no certain shape";
    case NoCatenary::not_converged:
      return "the span did not converge";
  }
  return {};
}

EndPosition end_position(const CatenaryRope& rope, const CatenaryForce& f) {
  const Ends<double> e = ends_of(rope, f);
  const Integrals integral = integrals(rope, f.H, e);
  const double compliance = rope.length / rope.stiffness;
  const double TT = e.T0 * e.T1;
  EndPosition p;
  p.x = f.H == 0 ? 0 : f.H * (compliance + integral.I);
  p.z = e.sum > 0 ? f.V * (compliance + 2 * rope.length / e.sum) : 0;
  p.dx_dH = compliance + integral.vertical;
  p.dx_dV = f.H == 0 ? 0 : -f.H * rope.length * (2 * f.V / e.sum) / TT;
  p.dz_dV = compliance + integral.horizontal;
  return p;
}

EndRates end_rates(const CatenaryRope& rope, const CatenaryForce& f) {
  const Ends<double> e = ends_of(rope, f);
  const EndPosition p = end_position(rope, f);
  EndRates r;
  if (e.T0 > 0 && e.T1 > 0) {
    r.dx_dlength = f.H / rope.stiffness + f.H * (1 / e.T0 + 1 / e.T1) / 2;
    r.dz_dlength = f.V / rope.stiffness + (e.V0 / e.T0 + e.V1 / e.T1) / 2;
  }
  // heat scales the rope and keeps its weight: so does the curve
  r.dx_dheat = p.x;
  r.dz_dheat = p.z;
  return r;
}

CatenaryStiffness stiffness(const CatenaryRope& rope, const CatenaryForce& f) {
  const EndPosition p = end_position(rope, f);
  const EndRates rate = end_rates(rope, f);
  const double turn = p.dx_dV / p.dx_dH;  // 0 where dx/dH is infinite
  CatenaryStiffness k;
  k.dV_dz = 1 / (p.dz_dV - p.dx_dV * turn);
  k.dH_dz = -turn * k.dV_dz;
  k.dH_dx = 1 / p.dx_dH - turn * k.dH_dz;
  k.out_of_plane = 1 / (rope.length / rope.stiffness + inverse_tension(rope, gap_of(ends_of(rope, f), f.H * f.H)));
  k.dH_dlength = -(k.dH_dx * rate.dx_dlength + k.dH_dz * rate.dz_dlength);
  k.dV_dlength = -(k.dH_dz * rate.dx_dlength + k.dV_dz * rate.dz_dlength);
  k.dH_dheat = -(k.dH_dx * rate.dx_dheat + k.dH_dz * rate.dz_dheat);
  k.dV_dheat = -(k.dH_dz * rate.dx_dheat + k.dV_dz * rate.dz_dheat);
  return k;
}

}  // namespace taut::rope
