#pragma once
#include <pybind11/pybind11.h>

#include <memory>
#include <string>

#include "taut/calc/result.hpp"

namespace taut::python {

/// A result as Python holds it: shared, never changed.
using NativeResult = std::shared_ptr<const Result>;

/// A quantity's unit: (SI symbol, unit of print).
pybind11::tuple unit_of(const Unit& unit);

/// A table as a map: name, title, columns [(name, SI symbol, unit of print)], data: one entry for each column, a view
/// of one array of float64 where the column has numbers alone (NaN: no value), else a list of numbers and texts.
pybind11::dict table_of(const Table& t);

/// A figure as a map with its `kind` ("plot", "drawing", "animation", "profile", "bars") and its data, SI.
pybind11::dict figure_of(const Figure& f);

/// Makes the class NativeResult and its parts, each plain data: numbers, texts, lists, maps and arrays.
void bind_result(pybind11::module_& m);

}  // namespace taut::python
