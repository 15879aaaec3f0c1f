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
  RopeState skyline_is = RopeState::hauled_in, mainline_is = RopeState::hauled_in;
  BlockForce skyline = {}, mainline = {};
  double lateral = 0;   ///< across the span at the skyline block, N: not in the method
  bool put_up = false;  ///< no rope pulls and no force acts from the side: the mast stands with its guys alone
};

/// Whether both ropes are in this state.
bool are(const ClampForces& f, RopeState state);

/// The same with every force of the ropes, and across the span, times `factor`.
ClampForces operator*(double factor, ClampForces f);

/// "ropes hauled in", "ropes at rest", "skyline hauled in, mainline paid out", "guys put up, no load", ...
std::string direction_words(const ClampForces& f);

/// "carriage at 10 m"; empty where the span is not given.
std::string position_words(const Input& in, const ClampForces& f);
/// "carriage at 10 m, ropes paid out"; with ", no side force" where the deck has one that is left out.
std::string case_words(const Input& in, const ClampForces& f);

/// What a section must carry: at every carriage position that the method can do (`positions`: all of the deck) each
/// rope hauled in, paid out and at rest, by the wrap as asked for and, where that is the paper's, by the geometric one
/// as well. A mast with guys may be held by what loads it: it has each rope alone, the other one slack, all that
/// without the side force too, and last its guys alone. Empty: no position is feasible.
std::vector<ClampForces> clamp_forces(const Input& in, const std::vector<Position>& positions);

/// What the published method does not know of a mast, from outside; each function may be empty.
struct SecondOrder {
  /// The largest stress anywhere in the mast with the moments of its own deflection, Pa, as it is held against [sigma];
  /// NaN where it finds no equilibrium.
  std::function<double(const catalogue::SectionRow& section, const ClampForces& forces)> stress = {};
  /// The factor of its axial force at which the straight mast buckles; NaN: none is known.
  std::function<double(const catalogue::SectionRow& section, const ClampForces& forces)> buckling = {};
  double least_buckling = 0;  ///< what that factor must be of a section that is chosen
  /// Whether its walls yield (at `yield`, Pa: the largest that it may have) before they buckle.
  std::function<bool(const catalogue::SectionRow& section, double yield, const ClampForces& forces)> wall_yields = {};
  /// Without solving: false where the mast surely buckles below `least_buckling` times its axial force.
  std::function<bool(const catalogue::SectionRow& section, const ClampForces& forces)> may_stand = {};
  /// The mast is another than the method's, with guys, a side force or a hinge: the method's own stress says nothing.
  bool decides_alone = false;
};

/// A catalogue section under the worst of several clamp forces.
struct Assessment {
  catalogue::SectionRow section;
  double stress = 0;     ///< N/A + M/W_el about the strong axis, Pa
  double allowable = 0;  ///< at its wall, Pa
  ClampForces worst;
  std::optional<double> second_order;  ///< Pa, the worst; NaN: no equilibrium
  ClampForces second_order_worst = {};
  bool only_second_order = false;  ///< the stress of first order is that of another mast
  double buckling = not_computed;  ///< the least factor of any force; NaN: not asked for
  double least_buckling = 0;       ///< what it must be
  bool wall_yields = true;         ///< before it buckles, under each force
  bool passes() const;
  /// The larger stress over the allowable one. NaN where it finds no equilibrium.
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

/// The largest yield stress that the section may have, Pa: that of the steel; with a given [sigma] the largest of the
/// catalogue of which such sections are made, and no less than `allowable`.
double largest_yield(const StressLimit& limit, const catalogue::SectionRow& section, double allowable);

/// The trust of the limit: the steel's, or "user" for a given [sigma].
std::string trust_of(const StressLimit& limit);

/// The section under each of `forces` (at least one); nothing when its steel is not made so thick.
std::optional<Assessment> assess(const StressLimit& limit, const catalogue::SectionRow& section,
                                 const std::vector<ClampForces>& forces, const SecondOrder& second = {});

/// Whether such a section is made of that steel: hot-finished sections of EN 10210 are not of cold-formed steel of EN
/// 10219, nor the other way round.
bool is_made_of(const catalogue::SectionRow& section, const catalogue::SteelRow& steel);

/// What `choose_section` lets through, of one shape and made of the deck's steel, lightest first.
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

/// The section of a shape that comes nearest to passing, for when none passes: by first order, or where second order
/// decides alone by that under the worst force of first order.
std::optional<Assessment> strongest(const Input& in, catalogue::SectionShape shape,
                                    const std::vector<ClampForces>& forces, const SecondOrder& second = {});

}  // namespace taut::mast_section
