#pragma once
#include <string>
#include <vector>

#include "taut/calc/sheet.hpp"
#include "taut/methods/boom_ropes/boom_ropes.hpp"
#include "taut/units/display.hpp"

namespace taut::boom_ropes {

/// Constants of the machine behind the branch lengths: the equaliser sits this far behind the rear pads of section 3
/// (m), and this much of the retraction rope is always on section 3's side (m).
inline constexpr double equaliser_distance = 0.30;
inline constexpr double shortest_branch = 0.05;

/// The pretensions of the KS-55713-5K-1 (N), calibrated on Table 2: where the deck gives none.
inline constexpr double calibrated_S10 = 95.5e3;
inline constexpr double calibrated_S20 = 187e3;

/// The pretension with which sections 2 and 3 slide, N: as `sliding` gives it, else as the input does, else calibrated.
double sliding_pretension(const Input& in, const Sliding& q, Rope rope);

/// One position of the grid; indices into the three lists of Sliding.
struct Position {
  std::size_t weight = 0;
  std::size_t angle = 0;
  std::size_t length = 0;
};

/// Falls of the tackle: the deck's, else 8 when lifting (25 t) and 6 otherwise (3 t), as in the paper.
int falls_of(const Sliding& q);

/// Limiting sliding equilibrium of sections 2 and 3 at one position: rope tensions, pad forces, cylinder force.
/// Unknown is X, the elongation of half the extension rope: S1 rises and S2 falls with it, 2 S1 - S2 is therefore
/// strictly rising while a rope is taut, and pad friction bends the balance only through the rope offsets. It is
/// piecewise linear, so every root is found; with 2 f max(|z_1|, |z_2|) < a there is exactly one. None, several, or one
/// at which more pull means less sliding is a jam: infeasible, with the reason. Likewise for F_h, sure with 2 f |z_c| <
/// A.
template <class T>
Outcome slide(const Input& in, const Sliding& q, const Position& at, Sheet<T>& s, SlidingPoint& out);

/// slide() in double over the whole grid, then once more over `T` where |F_h| is largest.
template <class T>
Outcome compute_sliding(const Input& in, const Sliding& q, Sheet<T>& s, Output& out);

/// "21 m, 30 deg, 12 kN": length and angle of the boom, and what hangs on it.
std::string place(const SlidingPoint& p, const Display& display);

}  // namespace taut::boom_ropes
