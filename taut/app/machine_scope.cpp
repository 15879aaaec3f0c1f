#include "taut/app/machine_scope.hpp"

namespace taut::app {

std::vector<Complaint> not_computed(const MachineDeck& deck) {
  std::vector<Complaint> all;
  const model::Machine& m = deck.machine;
  if (!m.contacts.empty()) all.push_back({"machine.contacts", "are not computed yet; leave them away"});
  if (!m.actuators.empty()) all.push_back({"machine.actuators", "are not computed yet; give the force as a load"});
  return all;
}

}  // namespace taut::app
