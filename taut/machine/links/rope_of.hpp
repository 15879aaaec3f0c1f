#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/catalogue/modulus.hpp"
#include "taut/machine/description/machine.hpp"

namespace taut::machine {

/// What the engine needs of a rope, from the catalogue's row and the deck's own figures.
struct RopeData {
  std::string name;
  double mass = 0;            ///< kg/m
  double stiffness = 0;       ///< EA, N
  double breaking_force = 0;  ///< N; 0: not known
  double diameter = 0;        ///< m; 0: not known
  double thermal_strain = 0;  ///< at the machine's temperature
  double damping_ratio = 0, damping_time = 0;
};

/// What the stiffness of a rope rests on that the deck leaves to the catalogue; nothing where the deck gives it.
std::optional<catalogue::RopeStiffness> catalogue_stiffness(const description::Rope& rope);

/// Complains at "ropes.NAME" of a rope that the catalogue lacks, or whose mass or stiffness nobody says.
Array<RopeData> ropes_of(const Machine& machine, std::vector<Complaint>& complaints);

}  // namespace taut::machine
