#pragma once
#include <string>
#include <vector>

#include "taut/base/diagnostic.hpp"
#include "taut/calc/result.hpp"
#include "taut/checks/checks_deck.hpp"
#include "taut/machine/description/machine.hpp"
#include "taut/machine/model.hpp"

/// Which part of a machine it is that a check or a warning speaks of.
namespace taut::checks {

/// What a rope runs over, is fixed to or rides on.
Part part_at(const machine::Model& model, const machine::Node& node);
/// A body, a carriage, or the beam of which it is a piece.
Part part_of_body(const machine::Model& model, int body);
/// What a check of anchors names: a point, a body on a joint, or what a rope runs over.
Part part_of_anchor(const machine::Machine& machine, const std::string& name);
/// A beam of the machine, or a mast that the checks describe.
Part part_of_mast(const machine::Model& model, const std::string& name);

/// The parts that `exempt` takes out. A name that several parts have takes out none: the deck says which one by its
/// kind, "drum winch".
std::vector<Part> exempt_parts(const ChecksRequest& request, const machine::Machine& machine);
/// Names in `exempt` that the machine has not, or of which it has several parts.
void complain_of_exempt(const ChecksRequest& request, const machine::Machine& machine,
                        std::vector<Complaint>& complaints);

}  // namespace taut::checks
