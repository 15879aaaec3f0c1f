#pragma once
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "taut/app/machine_run.hpp"

namespace taut::app {

/// What an analysis needs while its names are resolved. The deck and the model outlive what is prepared with them.
struct Preparation {
  const MachineDeck& deck;
  const model::Model& model;  ///< as compiled: guys by their tension
  std::vector<Complaint>& complaints;
  std::vector<std::pair<std::string, std::string>> endings;  ///< kind and ending of the analyses before
};

/// The carriage of that name, -1 with a complaint at `path` where there is none.
int carriage_of(Preparation& p, const std::string& name, const std::string& path);
/// The same for a reeving; a guy is one.
int reeving_of(Preparation& p, const std::string& name, const std::string& path);
/// Ending of the tables' names of an analysis of this kind: the deck's own, or the number from the second on.
std::string ending_of(Preparation& p, const std::string& kind, const std::optional<std::string>& name,
                      const std::string& path);

/// The analyses of a deck besides equilibria and load paths, each ready to run on the machine with its guys put up;
/// each adds its tables, values, figures, checks and warnings. Complaints at paths below `path`.
Analysis prepare_payload(const PayloadRequest& request, const std::string& path, Preparation& p);

/// Notes the first failure of a calculation in the result: its status, and `what` before its message.
void note_failure(Result& r, const Outcome& outcome, const std::string& what);

}  // namespace taut::app
