#pragma once
#include <optional>
#include <tl/expected.hpp>

#include "taut/math/vector.hpp"
#include "taut/rope/catenary.hpp"

namespace taut::rope {

/// A solved free rope between two points in space. All SI, z up.
struct Span {
  CatenaryRope rope;
  Vector3 chord = Vector3::Zero();   ///< end - start, m
  Vector3 along = Vector3::UnitX();  ///< horizontal unit vector from the start towards the end
  CatenaryForce force;               ///< at the middle of the rope
  bool slack = false;  ///< weightless and longer than the chord: no force, no stiffness, shape not determined
  double closure = 0;  ///< m
  int iterations = 0;
};

/// Solves the span of `rope` over `chord`, m. A weightless rope longer than its chord is returned as a slack span, not
/// as an error. `start`: the force of a similar span.
tl::expected<Span, NoCatenary> solve_span(const CatenaryRope& rope, const Vector3& chord,
                                          const std::optional<CatenaryForce>& start = std::nullopt);

/// Forces of the rope on its two supports, N. Their sum is the weight of the rope.
Vector3 force_on_start(const Span& span);
Vector3 force_on_end(const Span& span);

/// The tangent stiffness d(force_on_start)/d(chord) = -d(force_on_end)/d(chord), N/m: symmetric, positive semidefinite.
/// In the plane of the span it is the inverse of the compliance of the catenary; normal to it H/x.
Matrix3 stiffness(const Span& span);

/// Derivatives of both end forces by the unstretched length (N/m, at constant weight per metre) and by the thermal
/// strain (N, at constant total weight).
struct EndForceRates {
  Vector3 start = Vector3::Zero();
  Vector3 end = Vector3::Zero();
};
EndForceRates length_rates(const Span& span);
EndForceRates heat_rates(const Span& span);

/// Tension at the start, at the end, and the larger of the two, which is the largest in the rope, N.
double tension_at_start(const Span& span);
double tension_at_end(const Span& span);
double largest_tension(const Span& span);

/// Position of the point at the unstretched length s, relative to the start, m. Of a slack span: on the chord.
Vector3 point_at(const Span& span, double s);
/// Tension at the unstretched length s as a vector along the rope, towards its end, N.
Vector3 tension_at(const Span& span, double s);

/// Largest sag below the chord, and the sag at the horizontal distance x from the start, m (0 for a slack span).
double largest_sag(const Span& span);
double sag_at(const Span& span, double x);
/// Length under load, m.
double stretched_length(const Span& span);

}  // namespace taut::rope
