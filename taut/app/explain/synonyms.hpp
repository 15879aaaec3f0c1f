#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace taut::app {

/// What a deck calls a thing that the field also calls otherwise: "pulley" -> "sheaves". Case does not count; a plural
/// is found by its singular. Empty for a word without another name.
std::string deck_word(std::string_view word);

/// All words that deck_word knows.
std::vector<std::string> field_words();

}  // namespace taut::app
