#pragma once
#include <optional>
#include <string>

#include "taut/calc/field.hpp"
#include "taut/catalogue/section.hpp"
#include "taut/catalogue/trust.hpp"

namespace taut::catalogue {
struct SectionFilter;
}

namespace taut::checks {

/// Which sections of the catalogue may be chosen, for a beam of a design or for a mast that is checked.
struct SectionChoice {
  std::optional<catalogue::SectionShape> shape;
  std::optional<catalogue::Forming> forming;
  std::optional<std::string> standard;                          ///< the beginning of its name
  std::optional<double> least_height, most_height;              ///< m, outer
  catalogue::Trust least_trust = catalogue::Trust::unverified;  ///< of its properties, the worst allowed
  static const Description& describe();
};

catalogue::SectionFilter filter_of(const SectionChoice& choice);

}  // namespace taut::checks
