#pragma once
#include <optional>
#include <string>

#include "taut/catalogue/rope.hpp"
#include "taut/catalogue/rule.hpp"

namespace taut::catalogue {

/// EA of a rope of the catalogue: its metallic area times a modulus by its construction.
struct RopeStiffness {
  double EA = 0;                    ///< N
  double area = 0;                  ///< metallic, m2
  double modulus = 0;               ///< middle of the rule's range, Pa
  double low = 0, high = 0;         ///< the rule's range, Pa
  std::string rule;                 ///< "modulus.6_strand_iwrc"
  std::string rope;                 ///< "6x36-IWRC"
  Trust trust = Trust::unverified;  ///< the weaker of area and modulus
};

/// The rule (data/rules/rope_modulus.csv) for a construction: by the number of its strands, and of 6 and 8 strands by
/// the core, a core of steel strands being as IWRC. Ropes of the planning program's list have its own modulus, which
/// belongs to the area that it takes. Nothing where no rule fits or the core is not known.
std::optional<RuleRow> modulus_rule(const RopeRow& rope);

/// Nothing where no modulus is known.
std::optional<RopeStiffness> stiffness_of(const RopeRow& rope);

/// "EA = 24.8 MN from 184 mm^2 x 107.5 GPa (modulus.6_strand_iwrc, 95 to 120 GPa, UNVERIFIED)".
std::string to_text(const RopeStiffness& stiffness);

}  // namespace taut::catalogue
