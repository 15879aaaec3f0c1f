#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/app/motion.hpp"
#include "taut/calc/field.hpp"

/// What a deck may ask of a machine besides equilibria and load paths: the maps below `analyses`.
namespace taut::app {

/// Limits of one rope, or of the pull of one drum, by its name.
struct RopeLimitRequest {
  std::string name;
  std::optional<double> tension;        ///< N
  std::optional<double> safety_factor;  ///< breaking force over tension
  std::optional<std::string> rule;      ///< id of a rule of the catalogue, a safety factor
  std::optional<double> clearance;      ///< of the rope over the ground, m
  std::optional<double> pull;           ///< of a drum, N
  static const Description& describe();
};

struct LimitsRequest {
  std::vector<RopeLimitRequest> named;
  std::optional<double> clearance;       ///< of the carriage over the ground, m
  std::optional<double> rope_clearance;  ///< of the rope that it rides on, m
  std::optional<double> break_angle;     ///< rad
  std::optional<double> least_break_angle;
  bool lift_off = false;
  static const Description& describe();
};

struct PayloadRequest {
  std::optional<std::string> name;
  std::string carriage;
  double from = 0;
  double to = 0;
  int steps = 48;
  std::vector<double> along = {1, 0};  ///< direction of from and to
  std::vector<MotionRequest> motion;
  LimitsRequest limits;
  double most = 100e3;  ///< kg
  static const Description& describe();
};

}  // namespace taut::app
