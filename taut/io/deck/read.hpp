#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "taut/calc/field.hpp"
#include "taut/io/deck/node.hpp"

namespace taut::io {

/// Fills the struct at `object`, which holds its defaults, from a map of the deck. Notes every mistake at its place
/// and goes on: unknown keys (with did-you-mean), missing required ones, wrong kinds, quantities without a unit or with
/// a wrong one, numbers out of range. `what` names the map in messages ("rope", "the input of mast_section").
/// True when there were no mistakes; otherwise the struct is filled in part and must not be used.
bool read(const Node& map, const Description& description, void* object, std::string_view what, Diagnostics& mistakes);

/// Whether an expression is left in the deck: it has no value, which has been reported (parameters.hpp). A struct read
/// from there lacks what it stands for.
bool has_expression(const Node& input);

/// Tells rules between fields that the deck breaks: each at the node of its path below `input`, or at the nearest one
/// above it that the deck has.
void place(const Node& input, const std::vector<Complaint>& complaints, Diagnostics& mistakes);

/// A value as a deck would write it: "100 kN", "0.15", "true", "[1 m]"; one that the field's range allows.
std::string example_value(const Field& f);

}  // namespace taut::io
