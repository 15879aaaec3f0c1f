#pragma once
#include "taut/math/vector.hpp"

namespace taut::rope {

/// The parabola: a rope whose weight is spread evenly along its chord. First estimates, and the limit of the catenary
/// for small sag (Irvine, Cable Structures, 1981, chapter 2). All SI. With l the horizontal span, h the rise of the
/// end, c the chord and w the weight per metre of chord: sag below the chord at x is w c x (l - x)/(2 l H).
struct Parabola {
  double span = 0;    ///< l, m, > 0
  double rise = 0;    ///< h, m, up
  double weight = 0;  ///< w, N/m of chord, >= 0
};

double chord(const Parabola& p);

/// Horizontal tension that gives the sag f > 0 at midspan, H = w c l/(8 f), N; and the sag for a tension H > 0, m.
double tension_for_sag(const Parabola& p, double sag);
double sag_for_tension(const Parabola& p, double H);

/// Sag below the chord at x, m.
double sag_at(const Parabola& p, double H, double x);

/// Vertical tension at the start and at the end, N, upwards: H h/l -+ w c/2.
struct ParabolaEnds {
  double V_start = 0, V_end = 0;
};
ParabolaEnds end_forces(const Parabola& p, double H);

/// Exact length of the parabola, m, by its closed form; a series where the sag is small.
double arc_length(const Parabola& p, double H);

/// Horizontal tension and sag at x of a parabola that carries also a weight P at x: H f = M(x), M the bending moment of
/// the simply supported beam, M = w c x (l - x)/(2 l) + P x (l - x)/l. N.
double tension_for_loaded_sag(const Parabola& p, double P, double x, double sag);

/// Mean tension T along the chord of an elastic rope of unstretched length L that is taut or a little slack:
/// T/EA = c/L - 1 + (w_n L)^2/(24 T^2), w_n = w l/c the weight across the chord: a cubic with one positive root. N;
/// infinite for an inextensible rope that does not reach, 0 for a slack weightless one. Error of the order of the
/// square of sag over span.
double taut_tension(const Parabola& p, double length, double stiffness);

/// A straight elastic rope between two points, without weight.
struct StraightRope {
  double length = 0;     ///< unstretched, m, > 0
  double stiffness = 0;  ///< EA, N
};
/// Tension EA (c/L - 1), N; 0 when slack.
double straight_tension(const StraightRope& rope, double chord);
/// d(force on the start)/d(chord): EA/L along the rope, T/c across it, N/m; zero when slack.
Matrix3 straight_stiffness(const StraightRope& rope, const Vector3& chord);

}  // namespace taut::rope
