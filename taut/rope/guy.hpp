#pragma once

namespace taut::rope {

/// A guyline between an anchor and a mast, as a straight rope with a small sag: first estimates of its stiffness. All
/// SI.
struct GuyLine {
  double length = 0;     ///< of the chord, m, > 0
  double slope = 0;      ///< of the chord against the horizontal, rad
  double weight = 0;     ///< per metre, N/m
  double stiffness = 0;  ///< EA, N, on the metallic area
  double tension = 0;    ///< T, mean, N, > 0
};

/// EA of a straight rope that stretches like the sagging one (Ernst, Der Bauingenieur 40, 1965):
/// E_eq A = EA/(1 + (w L cos theta)^2 EA/(12 T^3)), N. Tangent value at the tension T.
double ernst_stiffness(const GuyLine& guy);

/// The same between two tensions, the secant: EA/(1 + (w L cos theta)^2 (T1 + T2) EA/(24 T1^2 T2^2)), N.
double ernst_secant_stiffness(const GuyLine& guy, double T_1, double T_2);

/// Horizontal stiffness that a guy gives its upper end, N/m. In its vertical plane (E_eq A/L) cos^2 theta + (T/L) sin^2
/// theta, across it T/L.
struct GuyStiffness {
  double in_plane = 0;
  double across = 0;
};
GuyStiffness horizontal_stiffness(const GuyLine& guy);

/// Sum of guys around a mast: k_xx, k_xy, k_yy with the azimuth phi of each guy, rad. Slack guys are left out by the
/// caller.
struct RingStiffness {
  double xx = 0, xy = 0, yy = 0;  ///< N/m
};
RingStiffness operator+(const RingStiffness& a, const RingStiffness& b);
RingStiffness in_ring(const GuyStiffness& guy, double azimuth);

/// Horizontal pull and push on the mast of one guy with this tension, N: T cos theta, T sin theta.
struct GuyPull {
  double horizontal = 0, downwards = 0;
};
GuyPull pull_on_mast(const GuyLine& guy);

}  // namespace taut::rope
