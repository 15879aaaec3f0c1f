#pragma once
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "taut/results/machine_run.hpp"
#include "taut/study/requests/machine_analyses.hpp"

namespace taut::results {

/// What an analysis needs while its names are resolved. The deck and the model outlive what is prepared with them.
struct Preparation {
  const machine::Machine& machine;
  const std::vector<study::AnalysisRequest>& analyses;  ///< of the deck
  const machine::Model& model;                          ///< as compiled: guys by their tension
  std::vector<Complaint>& complaints;
  std::vector<std::pair<std::string, std::string>> endings;  ///< kind and ending of the analyses before
};

/// The carriage of that name, -1 with a complaint at `path` where there is none.
int carriage_of(Preparation& p, const std::string& name, const std::string& path);
/// The same for a reeving; a guy is one.
int reeving_of(Preparation& p, const std::string& name, const std::string& path);
/// A carriage that is held at x, where the deck says both; complains of one without the other, and of a place on a
/// support.
std::optional<machine::Prescribed> prescribed_of(const std::optional<std::string>& carriage,
                                                 const std::optional<double>& x, const std::vector<double>& along,
                                                 const std::string& path, Preparation& p);
/// What an analysis has given in place of what a rope has, where `carriage` is put somewhere (-1: none is).
solve::Condition condition_of(const study::GivenRequest& request, int carriage, const std::string& path,
                              Preparation& p);
/// Ending of the tables' names of an analysis of this kind: the deck's own, or the number from the second on.
std::string ending_of(Preparation& p, const std::string& kind, const std::optional<std::string>& name,
                      const std::string& path);

/// The analyses of a deck besides equilibria and load paths, each ready to run on the machine with its guys put up;
/// each adds its tables, values, figures, checks and warnings. Complaints at paths below `path`.
Analysis prepare_payload(const study::PayloadRequest& request, const std::string& path, Preparation& p);
Analysis prepare_installation(const study::InstallationRequest& request, const std::string& path, Preparation& p);
Analysis prepare_cycle(const study::CycleRequest& request, const std::string& path, Preparation& p);
Analysis prepare_envelope(const study::EnvelopeRequest& request, const std::string& path, Preparation& p);
Analysis prepare_sweep(const study::SweepRequest& request, const std::string& path, Preparation& p);

/// Puts up the guys that have a tension: on the machine with its bodies held and nothing but the guys; each of them
/// then keeps its length.
Outcome install_guys(const machine::Machine& machine, machine::Model& model);

Analysis prepare_transient(const study::TransientRequest& request, const std::string& path, Preparation& p);
Analysis prepare_pretension(const study::PretensionRequest& request, const std::string& path, Preparation& p);
/// Its part `least`.
Analysis prepare_least_tension(const study::PretensionRequest& request, const std::string& path,
                               const std::string& ending, Preparation& p);
Analysis prepare_modes(const study::ModesRequest& request, const std::string& path, Preparation& p);

/// Notes the first failure of a calculation in the result: its status, and `what` before its message.
void note_failure(Result& r, const Outcome& outcome, const std::string& what);

}  // namespace taut::results
