#pragma once
#include <string>
#include <vector>

#include "taut/app/machine_run.hpp"
#include "taut/app/mast_checks.hpp"

/// `checks: masts:` of a machine: its beams, and masts that the deck gives beside it.
namespace taut::app {

void complain_of_masts(const std::vector<MastCheckRequest>& masts, const MachineDeck& deck, const model::Model& model,
                       std::vector<Complaint>& complaints);
void add_machine_masts(const std::vector<MastCheckRequest>& masts, const MachineDeck& deck, const MachineRun& run,
                       Result& r);

/// A state that was found, and the name of the analysis it belongs to: the deck's, or "equilibrium", "load_path".
struct NamedAnswer {
  Answer answer;
  std::string analysis;
};
std::vector<NamedAnswer> named_answers(const MachineRun& run);

}  // namespace taut::app
