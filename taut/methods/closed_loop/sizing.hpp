#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "taut/base/gravity.hpp"
#include "taut/catalogue/rope.hpp"
#include "taut/methods/closed_loop/paper.hpp"

namespace taut::closed_loop {

/// The metallic areas (8), (10) and their corrected forms, m2, for the load at midspan and the sag c.f there.
/// Infeasible: at that sag no rope carries its own weight with the safety factor, or the upper branch takes no load.
template <class T>
Outcome areas(const Input& in, const Case<T>& c, const Paper<T>& p, Sheet<T>& s, Output& out);

/// The two ropes: weights in N/m, and the catalogue's rows where the deck names or chooses them.
struct Ropes {
  double q_b = 0;
  double q_T = 0;
  std::optional<catalogue::RopeRow> return_rope;
  std::optional<catalogue::RopeRow> traction_rope;
};

/// Largest tensions of the two ropes over the whole deck with given weights; where they stand.
struct Peak {
  double tension = 0;  ///< N
  double x = 0;        ///< position of the carriage, m
  std::string where;   ///< "lower branch at B"
};
/// "lower branch at B, carriage at 60 m".
std::string place_of(const Peak& peak, const Display& display);
/// The deepest sag at the carriage, of each section where it has two; 0: none is known.
struct Deepest {
  double sag = 0;     ///< m
  double x = 0;       ///< position of the carriage, m
  std::string where;  ///< ", hauled out"; empty: as the deck has it
};
/// Positions of the carriage (m) that have no answer while the loop is hauled the other way than its deck says.
struct OtherHaul {
  Haul haul = Haul::out;
  std::vector<double> without_answer;
  std::string reason;  ///< of the first of them
};
struct Peaks {
  Peak return_rope;
  Peak traction_rope;
  Deepest deepest;
  OtherHaul other;
};

/// The larger peaks of the two, each rope by itself, and the deeper sag; nothing of the other haul.
Peaks larger(const Peaks& a, const Peaks& b);

/// The largest tensions of one solved position: exact, or by the closed-form tier where there is no engine.
Peaks peaks_of(const Output& out);
/// By the closed-form tier.
Peaks closed_form_peaks_of(const Output& out);

/// One position of a sweep.
struct Row {
  Outcome outcome;
  Output out;
};

/// The ropes of a deck and its positions with them, each computed once.
struct Solved {
  Ropes ropes;
  std::vector<Row> rows;       ///< in the order of the deck; midspan when it gives none
  std::optional<Peaks> peaks;  ///< of both hauls; none: nobody has asked yet
};

/// The smallest ropes of the catalogue (by diameter, then area and breaking force) that keep MBF/T >= n with their own
/// weights at every position. `verify` computes positions and peaks for the ropes in it. The search steps each rope up
/// until both pass, because each rope's weight raises both tensions. Infeasible: the filter or the catalogue has no
/// such rope, or the deck itself is infeasible.
Outcome choose(const RopeFilter& filter, double n, const std::function<Outcome(Solved&)>& verify, Solved& chosen,
               const Display* display = nullptr);

}  // namespace taut::closed_loop
