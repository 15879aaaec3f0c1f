#pragma once
#include <optional>

#include "taut/base/array.hpp"
#include "taut/machine/model.hpp"
#include "taut/machine/prescribed.hpp"

namespace taut::machine {

/// Which way ropes run over the nodes of their paths, [reeving][node]: +1 along the path, -1 against it, 0 neither.
struct Senses {
  Array<Array<int>> flow;
  /// Of a contact with losses over which a rope creeps: its flow when the rope is drawn to its carriage; else 0.
  /// Whether it is drawn there or let out, the word of the motion does not say; its `flow` is one of the two.
  Array<Array<int>> creep;
  /// Whether a rope, [reeving], that ends at a carriage is drawn off its winch by the carriage's mainline: while the
  /// machine hauls in as a whole it runs against its `flow`.
  Array<bool> follows;
  /// Which way each carriage moves along its `Prescribed::along`, else along the horizontal part of its span; 0:
  /// nothing says it.
  Array<int> moves;
};

/// Whether a rope is taken in at that end: on a drum, by a tension given there, or as the mainline or haulback of the
/// carriage at its other end. An endless rope has no such end.
bool is_taken_in(const Model& model, int reeving, bool at_end);

/// Whether friction acts where a rope runs over a node.
bool loses(const Node& node);

/// While the machine hauls in. A rope runs as its `haul` says. A carriage moves to where its mainline (without one its
/// haulback, or what it is fixed to) runs off from it, and the rope on which it rolls passes it the other way. That
/// rope creeps over its other contacts, unless the deck gives its `haul`. `prescribed`: the place of its carriage; the
/// others stand as at the start. docs/theory/senses.md.
Senses hauling_in(const Model& model, const std::optional<Prescribed>& prescribed = std::nullopt);

}  // namespace taut::machine
