#pragma once
#include <optional>
#include <string>

namespace taut::app {

/// What a check or a table of a report is, by its name there: "hoist.drum_ratio", "spans", "discard_hoist". Nothing:
/// there is none of that name.
std::optional<std::string> explain_report_name(const std::string& name);

/// A table with the name of its analysis behind its own: "spans_hoist".
std::optional<std::string> explain_table_of_analysis(const std::string& name);

/// A name without the load case of a design, "mast.buckling [loaded]", and without the roller of a carriage over which
/// its rope runs, "track.car.roller2.T_in": "mast.buckling", "track.car.T_in".
std::string plain_name(std::string name);

}  // namespace taut::app
