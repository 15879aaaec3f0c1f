#include "taut/rope/parabola.hpp"

#include <cmath>

#include "taut/base/expects.hpp"

namespace taut::rope {
namespace {

void check(const Parabola& p) {
  expects(p.span > 0 && std::isfinite(p.rise) && p.weight >= 0, "a parabola has a horizontal span and a weight");
}

/// Integral of sqrt(1 + t^2).
double arc(double t) { return (t * std::sqrt(1 + t * t) + std::asinh(t)) / 2; }

}  // namespace

double chord(const Parabola& p) { return std::hypot(p.span, p.rise); }

double tension_for_sag(const Parabola& p, double sag) {
  check(p);
  expects(sag > 0, "a rope sags below its chord");
  return p.weight * chord(p) * p.span / (8 * sag);
}

double sag_for_tension(const Parabola& p, double H) { return sag_at(p, H, p.span / 2); }

double sag_at(const Parabola& p, double H, double x) {
  check(p);
  expects(H > 0 && x >= 0 && x <= p.span, "a rope pulls, and x lies in its span");
  return p.weight * chord(p) * x * (p.span - x) / (2 * p.span * H);
}

ParabolaEnds end_forces(const Parabola& p, double H) {
  check(p);
  const double mean = H * p.rise / p.span, half = p.weight * chord(p) / 2;
  return {.V_start = mean - half, .V_end = mean + half};
}

double arc_length(const Parabola& p, double H) {
  check(p);
  expects(H > 0, "a rope pulls");
  const double slope = p.rise / p.span, half = p.weight * chord(p) / (2 * H);  // end slopes: slope -+ half
  if (half < 1e-3) {  // the difference of two nearly equal arcs, by Taylor about the chord's slope
    const double r = 1 + slope * slope, root = std::sqrt(r);
    const double d2 = 1 / (r * root), d4 = (12 * slope * slope - 3) / (r * r * r * root);
    const double square = half * half;
    return p.span * (root + square * (d2 / 6 + square * d4 / 120));
  }
  return p.span * (arc(slope + half) - arc(slope - half)) / (2 * half);
}

double tension_for_loaded_sag(const Parabola& p, double P, double x, double sag) {
  check(p);
  expects(x >= 0 && x <= p.span && sag > 0, "a load hangs in the span, below the chord");
  return x * (p.span - x) / (sag * p.span) * (p.weight * chord(p) / 2 + P);
}

double taut_tension(const Parabola& p, double length, double stiffness) {
  check(p);
  expects(length > 0 && stiffness > 0, "a rope has length and stiffness");
  const double c = chord(p);
  const double strain = (c - length) / length;
  const double across = p.weight * length * p.span / c;
  const double sag = across * across / 24;
  if (strain >= 0 && std::isinf(stiffness)) return stiffness;
  if (sag == 0) return std::fmax(0.0, stiffness * strain);
  // f(T) = T/EA - strain - sag/T^2 rises and is concave: Newton from the left of the root rises to it
  const double stretch_alone = stiffness * strain, sag_alone = std::cbrt(stiffness * sag);
  double T = strain >= 0 ? std::fmax(stretch_alone, sag_alone) : 0.75 * std::fmin(sag_alone, std::sqrt(sag / -strain));
  for (int i = 0; i < 100; ++i) {
    const double f = T / stiffness - strain - sag / (T * T);
    const double next = T - f / (1 / stiffness + 2 * sag / (T * T * T));
    if (!(next > T)) break;  // at rounding
    T = next;
  }
  return T;
}

double straight_tension(const StraightRope& rope, double chord) {
  expects(rope.length > 0 && rope.stiffness > 0, "a rope has length and stiffness");
  return chord > rope.length ? rope.stiffness * (chord - rope.length) / rope.length : 0;
}

Matrix3 straight_stiffness(const StraightRope& rope, const Vector3& chord) {
  const double c = chord.norm(), T = straight_tension(rope, c);
  if (T == 0) return Matrix3::Zero();
  const Vector3 e = chord / c;
  const Matrix3 along = e * e.transpose();
  return rope.stiffness / rope.length * along + T / c * (Matrix3::Identity() - along);
}

}  // namespace taut::rope
