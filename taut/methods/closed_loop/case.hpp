#pragma once
#include <limits>
#include <optional>
#include <string>

#include "taut/calc/sheet.hpp"
#include "taut/methods/closed_loop/closed_loop.hpp"

namespace taut::closed_loop {

/// One carriage position in the paper's letters. Lengths m, forces N, weights N/m, angles rad.
/// `S_x`, `S_y` are the gathering force toward B and down; `eta` is already 1/eta for out-haul.
template <class T>
struct Case {
  T l;        ///< horizontal span
  T alpha_s;  ///< signed slope of the chord, + downhill work (B above A)
  T alpha;    ///< |alpha_s|
  T m;        ///< tan(alpha_s)
  T cos_a;
  T sin_a;  ///< sin |alpha_s|
  T sin_2a;
  T x;      ///< A to carriage, horizontal
  T y;      ///< carriage to B
  T f;      ///< vertical sag under the chord at x
  T S;      ///< gathering force
  T sin_g;  ///< of gamma, from the vertical
  T cos_g;
  T q_b;  ///< weight of the return rope per metre of rope, q_T of the traction rope
  T q_T;
  T w_b;  ///< the same per horizontal metre
  T w_T;
  T eta;
  T W_c;  ///< weight of the carriage
  /// Stiffness EA of the return and of the traction rope, N, for the exact catenaries.
  double EA_b = std::numeric_limits<double>::infinity();
  double EA_T = std::numeric_limits<double>::infinity();
  bool midspan = false;
  bool downhill = true;  ///< alpha_s >= 0
  bool has_weight = false;
  Roller roller = Roller::free;
  const Display* display = nullptr;  ///< for its messages
};

struct Engine;

/// What differs between the positions of one deck: numbers that the deck gives only indirectly.
struct Setting {
  const double* x = nullptr;  ///< an element of Input::position, null for midspan
  double q_b = 0;
  double q_T = 0;
  std::optional<double> EA_b = std::nullopt;  ///< empty: that of the deck
  std::optional<double> EA_T = std::nullopt;
  const Engine* engine = nullptr;    ///< exact catenaries, where there are some
  const Display* display = nullptr;  ///< the units of its messages; null: those of print
};

/// A quantity in a message, in the units of `display`; null: those of print.
std::string shown(const Display* display, double x, const Unit& unit);

/// A place counts as midspan within this share of the span.
inline constexpr double midspan_tolerance = 1e-9;

/// Reads the case off the input; the sag is left to the caller. Records the given quantities.
template <class T>
Case<T> make_case(const Input& in, const Setting& at, Sheet<T>& s);

}  // namespace taut::closed_loop
