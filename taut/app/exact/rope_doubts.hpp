#pragma once
#include <optional>
#include <string>

#include "taut/calc/result.hpp"
#include "taut/catalogue/rope_values.hpp"
#include "taut/units/display.hpp"

/// Values of a method's deck that contradict the rope of the catalogue that it names, as machine decks have them.
namespace taut::app {

/// A rope of a published method.
struct MethodRope {
  std::string name;
  std::optional<std::string> rope;          ///< of the catalogue: id, or its properties in words
  catalogue::OwnValues own;                 ///< what the deck has in place of the row's values
  double tension = 0;                       ///< the largest of all states, N; 0 or NaN: not known
  std::string stiffness_key = "stiffness";  ///< what its stiffness is from in the deck
  bool metal = false;                       ///< the deck gives its metallic area: it is of steel without a row too
};

/// Unsafe warnings of values that no rope of the row has, and of a strain that no steel rope bears. A rope of which the
/// deck gives the stiffness alone may be of fibre: the strain is a plain warning.
void warn_of_rope(const MethodRope& rope, const Display& display, Result& r);

}  // namespace taut::app
