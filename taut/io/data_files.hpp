#pragma once
#include "taut/calc/result.hpp"

namespace taut::io {

/// Whether no two of the tables, series, plots and profiles of a result have the same name.
bool named_apart(const Result& r);

/// Gives each of them a name of its own, by which result.json knows it and `NAME.csv` has its numbers. What comes first
/// keeps its name: tables, then series, then pictures. A picture with the name of a table becomes `NAME_plot`, anything
/// else `NAME_2`.
void name_apart(Result& r);

}  // namespace taut::io
