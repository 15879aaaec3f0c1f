#pragma once
#include <optional>
#include <string>

namespace taut::app {

/// What a check or a table of a report is, by its name there: "hoist.drum_ratio", "spans", "discard_hoist". Nothing:
/// there is none of that name.
std::optional<std::string> explain_report_name(const std::string& name);

}  // namespace taut::app
