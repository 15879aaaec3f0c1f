#include "taut/app/machine_deck.hpp"

namespace taut::app {

const Description& MachineDeck::describe() {
  static const Description d =
      Describe<MachineDeck>()
          .record(&MachineDeck::machine, "machine", "bodies, ropes, and the paths of the ropes")
          .required()
          .record(&MachineDeck::analyses, "analyses", "analyses to compute; default: the equilibrium at rest")
          .record(&MachineDeck::checks, "checks", "which parts are checked by which rules")
          .record(&MachineDeck::study, "study", "many cases of this deck: what varies, and what is asked for")
          .record(&MachineDeck::calibrate, "calibrate", "numbers of this deck that measurements shall tell")
          .record(&MachineDeck::design, "design", "free choices; the best one that passes all checks is found");
  return d;
}

}  // namespace taut::app
