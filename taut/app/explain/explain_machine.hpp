#pragma once
#include <optional>
#include <string>
#include <vector>

namespace taut::app {

/// What `taut explain` knows of decks of machines: "machine", the keys below it ("sheaves"), the analyses
/// ("load_path").
std::vector<std::string> machine_topics();

/// The text on a topic: its deck keys with units, ranges and defaults; of the machine also its parts, analyses, laws
/// and result tables, of an analysis its result tables. Empty for a name that is no topic.
std::optional<std::string> explain_machine(const std::string& topic);

}  // namespace taut::app
