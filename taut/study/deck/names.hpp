#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "taut/machine/description/machine.hpp"
#include "taut/machine/model.hpp"
#include "taut/machine/prescribed.hpp"

namespace taut::study {

/// What an analysis needs while the names in its request are resolved. The machine and the model outlive what is
/// resolved with them.
struct Names {
  const machine::Machine& machine;
  const machine::Model& model;  ///< as compiled: guys by their tension
  std::vector<Complaint>& complaints;
  bool has_envelope = false;  ///< whether the deck has the analysis `envelope`, besides others
  std::vector<std::pair<std::string, std::string>> endings = {};  ///< kind and ending of the analyses before
};

/// The carriage of that name; a complaint at `path` where there is none.
std::optional<int> carriage_of(Names& names, const std::string& name, const DeckPlace& path);
/// The same for a reeving; a guy is one.
std::optional<int> reeving_of(Names& names, const std::string& name, const DeckPlace& path);
/// A carriage that is put at x, where the deck says both; complains of one without the other, and of a place on a
/// support.
std::optional<machine::Prescribed> prescribed_of(const std::optional<std::string>& carriage,
                                                 const std::optional<double>& x, const std::vector<double>& along,
                                                 const DeckPlace& path, Names& names);
/// Ending of the tables' names of an analysis of this kind: the deck's own, or the number from the second on.
std::string ending_of(Names& names, const std::string& kind, const std::optional<std::string>& name,
                      const DeckPlace& path);

}  // namespace taut::study
