#pragma once
#include <optional>
#include <vector>

#include "taut/catalogue/modulus.hpp"
#include "taut/methods/closed_loop/case.hpp"
#include "taut/methods/closed_loop/engine.hpp"
#include "taut/methods/closed_loop/sizing.hpp"

namespace taut::closed_loop {

/// Everything for one carriage position; with an engine it has an answer only where that has one. `out` keeps what was
/// reached when the outcome is not ok.
template <class T>
Outcome solve_position(const Input& in, const Setting& at, Sheet<T>& s, Output& out);

/// The positions of the deck, midspan when it gives none, each computed in double.
std::vector<Row> sweep(const Input& in, const Ropes& ropes, const Engine& engine = no_engine,
                       const Display* display = nullptr);

/// The row with the largest tension at a rope end (exact with an engine); among equal ones the row with the largest sum
/// of end tensions; the first row when none has an answer.
std::size_t worst_of(const std::vector<Row>& rows);

/// The largest tensions and the deepest sag over all positions with an answer, `rows` as asked for and the same deck
/// hauled the other way; and where that has no answer.
Peaks peaks_of_both_hauls(const Input& in, const Ropes& ropes, const Engine& engine, const std::vector<Row>& rows,
                          const Display* display = nullptr);

/// The stiffness by the catalogue of a rope for which the deck has none (`given` is infinite), in the mode whose sag
/// depends on it: at a given length of the loop. Nothing: the catalogue has none.
std::optional<catalogue::RopeStiffness> own_stiffness(const Input& in, double given,
                                                      const std::optional<catalogue::RopeRow>& rope);

/// The setting of row `index`.
Setting setting_of(const Input& in, const Ropes& ropes, std::size_t index, const Engine& engine = no_engine,
                   const Display* display = nullptr);

/// Weights from the deck, from ropes it names, or from ropes chosen. Precondition: complaints(in) is empty.
Outcome ropes_of(const Input& in, Ropes& ropes, const Engine& engine = no_engine);

/// The whole deck: ropes, positions, and the note of the worst position with its values in `out`. Not ok: no ropes can
/// be chosen (`found.rows` is empty then), or no position has an answer.
Outcome solve_deck(const Input& in, const Engine& engine, Sheet<Num>& s, Solved& found, Output& out,
                   const Display* display = nullptr);

}  // namespace taut::closed_loop
