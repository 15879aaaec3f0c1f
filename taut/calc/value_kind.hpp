#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "taut/calc/quantity.hpp"

namespace taut {

/// A value that a calculation answers with under a name of its own, described once: the value itself, `taut explain`
/// and the reference follow from it. In its name a word in capitals, or N, stands for a name of the deck or a number.
struct ValueKind {
  QuantityWords about;  ///< "payload_min", "ROPE.base_tension", "frequency_N"; its unit where the deck does not set it
  std::string of;       ///< what has it: "analysis `payload`"
  std::string page;     ///< below docs/, where its law or its use stands: "theory/payload.md"
};

/// The one of that name; throws where there is none.
const ValueKind& named(const std::vector<ValueKind>& kinds, std::string_view name);

/// The name with `part` in place of its word in capitals: "skyline.base_tension".
std::string name_with(std::string_view name, std::string_view part);

/// The value of this kind. `ending`: of the analysis, behind the name. `label`: what it is and where it holds.
Value make_value(const ValueKind& kind, const std::string& part, const std::string& ending, double x,
                 const std::string& label);

/// Kinds made of quantities, all with the same place and page.
std::vector<ValueKind> kinds_of(const std::vector<QuantityWords>& words, const std::string& of,
                                const std::string& page);

}  // namespace taut
