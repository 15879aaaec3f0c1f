#pragma once
#include "taut/methods/closed_loop/case.hpp"

namespace taut::closed_loop {

/// What the paper's formulas give, repaired where the print is wrong (see about().errata). N.
template <class T>
struct Paper {
  T P;              ///< (3) oblique vertical part of S, with the carriage's weight
  T K;              ///< (2) part of S along the chord
  T P_b;            ///< (1)
  T P_b_no_weight;  ///< first term of (1); (4) at midspan
  T T_b;            ///< (5) or (11), oblique: H/cos(alpha)
  T T_n;            ///< (6) repaired, oblique
  T T_up;           ///< (7), at the upper support of the upper branch
  T T_lA;           ///< (9), at A in the lower branch
};

/// (2) and (3). P <= 0 is for the caller to refuse.
template <class T>
void resolve_force(const Case<T>& c, Sheet<T>& s, Paper<T>& p);

/// (1), and (5) or (11), (6), (7), (9) at midspan; elsewhere the same with the reactions of any x.
template <class T>
void paper_tensions(const Case<T>& c, Sheet<T>& s, Paper<T>& p);

/// The formulas as they stand in print, at midspan, for the comparison only.
struct Printed {
  double P_b_4 = 0;  ///< (4) with - 2l
  double T_n = 0;    ///< (6) with S cos(gamma)/cos(alpha) and T_b
  double T_lA = 0;   ///< (9) without the factor 4
};
Printed as_printed(const Case<double>& c, const Paper<double>& p);

}  // namespace taut::closed_loop
