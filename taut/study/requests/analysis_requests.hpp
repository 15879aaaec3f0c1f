#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/calc/field.hpp"
#include "taut/study/requests/motion.hpp"

/// What a deck may ask of a machine besides equilibria and load paths: the maps below `analyses`.
namespace taut::study {

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
  bool judge = true;    ///< false: its states do not count for the verdict
  bool held = false;    ///< whatever holds the carriage
  static const Description& describe();
};

/// A rope's end.
enum class RopeEnd { start, end };

/// What is asked in place of what one rope has given.
struct GivenRequest {
  std::string reeving;
  std::optional<double> winch_pull;   ///< N
  std::optional<double> loop_length;  ///< m
  std::optional<double> sag;          ///< m
  bool free_running = false;
  std::vector<std::string> of;       ///< ropes whose pull or length it is, in place of that one's
  std::optional<double> efficiency;  ///< of the lead from the winch to the rope's end
  RopeEnd at = RopeEnd::start;       ///< where the winch is
  std::optional<int> span;           ///< of a sag, from 1
  static const Description& describe();
};

struct InstallationGivenRequest {
  std::optional<double> tension;      ///< N
  RopeEnd at = RopeEnd::start;        ///< of a tension
  std::optional<double> length;       ///< m
  std::optional<double> sag;          ///< m
  std::optional<int> span;            ///< of a sag, from 1
  std::optional<double> temperature;  ///< K: where it holds; the length is kept from there
  static const Description& describe();
};

struct InstallationRequest {
  std::optional<std::string> name;
  std::string reeving;
  std::vector<double> temperatures;  ///< K
  std::optional<double> from, to;    ///< K
  std::optional<int> steps;
  std::optional<InstallationGivenRequest> given;
  bool judge = true;  ///< false: its states do not count for the verdict
  static const Description& describe();
};

struct PhaseRequest {
  std::string name;
  std::vector<MotionRequest> motion;
  double load = 0;  ///< kg on the carriage
  std::optional<double> from, to;
  std::optional<double> speed;  ///< of the carriage, m/s
  static const Description& describe();
};

struct CycleRequest {
  std::optional<std::string> name;
  std::string carriage;
  double from = 0, to = 0;
  int steps = 48;
  std::vector<double> along = {1, 0};  ///< direction of from and to
  std::optional<double> speed;
  std::vector<PhaseRequest> phases;
  bool judge = true;  ///< false: its states do not count for the verdict
  bool held = false;  ///< whatever holds the carriage
  static const Description& describe();
};

struct EnvelopeRequest {
  std::optional<std::string> name;
  std::optional<std::string> carriage;
  std::optional<double> from, to;
  int steps = 48;
  std::vector<double> along = {1, 0};  ///< direction of from and to
  std::optional<std::string> load_at;  ///< a body or carriage
  std::vector<double> loads;           ///< kg
  std::vector<std::string> motions;
  std::vector<double> temperatures;  ///< K
  bool judge = true;                 ///< false: its states do not count for the verdict
  bool held = false;                 ///< whatever holds the carriage
  static const Description& describe();
};

struct SweepRequest {
  std::optional<std::string> name;
  std::string parameter;
  std::string from, to;  ///< with the parameter's unit
  int steps = 20;
  std::vector<MotionRequest> motion;
  std::optional<std::string> carriage;
  std::optional<double> x;
  std::vector<double> along = {1, 0};  ///< direction of x
  bool judge = true;                   ///< false: its states do not count for the verdict
  bool held = false;                   ///< whatever holds the carriage
  static const Description& describe();
};

}  // namespace taut::study
