#pragma once
#include <optional>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/mechanics/system.hpp"

namespace taut::solve {

/// An end of a rope at which its tension is given: the rope is fed in or taken out there until it has that tension, so
/// that its length follows. A rope that is drawn to the tension of another (machine::Given::equal) is fed at its start.
/// Links first .. last (in the order of the path) take up what is fed in: up to the next
/// clamp, or drive that holds the rope.
struct FedEnd {
  int rope = 0, row = 0;                             ///< index in the layout's ropes; the equation of the given tension
  int first = 0, last = 0;                           ///< branches
  bool at_end = false;                               ///< at the end of the path, else at its start
  double tension = 0;                                ///< N; 0: that of another rope
  int own() const { return at_end ? last : first; }  ///< the branch that ends there
};

/// All of them but those whose equation a prescribed coordinate takes.
Array<FedEnd> fed_ends(const mechanics::System& system);

/// The tensions at the two ends of a branch follow the rope fed into it by this many N/m, the places of its ends kept.
/// Here at its start; at its end it has the same sign, since P differs there by the weight of rope over a fixed height.
double tension_rate(const mechanics::System& system, const mechanics::Configuration& c, const mechanics::Evaluation& e,
                    int branch);

/// A branch of a fed rope that is a deep loop: more rope in it makes it tighter, since its own weight pulls. Between
/// fixed ends the energy U(L) + P L of a rope held at the tension T (P = T + T^2/(2 EA)) has the second derivative
/// -(1 + T/EA) dT/dL; where that is negative the rope runs out, or in, at the least push, so that this second root of
/// the given tension is no answer.
std::optional<int> deep_link(const mechanics::System& system, const Array<FedEnd>& fed,
                             const mechanics::Configuration& c, const mechanics::Evaluation& e);

/// The same of the rope whose length follows from where a carriage is put (its mainline). There a deep loop is no
/// answer where the rope could also be taut, or where it would have to push: then the weight of the loop does. It is
/// one where the pull that the carriage needs is less than a taut rope's weight gives. A branch of it.
std::optional<int> deep_mainline_link(const mechanics::System& system, const mechanics::Configuration& c,
                                      const mechanics::Evaluation& e);

/// The same of the rope whose length follows from the height at which a carriage is put, in the branches between its
/// other nodes: at every tension that a deep loop has there, a taut branch is an answer too.
std::optional<int> deep_link_at_height(const mechanics::System& system, const machine::Carriage& carriage,
                                       const mechanics::Configuration& c, const mechanics::Evaluation& e);

/// Gives every branch of the fed ropes the length that it has without sag at the given tension: the side of their taut
/// root from which it is reached without passing it.
void draw_fed_taut(const mechanics::System& system, const Array<FedEnd>& fed, mechanics::Configuration& c);

}  // namespace taut::solve
