#pragma once
#include <optional>
#include <string_view>

#include "taut/calc/num.hpp"
#include "taut/calc/sheet.hpp"
#include "taut/catalogue/section.hpp"

/// Flexural buckling and imperfections of EN 1993-1-1:2005. All SI.
namespace taut::structure {

/// Buckling curves of table 6.1.
enum class Curve { a0, a, b, c, d };

std::string_view to_text(Curve curve);                    ///< "a0", "a", ...
std::optional<Curve> parse_curve(std::string_view text);  ///< of that text

/// Imperfection factor alpha of a curve: 0.13, 0.21, 0.34, 0.49, 0.76, from the catalogue's rules `buckling.*`.
double imperfection_factor(Curve curve);

/// The curve of a hollow section, table 6.2: hot-finished a (f_y of 460 MPa or more: a0), cold-formed c. Seamless tubes
/// count as hot-finished, welded ones of GOST 10704 as cold-formed.
Curve curve_of(const catalogue::SectionRow& section, double yield);

/// Largest offset of a bow over the length it belongs to, e_0/L, table 5.1, for elastic or plastic resistance.
double bow_share(Curve curve, bool elastic);

/// Sway phi = alpha_h alpha_m/200 (5.5): alpha_h = 2/sqrt(h), h in m, within 2/3 and 1; alpha_m = sqrt((1 + 1/m)/2), m
/// columns side by side.
double sway_of(double height, int columns = 1);

/// Whether a bow has to be added to the sway of a column with a clamped end, (5.8): lambda > 0.5 sqrt(A f_y/N), lambda
/// of the pinned column of the same length.
bool needs_bow(double slenderness, double squash_load, double N);

/// Euler's load of a column of buckling length L_cr, N.
double euler_load(double E, double I, double buckling_length);

/// M at the clamp of a cantilever of height L with axial load N (pressed, 0 <= N < (pi/2)^2 EI/L^2) and transverse load
/// H at its top, balanced in the bent shape: H tan(k L)/k, k = sqrt(N/(E I)).
template <class T>
T second_order_moment(const T& H, const T& N, const T& E, const T& I, const T& L, Sheet<T>& s);

/// What flexural buckling about one axis leaves of the squash load.
template <class T>
struct Buckling {
  T slenderness;  ///< lambda-bar
  T chi;          ///< reduction factor
};

/// lambda = sqrt(N_Rk/N_cr), Phi = (1 + alpha (lambda - 0.2) + lambda^2)/2, chi = 1/(Phi + sqrt(Phi^2 - lambda^2)) <=
/// 1, (6.49), (6.50). `axis` "y" or "z" names the lines. N_cr may be infinite: chi = 1.
template <class T>
Buckling<T> flexural_buckling(const T& N_Rk, const T& N_cr, Curve curve, std::string_view axis, Sheet<T>& s);

}  // namespace taut::structure
