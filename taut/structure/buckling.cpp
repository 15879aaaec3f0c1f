#include "taut/structure/buckling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "taut/base/expects.hpp"
#include "taut/catalogue/rule.hpp"

namespace taut::structure {
namespace {

// For double; Num brings its own along.
using std::min;
using std::sqrt;
using std::tan;

constexpr std::array<std::string_view, 5> curve_names = {"a0", "a", "b", "c", "d"};
std::size_t index_of(Curve curve) { return static_cast<std::size_t>(curve); }

constexpr double high_strength = 459.9e6;  // Pa, S460 with a hair for rounding

}  // namespace

std::string_view to_text(Curve curve) { return curve_names.at(index_of(curve)); }

std::optional<Curve> parse_curve(std::string_view text) {
  const auto* const found = std::find(curve_names.begin(), curve_names.end(), text);
  if (found == curve_names.end()) return std::nullopt;
  return static_cast<Curve>(found - curve_names.begin());
}

double imperfection_factor(Curve curve) {
  static const std::array<double, 5> factors = [] {
    std::array<double, 5> all{};
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto rule = catalogue::find_rule(fmt::format("buckling.{}", curve_names.at(i)));
      expects(rule.has_value() && rule->low.has_value(), "the catalogue has all buckling curves");
      all.at(i) = *rule->low;
    }
    return all;
  }();
  return factors.at(index_of(curve));
}

Curve curve_of(const catalogue::SectionRow& section, double yield) {
  using catalogue::Forming;
  if (section.forming == Forming::cold || section.forming == Forming::welded) return Curve::c;
  return yield >= high_strength ? Curve::a0 : Curve::a;
}

double bow_share(Curve curve, bool elastic) {
  constexpr std::array<double, 5> of_elastic = {350, 300, 250, 200, 150}, of_plastic = {300, 250, 200, 150, 100};
  return 1 / (elastic ? of_elastic : of_plastic).at(index_of(curve));
}

double sway_of(double height, int columns) {
  expects(height > 0 && columns >= 1, "a column has a height");
  const double alpha_h = std::clamp(2 / std::sqrt(height), 2.0 / 3, 1.0);
  return alpha_h * std::sqrt((1 + 1.0 / columns) / 2) / 200;
}

bool needs_bow(double slenderness, double squash_load, double N) {
  return N > 0 && slenderness > 0.5 * std::sqrt(squash_load / N);
}

double euler_load(double E, double I, double buckling_length) {
  expects(buckling_length > 0, "a buckling length is positive");
  return std::numbers::pi * std::numbers::pi * E * I / (buckling_length * buckling_length);
}

template <class T>
T second_order_moment(const T& H, const T& N, const T& E, const T& I, const T& L, Sheet<T>& s) {
  if (value(N) <= 0) return s.eq("", "M_II", si::N_m, H * L, "no axial compression");
  const T k = s.eq(
      "", "k",
      Unit{.dimension = dimension(0, -1, 0), .symbol = "1/m", .shown = "1/m", .is_angle = false, .kind = "wave number"},
      sqrt(N / (E * I)), "beam-column, balance in the bent shape");
  expects(value(k) * value(L) < std::numbers::pi / 2, "the axial load stays below Euler's");
  return s.eq("", "M_II", si::N_m, H * tan(k * L) / k, "beam-column, balance in the bent shape");
}

template <class T>
Buckling<T> flexural_buckling(const T& N_Rk, const T& N_cr, Curve curve, std::string_view axis, Sheet<T>& s) {
  const auto name = [&](const char* symbol) { return fmt::format("{}_{}", symbol, axis); };
  if (!std::isfinite(value(N_cr))) return {T(0.0), T(1.0)};
  const T lambda = s.eq("6.50", name("lambda"), si::one, sqrt(N_Rk / N_cr), "EN 1993-1-1, (6.50)");
  const T alpha = s.named("alpha", si::one, imperfection_factor(curve));
  const T Phi =
      s.eq("", name("Phi"), si::one, 0.5 * (1 + alpha * (lambda - 0.2) + square(lambda)), "EN 1993-1-1, 6.3.1.2");
  if (value(lambda) <= 0.2) {
    return {lambda, s.eq("6.49", name("chi"), si::one, T(1.0), "EN 1993-1-1, 6.3.1.2 (4): lambda <= 0.2")};
  }
  return {lambda, s.eq("6.49", name("chi"), si::one, min(T(1.0), 1 / (Phi + sqrt(square(Phi) - square(lambda)))),
                       "EN 1993-1-1, (6.49)")};
}

template double second_order_moment(const double&, const double&, const double&, const double&, const double&,
                                    Sheet<double>&);
template Num second_order_moment(const Num&, const Num&, const Num&, const Num&, const Num&, Sheet<Num>&);
template Buckling<double> flexural_buckling(const double&, const double&, Curve, std::string_view, Sheet<double>&);
template Buckling<Num> flexural_buckling(const Num&, const Num&, Curve, std::string_view, Sheet<Num>&);

}  // namespace taut::structure
