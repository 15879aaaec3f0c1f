#pragma once
#include <string>
#include <vector>

#include "cli/command_words.hpp"

namespace taut::cli {

/// The shells that completion_script knows: bash, fish, zsh.
std::vector<std::string> shells();

/// A script that completes verbs, options, decks, folders and names on the command line of a shell. Empty for a shell
/// that is not known. The names stand in the script: completing does not start the program.
std::string completion_script(const CommandWords& command, const std::string& shell);

}  // namespace taut::cli
