#pragma once

#include <vector>

#include "taut/machine/description/machine.hpp"
#include "taut/machine/model.hpp"

namespace taut::study {

/// Bodies and carriages that turn freely have inertia: their own, or of masses beside the axis.
void check_inertia(const machine::Machine& machine, const machine::Model& model, std::vector<Complaint>& complaints);

/// No guide has `holds`: in a motion no rope leaves one as its carriage passes.
void check_guides(const machine::Machine& machine, std::vector<Complaint>& complaints);

struct Moves {
  bool rope_mass = true;  ///< ropes have mass
  bool slowly = false;    ///< without inertia
};

/// What else a motion asks of a machine beyond statics, reported at the place in the deck: masses of what shifts freely
/// and of ropes in segments, ropes that stretch, inertia of sheaves that a torque drives and of wheels with several
/// grooves.
void check_masses(const machine::Machine& machine, const machine::Model& model, const Moves& moves,
                  std::vector<Complaint>& complaints);

}  // namespace taut::study
