#include "taut/app/machine_scope.hpp"

#include <algorithm>

namespace taut::app {

std::vector<Complaint> not_computed(const MachineDeck& deck) {
  std::vector<Complaint> all;
  const machine::Machine& m = deck.machine;
  const bool moves =
      !deck.analyses.empty() && std::all_of(deck.analyses.begin(), deck.analyses.end(),
                                            [](const auto& one) { return one.transient || one.pretension; });
  const auto refuse = [&](bool there, const char* what, const char* instead) {
    if (there && !moves) {
      all.push_back(
          {what, std::string("are computed in motion alone (the analyses 'transient' and 'pretension'); ") + instead});
    }
  };
  refuse(!m.contacts.empty(), "machine.contacts", "statics needs a machine without them");
  refuse(!m.actuators.empty(), "machine.actuators", "in statics give the force as a load");
  return all;
}

}  // namespace taut::app
