#pragma once
#include <optional>
#include <tl/expected.hpp>

#include "taut/math/vector.hpp"
#include "taut/rope/catenary.hpp"

namespace taut::rope {

/// A free rope between two points in space, solved. `rope`: its own plane's catenary. All SI, z up.
struct Span {
  CatenaryRope rope;
  Vector3 chord = Vector3::Zero();   ///< end - start, m
  Vector3 along = Vector3::UnitX();  ///< horizontal unit vector from the start towards the end
  CatenaryForce force;               ///< at the middle of the rope
  bool slack = false;                ///< weightless and longer than the chord: no force, no stiffness, no certain shape
  double closure = 0;                ///< m
  int iterations = 0;
};

/// The span of `rope` over `chord`. A weightless rope longer than its chord is a slack span, not an error.
/// `start`: the force of a nearby solution.
tl::expected<Span, NoCatenary> solve_span(const CatenaryRope& rope, const Vector3& chord,
                                          const std::optional<CatenaryForce>& start = std::nullopt);

/// Forces of the rope on what holds its ends, N. Their sum is the rope's weight.
Vector3 force_on_start(const Span& span);
Vector3 force_on_end(const Span& span);

/// The tangent stiffness d(force_on_start)/d(chord) = -d(force_on_end)/d(chord), N/m: symmetric, positive semidefinite.
/// In the span's plane the inverse of the catenary's compliance; across it H/x.
Matrix3 stiffness(const Span& span);

/// Derivatives of both end forces with respect to the unstretched length (N/m; the weight per metre stays) and to the
/// thermal strain (N; the weight of the whole rope stays).
struct EndForceRates {
  Vector3 start = Vector3::Zero();
  Vector3 end = Vector3::Zero();
};
EndForceRates length_rates(const Span& span);
EndForceRates heat_rates(const Span& span);

/// Tension at the start, at the end, and the larger of the two, which is the rope's largest, N.
double tension_at_start(const Span& span);
double tension_at_end(const Span& span);
double largest_tension(const Span& span);

/// Place of the point at the unstretched length s, seen from the start, m. Of a slack span: on the chord.
Vector3 point_at(const Span& span, double s);
/// Tension at the unstretched length s as a vector along the rope, towards its end, N.
Vector3 tension_at(const Span& span, double s);

/// Largest sag below the chord, and the sag at the horizontal distance x from the start, m (0 for a slack span).
double largest_sag(const Span& span);
double sag_at(const Span& span, double x);
/// Length under load, m.
double stretched_length(const Span& span);

}  // namespace taut::rope
