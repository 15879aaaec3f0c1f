#include "taut/units/display.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <tuple>
#include <utility>

#include "taut/base/expects.hpp"
#include "taut/base/suggest.hpp"
#include "taut/units/any_quantity.hpp"

namespace taut {
namespace {

/// An angle in % is a slope, the one unit that is not a factor.
bool is_slope(const Unit& unit, std::string_view shown) { return unit.is_angle && shown == "%"; }

/// A temperature in degrees Celsius, the one unit with an offset.
bool is_celsius(const Unit& unit, std::string_view shown) { return unit.symbol == "K" && shown == "degC"; }

constexpr double first_huge = 1e7;    // from here on an exponent reads better
constexpr double first_small = 1e-4;  // below here too

}  // namespace

struct Display::Factors {
  std::mutex lock;
  /// Dimension, its own unit of print (1/s or Hz), whether it is an angle, unit of print -> SI value of the latter.
  std::map<std::tuple<std::array<int, 4>, std::string, bool, std::string>, double> of;
};

const std::vector<Unit>& display_kinds() {
  static const std::vector<Unit> kinds = {
      si::rad,      si::m,       si::m2,    si::m3,    si::m4,        si::s,        si::kg,       si::N,
      si::N_m,      si::J,       si::W,     si::Pa,    si::N_per_m,   si::kg_per_m, si::N_per_m3, si::m_per_s,
      si::m_per_s2, si::m_per_N, si::per_s, si::kg_m2, si::N_s_per_m, si::K};
  return kinds;
}

tl::expected<void, DisplayError> check_display(std::string_view kind, std::string_view unit) {
  const auto& kinds = display_kinds();
  const auto at = std::find_if(kinds.begin(), kinds.end(), [&](const Unit& u) { return u.kind == kind; });
  if (at == kinds.end()) {
    std::vector<std::string> names;
    names.reserve(kinds.size());
    for (const Unit& u : kinds) names.emplace_back(u.kind);
    std::string hint = did_you_mean(kind, names);
    if (hint.empty()) hint = fmt::format("; the kinds are {}", fmt::join(names, ", "));
    return tl::unexpected(
        DisplayError{.message = fmt::format("'{}' is not a kind of quantity{}", kind, hint), .of_kind = true});
  }
  if (is_celsius(*at, unit)) return {};
  const auto factor = unit_factor(unit, *at);
  if (factor) return {};
  const UnitError& error = factor.error();
  return tl::unexpected(DisplayError{.message = error.message, .offset = error.offset, .width = error.width});
}

Display::Display() : Display(std::map<std::string, std::string>{}) {}

Display::Display(std::map<std::string, std::string> units)
    : units_(std::move(units)), factors_(std::make_shared<Factors>()) {}

double Display::factor(const Unit& unit, const std::string& shown) const {
  const std::lock_guard guard(factors_->lock);
  const Dimension& of = unit.dimension;
  const auto key = std::make_tuple(std::array<int, 4>{of.mass, of.length, of.time, of.temperature},
                                   std::string(unit.shown), unit.is_angle, shown);
  const auto known = factors_->of.find(key);
  if (known != factors_->of.end()) return known->second;
  const auto found = unit_factor(shown, unit);
  expects(found.has_value(), found ? "" : found.error().message);
  factors_->of.emplace(key, *found);
  return *found;
}

std::string Display::unit(const Unit& unit) const {
  const auto chosen = units_.find(std::string(unit.kind));
  if (chosen != units_.end()) return chosen->second;
  return unit.shown == "1" ? std::string{} : std::string(unit.shown);
}

double Display::from_si(double si, const Unit& unit) const {
  const std::string shown = this->unit(unit);
  if (shown.empty()) return si;
  if (is_slope(unit, shown)) return 100.0 * std::tan(si);
  if (is_celsius(unit, shown)) return si - zero_celsius;
  return si / factor(unit, shown);
}

std::string short_number(double x, int digits) {
  if (std::isnan(x)) return "-";
  if (std::isinf(x)) return x < 0 ? "-infinite" : "infinite";
  const double size = std::abs(x);
  if (size == 0) return "0";
  const double first_large = std::pow(10.0, digits);  // from here on the digits would round whole ones away
  if (size >= first_large && size < first_huge) return fmt::format("{:.0f}", x);
  std::string text = fmt::format("{:.{}g}", x, digits);
  if (size >= first_small && size < first_large && text.find('e') == std::string::npos) return text;
  // "1.2e-07" reads as "1.2e-7"; 99999.7 becomes "1e+05" above, and is better whole
  if (size < first_large && size >= first_small) return fmt::format("{:.0f}", x);
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  const int exponent = std::stoi(text.substr(e + 1));
  return fmt::format("{}e{}", text.substr(0, e), exponent);
}

std::string Display::number(double si, const Unit& unit) const { return short_number(from_si(si, unit)); }

std::string Display::quantity(double si, const Unit& unit) const {
  const std::string shown = this->unit(unit);
  const std::string text = number(si, unit);
  return shown.empty() || !std::isfinite(si) ? text : fmt::format("{} {}", text, shown);
}

namespace {

constexpr int brief_digits = 4;
constexpr double centimetre = 0.01;  // m

/// The place of the last digit that is shown; whole digits are kept.
double last_place(double size) {
  return std::min(1., std::pow(10., std::floor(std::log10(size)) - (brief_digits - 1)));
}

/// The next multiple of `step` on that side; a number that is one but for rounding stays.
double on_grid(double x, double step, Rounding side) {
  constexpr double rounding_error = 1e-9;  // of a step
  const double steps = x / step, whole = std::round(steps);
  if (std::abs(steps - whole) < rounding_error * std::max(1., std::abs(whole) * 1e-4)) return whole * step;
  return step * (side == Rounding::down ? std::floor(steps) : std::ceil(steps));
}

/// The decimals by which a length is shown to the centimetre in a unit of so many metres: 2 in m and ft, 0 in mm.
int decimals_to_the_centimetre(double unit) {
  return std::max(0, static_cast<int>(std::ceil(std::log10(unit / centimetre))));
}

/// Without zeros at its end: "382.42", "170".
std::string without_end_zeros(double x, int decimals) {
  std::string text = fmt::format("{:.{}f}", x, decimals);
  if (decimals == 0) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace

std::string Display::brief(double si, const Unit& unit, Rounding rounding) const {
  constexpr double long_way = 10, longest_way = 1e8;  // m; places on the map too
  const std::string shown = this->unit(unit);
  double x = from_si(si, unit);
  const double size = std::abs(x);
  const bool is_way = unit.kind == si::m.kind && std::abs(si) >= long_way && std::abs(si) < longest_way;
  const int decimals = is_way ? decimals_to_the_centimetre(factor(unit, shown)) : 0;
  if (rounding != Rounding::nearest && std::isfinite(x) && x != 0) {
    x = on_grid(x, is_way ? std::pow(10., -decimals) : last_place(size), rounding);
  }
  const std::string text = is_way ? without_end_zeros(x, decimals) : short_number(x, brief_digits);
  return shown.empty() || !std::isfinite(si) ? text : fmt::format("{} {}", text, shown);
}

}  // namespace taut
