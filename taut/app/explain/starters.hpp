#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace taut::app {

/// A machine deck that runs by itself, to begin from.
struct Starter {
  std::string name;       ///< "rope_saw_drive"
  std::string title;      ///< of the deck
  std::string_view text;  ///< the deck with its comments
};

/// The examples of machines that need no file beside them, by name.
const std::vector<Starter>& starters();

/// By its whole name, by a short one ("skyline", "tackle"), or by a part that only one name has; nullptr without one.
const Starter* find_starter(std::string_view name);

/// A deck as `taut new` prints it: its text, behind the line that names the schema for an editor.
std::string starter_deck(std::string_view text);

/// Names of all starters.
std::vector<std::string> starter_names();

}  // namespace taut::app
