#pragma once
#include <string>
#include <vector>

#include "taut/calc/quantity.hpp"
#include "taut/checks/check_state.hpp"
#include "taut/checks/guy/guy_checks.hpp"
#include "taut/checks/yarder/yarder_checks_deck.hpp"

/// `checks: yarders:` of a machine: needed against available length, pull against rated pull.
namespace taut::checks {

/// One line of a yarder over all states that were shown.
struct YarderLineStates {
  const YarderCheckRequest* request = nullptr;
  YarderLineRequest line;
  int reeving = 0;
  double diameter = 0;   ///< of its rope, m
  int copies = 1;        ///< of it, all on the drum; lengths and tensions are of all of them
  LineExtreme in_use;    ///< unstretched length between its ends, m
  LineExtreme tension;   ///< at its end on the drum, else the larger one of both ends, N
  LineExtreme put_up;    ///< the same while it is put up
  Display display = {};  ///< units of the sentences
};
std::vector<YarderLineStates> yarder_states(const std::vector<YarderCheckRequest>& yarders,
                                            const machine::Model& model);
void take(const CheckState& state, YarderLineStates& line);
/// An empty line in a model of its own. `put_up`: its winch gives it the tension.
void take_empty_line(const CheckState& state, const std::string& reeving, bool put_up, YarderLineStates& line);

/// Rope of that diameter (m) that a drum takes, m: by its measures the layers within the flanges, else its capacity
/// times the square of the ratio of the diameters.
double available_length(const catalogue::YarderDrum& drum, double diameter);

void complain_of_yarders(const std::vector<YarderCheckRequest>& yarders, const machine::Model& model,
                         std::vector<Complaint>& complaints);
/// The table `yarder_lines`, and the checks of length and pull of each line.
void add_yarder_checks(const std::vector<YarderLineStates>& lines, Result& r);
/// The table `yarder_lines` as described.
TableWords yarder_words();

}  // namespace taut::checks
