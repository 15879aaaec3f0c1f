#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/calc/field.hpp"
#include "taut/study/requests/analysis_requests.hpp"
#include "taut/study/requests/modes_deck.hpp"
#include "taut/study/requests/motion.hpp"
#include "taut/study/requests/pretension_deck.hpp"
#include "taut/study/requests/transient_deck.hpp"

namespace taut::study {

struct EquilibriumRequest {
  std::optional<std::string> name;  ///< of its tables, when a deck has several
  std::vector<MotionRequest> motion;
  std::optional<std::string> carriage;  ///< put at x, instead of what its mainline or clamp says
  std::optional<double> x;
  std::optional<double> z;             ///< its height too, instead of the length of the rope it rides on
  std::vector<double> along = {1, 0};  ///< direction of x
  bool held = false;                   ///< whatever holds the carriage
  std::optional<GivenRequest> given;
  bool judge = true;  ///< false: its states do not count for the verdict
  static const Description& describe();
};

struct LoadPathRequest {
  std::optional<std::string> name;
  std::string carriage;
  double from = 0;
  double to = 0;
  int steps = 96;
  std::vector<double> along = {1, 0};  ///< direction of from and to
  std::vector<MotionRequest> motion;
  bool held = false;  ///< whatever holds the carriage
  std::optional<GivenRequest> given;
  bool judge = true;  ///< false: its states do not count for the verdict
  static const Description& describe();
};

struct AnalysisRequest {
  std::optional<EquilibriumRequest> equilibrium;
  std::optional<LoadPathRequest> load_path;
  std::optional<PayloadRequest> payload;
  std::optional<InstallationRequest> installation;
  std::optional<CycleRequest> cycle;
  std::optional<EnvelopeRequest> envelope;
  std::optional<SweepRequest> sweep;
  std::optional<TransientRequest> transient;
  std::optional<ModesRequest> modes;
  std::optional<PretensionRequest> pretension;
  static const Description& describe();
};

}  // namespace taut::study
