#include "taut/checks/drive/cylinders.hpp"

#include <fmt/format.h>

#include <cmath>

#include "taut/calc/shown.hpp"

namespace taut::checks {
namespace {

constexpr double rounding_of_force = 1e-9;  ///< relative

/// At its force limit it no longer does what its speed, force or law asks of it.
std::string force_limit_words(const machine::Actuator& law, double F, const CylinderMoment& moment) {
  if (!std::isfinite(law.force_limit)) return "";
  const double bears = std::abs(F);
  if (bears < (1 - rounding_of_force) * law.force_limit) return "";
  if (bears <= (1 + rounding_of_force) * law.force_limit) {
    return fmt::format("{}: '{}' is at its force limit of {}: it gives way to its load", moment.words, law.name,
                       moment.display.brief(law.force_limit, si::N));
  }
  const auto [force, limit] = brief_apart(bears, law.force_limit, si::N, moment.display);
  return fmt::format("{}: '{}' bears {}, more than its force limit of {}: it is locked", moment.words, law.name, force,
                     limit);
}

/// A slow motion lets a cylinder with a law F0 + gain (v_ref - v) follow its reference speed, whatever that takes. With
/// more force against it than the law gives at a standstill it would go the other way.
std::string law_words(const machine::Actuator& law, const solve::TransientFrame::Actuator& is, double t,
                      const CylinderMoment& moment) {
  if (!moment.slowly || law.kind != machine::ActuatorKind::law || is.speed == 0) return "";
  const double gives = law.gain * std::abs(machine::at(law.signal, t).value) + (is.speed > 0 ? law.F0 : 0);
  const double bears = is.speed > 0 ? is.F : -is.F;
  if (bears <= gives + rounding_of_force * std::abs(gives)) return "";
  const auto [force, limit] = brief_apart(bears, gives, si::N, moment.display);
  return fmt::format(
      "{}: '{}' bears {}, more than its law gives at a standstill, {}: it would be pushed back, but a quasi_static "
      "motion lets it follow its reference speed",
      moment.words, law.name, force, limit);
}

}  // namespace

void take_cylinders(const machine::Model& model, const solve::TransientFrame& frame, const CylinderMoment& moment,
                    std::map<Part, std::string>& told) {
  for (std::size_t i = 0; i < frame.actuators.size(); ++i) {
    const machine::Actuator& law = model.actuators[i];
    for (const std::string& words :
         {force_limit_words(law, frame.actuators[i].F, moment), law_words(law, frame.actuators[i], frame.t, moment)}) {
      if (!words.empty()) told.try_emplace({.kind = PartKind::cylinder, .name = law.name}, words);
    }
  }
}

}  // namespace taut::checks
