#include "taut/methods/friction_drive/grip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "taut/calc/result.hpp"

namespace taut::friction_drive {
namespace {

/// A little more than just enough, so that the value named in a message does what it says.
constexpr double margin = 1.005;

}  // namespace

double working_share(const Input& in) {
  return (1 - in.section_factor) / (in.friction * in.section_factor + 1) * in.fill_ratio;
}

double grip_ratio(const Input& in) { return std::exp(in.friction * (in.wrap - in.rest_arc) * working_share(in)); }

std::optional<double> wrap_for(const Input& in, double ratio) {
  const double share = working_share(in);
  if (!(share > 0)) return std::nullopt;
  return in.rest_arc + std::log(ratio) / (in.friction * share);
}

std::optional<double> friction_for(const Input& in, double ratio) {
  // mu G / (mu k + 1) = ln(ratio)
  const double G = (in.wrap - in.rest_arc) * (1 - in.section_factor) * in.fill_ratio;
  const double below = G - std::log(ratio) * in.section_factor;
  if (!(below > 0)) return std::nullopt;
  const double mu = std::log(ratio) / below;
  return mu <= 1.5 ? std::optional(mu) : std::nullopt;
}

std::optional<double> fill_for(const Input& in, double ratio) {
  const double full =
      in.friction * (in.wrap - in.rest_arc) * (1 - in.section_factor) / (in.friction * in.section_factor + 1);
  if (!(full > 0)) return std::nullopt;
  const double fill = std::log(ratio) / full;
  return fill <= 1 ? std::optional(fill) : std::nullopt;
}

std::string how_to_get_grip(const Input& in, const Display& display) {
  const double ratio = in.idler_loss * margin;
  std::vector<std::string> ways, lower;
  if (const auto wrap = wrap_for(in, ratio)) ways.push_back("the wrap above " + display.brief(*wrap, si::rad));
  if (const auto mu = friction_for(in, ratio)) ways.push_back(fmt::format("the friction above {:.3g}", *mu));
  if (const auto fill = fill_for(in, ratio)) ways.push_back(fmt::format("the fill ratio above {:.3g}", *fill));
  if (in.rest_arc > 0) lower.emplace_back("the rest arc");
  if (in.section_factor > 0) lower.emplace_back("the section factor");
  // at a section factor of 1 nothing else helps
  std::string advice;
  if (!ways.empty()) advice = fmt::format("raise {}", fmt::join(ways, ", or "));
  if (ways.empty() && in.section_factor < 1) advice = "raise friction, wrap and fill ratio together";
  if (!lower.empty()) advice += fmt::format("{}lower {}", advice.empty() ? "" : ", or ", fmt::join(lower, ", or "));
  return fmt::format(
      "no grip: e = exp(mu phi) = {:.4g} does not exceed the idler loss {:.4g}, so the driving sheave can't even "
      "turn the idler; {}",
      grip_ratio(in), in.idler_loss, advice);
}

double reserve_under(double pull, const Input& in, const Output& out) {
  const double T_2 = slack_branch_under(pull, in.cutting_force, in.idler_loss, out.c);
  return reserve_of(in.idler_loss * T_2 + in.cutting_force, T_2, out.e, out.c);
}

bool keeps(double reserve, double m) {
  return make_check("", reserve, si::one, {.sense = Sense::at_least, .limit = m, .rule = "", .trust = ""}).passes;
}
bool holds(double reserve) { return keeps(reserve, 1); }

double cutting_force_under(double pull, const Input& in, const Output& out) {
  const double T_2 = out.c + pull / (out.e + 1);
  const double T_1 = out.c + pull * out.e / (out.e + 1);
  return std::max(0.0, T_1 - in.idler_loss * T_2);
}

double transmissible_force(double pull, double e, double m) { return std::max(0.0, pull) * (e - 1) / (e - 1 + 2 * m); }

double pull_for(double cutting_force, double e, double m) { return cutting_force * (1 + 2 * m / (e - 1)); }

}  // namespace taut::friction_drive
