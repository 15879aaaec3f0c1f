#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "taut/catalogue/section_search.hpp"
#include "taut/catalogue/steel.hpp"
#include "taut/methods/mast_section/mast_section.hpp"

namespace taut::mast_section {

/// Forces at the clamp of one carriage position, N and N m.
struct ClampForces {
  double N = 0;
  double M = 0;
  std::size_t index = 0;  ///< of the carriage position
};

/// A catalogue section under the worst of several clamp forces.
struct Assessment {
  catalogue::SectionRow section;
  double stress = 0;     ///< N/A + M/W_el about the strong axis, Pa
  double allowable = 0;  ///< at its wall, Pa
  ClampForces worst;
  bool passes() const { return stress <= allowable; }
  double utilisation() const { return stress / allowable; }
};

/// What limits the stress: [sigma] as given, or a steel over its safety.
struct StressLimit {
  std::optional<double> given;               ///< Pa
  std::optional<catalogue::SteelRow> steel;  ///< else
  double safety = 1;
};
StressLimit limit_of(const Input& in);

/// [sigma] for a wall of that thickness (m), Pa; nothing when the steel is not made so thick.
std::optional<double> allowable_stress(const StressLimit& limit, double thickness);

/// The trust of the limit: the steel's, or "user" for a given [sigma].
std::string trust_of(const StressLimit& limit);

/// The section under each of `forces` (at least one); nothing when its steel is not made so thick.
std::optional<Assessment> assess(const StressLimit& limit, const catalogue::SectionRow& section,
                                 const std::vector<ClampForces>& forces);

/// What `choose_section` lets through, of one shape, lightest first.
std::vector<catalogue::SectionRow> candidates(const Input& in, catalogue::SectionShape shape);

/// The shapes that `choose_section` lets through.
std::vector<catalogue::SectionShape> shapes_of(const Input& in);

/// The lightest section of a shape that passes under all `forces`; nothing when none does.
std::optional<Assessment> lightest(const Input& in, catalogue::SectionShape shape,
                                   const std::vector<ClampForces>& forces);

/// The section that is given, or else the lightest of all shapes that passes; nothing when none does.
std::optional<Assessment> section_in_use(const Input& in, const std::vector<ClampForces>& forces);

/// The section of a shape that comes nearest to passing, for the message when none passes.
std::optional<Assessment> strongest(const Input& in, catalogue::SectionShape shape,
                                    const std::vector<ClampForces>& forces);

}  // namespace taut::mast_section
