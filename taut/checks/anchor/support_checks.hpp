#pragma once
#include <string>
#include <vector>

#include "taut/calc/quantity.hpp"
#include "taut/checks/anchor/support_checks_deck.hpp"
#include "taut/checks/check_state.hpp"

/// `checks: supports:` of a machine: trees that carry a line.
namespace taut::checks {

/// A support tree over all states that were shown.
struct SupportStates {
  const SupportCheckRequest* request = nullptr;
  double force = 0;                ///< the largest of all ropes together, with the dynamic factor, N
  Vector3 pull = Vector3::Zero();  ///< there, without the factor, N
  double factor = 1;
  double height = 0;  ///< of the saddle over the ground, along its trunk, m; NaN: no terrain there
  std::string where;
  std::string upwards;    ///< the first state in which the ropes pull it upwards; empty: in none
  std::string sideways;   ///< the first state in which they pull it more sideways than along its trunk; empty: in none
  double trunk_lean = 0;  ///< in that state, from the vertical, rad
  Display display = {};   ///< units of the sentences
};
std::vector<SupportStates> support_states(const std::vector<SupportCheckRequest>& supports);
void take(const CheckState& state, SupportStates& support);

void complain_of_supports(const std::vector<SupportCheckRequest>& supports, const machine::Model& model,
                          std::vector<Complaint>& complaints);
/// The table `support_forces`, the diameter needed as a value, and the check of the tree that is there.
void add_support_checks(const std::vector<SupportStates>& supports, Result& r);
/// The table `support_forces` as described.
TableWords support_words();

}  // namespace taut::checks
