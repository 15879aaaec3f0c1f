#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "taut/calc/field.hpp"
#include "taut/study/cycle.hpp"
#include "taut/study/envelope.hpp"
#include "taut/study/installation.hpp"
#include "taut/study/least_tension.hpp"
#include "taut/study/load_path.hpp"
#include "taut/study/modes.hpp"
#include "taut/study/payload.hpp"
#include "taut/study/pretension.hpp"
#include "taut/study/states.hpp"
#include "taut/study/sweep.hpp"
#include "taut/study/transient.hpp"

namespace taut::study {

/// One entry of the deck's `analyses`: one of these.
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

/// The highest temperature of the machine in the states that these analyses show to the verdict, K; none where the deck
/// says none.
std::optional<double> hottest_of(const machine::Machine& machine, const std::vector<AnalysisRequest>& analyses);

/// The lowest one, K.
std::optional<double> coldest_of(const machine::Machine& machine, const std::vector<AnalysisRequest>& analyses);

/// Whether every analysis puts another number in the place of this one of the machine, so that it changes nothing: the
/// parameter of a sweep, temperatures, the length or tension of a rope that is `given`. `place`: as of a Parameter.
bool is_set_anew(const machine::Machine& machine, const std::vector<AnalysisRequest>& analyses,
                 const std::string& place);

/// An analysis besides equilibria and load paths, with its names resolved.
using Question = std::variant<PayloadRun, InstallationRun, CycleRun, EnvelopeRun, SweepRun, TransientRun, PretensionRun,
                              LeastTensionRun, ModesRun>;

/// One of a deck's analyses, ready to be answered on the machine with its guys put up.
struct Asked {
  Question question;
  std::string name;     ///< the deck's own, or the kind of the analysis
  bool judged = true;   ///< false: its states do not count for the verdict
  std::string heading;  ///< kind and name, "sweep cold": over its tables in a report
};

/// What all analyses of a deck ask for.
struct AskedAll {
  std::vector<EquilibriumRun> equilibria;
  std::vector<LoadPathRun> paths;
  std::vector<Asked> more;  ///< in the deck's order
};

/// The requests with their names resolved; without any the equilibrium at rest. `must_judge`: a design, whose choices
/// must stand in all states. Complaints below `analyses`.
AskedAll resolve(const std::vector<AnalysisRequest>& analyses, bool must_judge, const machine::Machine& machine,
                 const machine::Model& model, std::vector<Complaint>& complaints);

}  // namespace taut::study
