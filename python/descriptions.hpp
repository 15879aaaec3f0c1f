#pragma once
#include <pybind11/pybind11.h>

namespace taut::python {

/// All descriptions of decks as plain data, from which the package makes its keywords, docstrings and stub:
///   tables    list of {fields: [{key, kind, symbol, unit, shown, needs_text, ...}], exactly_one: [[key]]}
///   machine   index of the table of a machine's deck: machine, analyses, checks, design, study, calibrate
///   blocks    index of the table of what stands beside a method's input
///   methods   list of {name, title, source, scope, limits, input, output, exact}; the last three are indices
/// A field's `record` is the index of another table.
pybind11::dict descriptions();

}  // namespace taut::python
