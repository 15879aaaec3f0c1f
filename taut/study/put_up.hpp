#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/machine/description/machine.hpp"
#include "taut/study/installation.hpp"

namespace taut::study {

/// A rope as it was put up.
struct PutUpLine {
  int reeving = 0;      ///< in the whole model
  EmptyLine line;       ///< the machine at that moment
  Installation at;      ///< the state; not ok: why there is none
  double tension = 0;   ///< base tension, N
  bool at_end = false;  ///< at which end of its path
};

/// A moment while a machine is put up: what of it is there, and its equilibrium.
struct PutUpMoment {
  machine::Model model;  ///< as guys are put up without beams
  solve::EquilibriumResult state;
  std::string words;
};

/// Puts up the ropes that are to be (machine::Reeving::put_up), in turn: each on the machine with the ropes before it
/// and without those to come; what hangs on it is not there but for what it is put up with. Its length is kept from
/// there on: `model` has it. Ends with the first that fails.
Array<PutUpLine> put_up(machine::Model& model);

/// Finds the lengths of the ropes with Given::equal: the equilibrium at rest, without losses and with the whole
/// machine, in which each has at its start the tension of its rope `equal_to`. The lengths are kept from there on.
Outcome draw_equal(machine::Model& model);

/// `put_up`, then `draw_equal`; not ok: why one has no answer.
Outcome put_up_lines(machine::Model& model, std::vector<PutUpLine>& lines);

/// A machine as it stands unloaded: without its loads but those of its take-ups, without forces along its ropes, given
/// torques and speeds.
machine::Model without_loads(const machine::Model& model);

/// Sets the screws of a machine whose ropes have their lengths: in the equilibrium at rest, without losses, of
/// the unloaded machine they pull with their forces. Their bodies are fixed from there on: `model` has their places.
/// `moments`: gets the machine at that moment.
Outcome set_screws(machine::Model& model, std::vector<PutUpMoment>* moments = nullptr);

/// The same for the load case `own` of the machine `on`, as whose ropes those of the model were put up: at the
/// temperature of that one.
Outcome set_screws_as_on(const machine::Machine& on, const machine::Machine& own, machine::Model& model,
                         std::vector<PutUpMoment>* moments = nullptr);

/// Puts up the guys that have a tension: on the machine with its bodies held and nothing but the guys; each of them
/// then keeps its length. `moments`: gets the guys at that moment.
Outcome install_guys(machine::Model& model, std::vector<PutUpMoment>* moments = nullptr);

/// The machine on its guys alone (the reevings from `first_guy` on, which have their lengths), its bodies let go:
/// without loads, other ropes and what hangs on those. Empty where no mast has guys around it. `state.outcome` not ok:
/// why it does not stand so.
std::optional<PutUpMoment> stand_on_guys(const machine::Model& model, std::size_t first_guy);

/// Whether a rope before `first_guy` holds a beam that has no guys: without it that beam may fall, whatever the guys
/// hold.
bool other_ropes_hold_beams(const machine::Model& model, std::size_t first_guy);

/// Whether the guys of the masts that hold this one (a reeving) pull to all sides in plan, as described, so that they
/// can balance each other. Where all pull to one side it is the lines that they balance.
bool has_guys_around(const machine::Model& model, std::size_t first_guy, std::size_t guy);

/// Gives the guys of a model the lengths that they have in another one of the same machine.
void keep_guys(const machine::Machine& machine, const machine::Model& installed, machine::Model& model);

/// The same of the ropes that are put up or drawn to equal tensions.
void keep_lines(const machine::Model& installed, machine::Model& model);

/// The same of the bodies that screws hold.
void keep_screws(const machine::Model& installed, machine::Model& model);

/// The state of a line as it is put up: "skyline as put up", or with what hangs on it meanwhile.
std::string put_up_words(const machine::Model& model, const PutUpLine& line);

struct PutUpRow {
  const machine::Model& model;
  const PutUpLine& line;
};
const Quantities<PutUpRow>& put_up_quantities();

}  // namespace taut::study
