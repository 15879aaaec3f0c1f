#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "taut/methods/mast_section/mast_section.hpp"

namespace taut::mast_section {

/// The limits of the branch angle, rad: -60 and 85 degrees.
extern const double least_branch_angle;
extern const double largest_branch_angle;

/// What a rope does. Hauled in, the friction of the block lessens its span side; paid out, its drum side. At rest the
/// drum side may have anything between: the most that both sides can have at once counts.
enum class RopeState { hauled_in, paid_out, at_rest, slack };

/// How many carriage positions there are; 1 when the branch angle is given.
std::size_t position_count(const Input& in);

/// [sigma] in Pa: as given, or yield of the steel's thinnest range over the safety.
double allowable_stress(const Input& in);

/// Equations (1)-(16) at one carriage position; `index` counts span.carriage_position and is not looked at when the
/// branch angle is given. Infeasible when the branch angle leaves its range. Instantiated for double and Num.
template <class T>
Outcome compute_at(const Input& in, std::size_t index, Sheet<T>& s, Output& out);

/// One carriage position of a sweep.
struct Position {
  std::size_t index = 0;
  Output out;
  Outcome outcome;
};

/// Every carriage position, in the order of the deck.
std::vector<Position> sweep(const Input& in);

/// The sizes that a position may govern, each with the numbers that go with it.
inline constexpr std::array sizes{&Output::D_tube,        &Output::b_square,     &Output::B_hollow,
                                  &Output::D_tube_payout, &Output::D_tube_mixed, &Output::D_tube_rest};

/// The outer diameter of the tube for whatever the ropes do, m: the largest of those that are known.
double worst_tube(const Output& out);

/// For each of `sizes` the position that asks for most; the outcome is that of the last position when none is feasible.
struct Governing {
  std::array<std::size_t, sizes.size()> of{};
  Outcome outcome;
};
Governing governing_of(const std::vector<Position>& positions);

/// The equations at the positions that govern, of several; of none that is feasible those of the first, up to where it
/// fails. Instantiated for double and Num.
template <class T>
Outcome compute_governing(const Input& in, const Governing& governing, Sheet<T>& s, Output& out);

}  // namespace taut::mast_section
