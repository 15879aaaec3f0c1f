#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "taut/catalogue/section_search.hpp"
#include "taut/catalogue/steel.hpp"
#include "taut/methods/mast_section/position.hpp"

namespace taut::mast_section {

/// The resultant of a rope on its block, N.
struct BlockForce {
  double across = 0;  ///< towards the span
  double down = 0;
};

/// Forces at the clamp of one carriage position, N and N m, and the forces on the blocks that make them.
struct ClampForces {
  double N = 0;
  double M = 0;
  std::size_t index = 0;  ///< of the carriage position
  bool paid_out = false;  ///< the ropes run out under load, else they are hauled in
  BlockForce skyline = {}, mainline = {};
};

/// What a section must carry: at every carriage position that the method can do (`positions`: all of the deck) the
/// ropes hauled in and paid out, by the wrap as asked for and, where that is the paper's, by the geometric one as well.
/// Empty: no position is feasible.
std::vector<ClampForces> clamp_forces(const Input& in, const std::vector<Position>& positions);

/// The largest stress anywhere in a clamped mast of that section with the moments of its own deflection, Pa; NaN where
/// it finds no equilibrium. From outside: the published method does not know how.
using SecondOrder = std::function<double(const catalogue::SectionRow& section, const ClampForces& forces)>;

/// A catalogue section under the worst of several clamp forces.
struct Assessment {
  catalogue::SectionRow section;
  double stress = 0;     ///< N/A + M/W_el about the strong axis, Pa
  double allowable = 0;  ///< at its wall, Pa
  ClampForces worst;
  std::optional<double> second_order;  ///< Pa, the worst; NaN: no equilibrium
  ClampForces second_order_worst = {};
  bool passes() const { return stress <= allowable && (!second_order || *second_order <= allowable); }
  /// NaN where it finds no equilibrium.
  double utilisation() const;
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
                                 const std::vector<ClampForces>& forces, const SecondOrder& second = {});

/// What `choose_section` lets through, of one shape, lightest first.
std::vector<catalogue::SectionRow> candidates(const Input& in, catalogue::SectionShape shape);

/// The shapes that `choose_section` lets through.
std::vector<catalogue::SectionShape> shapes_of(const Input& in);

/// The lightest section of a shape that passes under all `forces`; nothing when none does.
std::optional<Assessment> lightest(const Input& in, catalogue::SectionShape shape,
                                   const std::vector<ClampForces>& forces, const SecondOrder& second = {});

/// The section that is given, or else the lightest of all shapes that passes, or else the nearest to passing; nothing
/// when none may be chosen.
std::optional<Assessment> section_in_use(const Input& in, const std::vector<ClampForces>& forces,
                                         const SecondOrder& second = {});

/// The section of a shape that comes nearest to passing by first order, for when none passes.
std::optional<Assessment> strongest(const Input& in, catalogue::SectionShape shape,
                                    const std::vector<ClampForces>& forces, const SecondOrder& second = {});

}  // namespace taut::mast_section
