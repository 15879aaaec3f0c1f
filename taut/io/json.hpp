#pragma once
#include <string>

#include "taut/calc/result.hpp"

namespace taut::io {

/// Whether the series of a result were written as files beside it, and in which units those of plots.
enum class SeriesFiles { none, named, named_si };

/// The result as one JSON object in the shape of result format 2, SI throughout, with a line end behind it. Numbers
/// read back bit by bit; one that is not finite is null. Keys stand in the order of the contract:
///   taut {version, format}, title, method, status, message, verdict, verdict_class, verdict_reason, values {NAME:
///   {value, unit, symbol, label, source}}, tables {NAME: {columns [{name, unit}], rows}} with `comparison` (printed,
///   corrected, exact) among them, checks, steps (those with a symbol), series {NAME: {columns, file}}, warnings,
///   errors.
/// A series is a history or a plot; `file` is "NAME.csv", "series.h5" of a history that no CSV file has, or null with
/// SeriesFiles::none. The columns of a plot have the units of its file: with SeriesFiles::named those of the report.
std::string to_json(const Result& r, SeriesFiles files = SeriesFiles::none);

/// The mistakes of a deck that is only read, as {taut, status, errors}; status ok or bad_deck. Nothing is calculated,
/// so that there is no verdict.
std::string to_json(const Diagnostics& mistakes);

}  // namespace taut::io
