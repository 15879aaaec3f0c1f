#include "taut/machine/signals_in.hpp"

#include <variant>

namespace taut::machine {

GoesOn goes_on(const Model& model, double t) {
  GoesOn all;
  for_each_signal(model, [&](const Signal& signal) {
    const bool swings = std::holds_alternative<Sine>(signal.law) || std::holds_alternative<TimeFormula>(signal.law);
    const bool changes = at(signal, t).rate != 0;
    all.ramps = all.ramps || (changes && !swings);
    all.swings = all.swings || (changes && swings);
  });
  return all;
}

}  // namespace taut::machine
