#pragma once
#include <string>

#include "taut/calc/result.hpp"

namespace taut::io {

/// Whether no two of the tables, series, plots and profiles of a result have the same name, and each name, of a scene
/// too, can be one of a file.
bool named_apart(const Result& r);

/// Gives each of them a name of its own, by which result.json knows it and `NAME.csv` has its numbers. What a file or a
/// link can't have in its name, as a rope's name may, becomes '_', and a name that is too long is cut. What comes first
/// keeps its name: tables, then series, then pictures. A picture with the name of a table becomes `NAME_plot`, anything
/// else `NAME_2`.
void name_apart(Result& r);

/// A name as a file, without an ending, can have it.
std::string name_of_file(std::string name);

}  // namespace taut::io
