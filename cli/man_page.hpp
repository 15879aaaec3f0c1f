#pragma once
#include <string>

#include "cli/command_words.hpp"

namespace taut::cli {

/// The manual page taut(1) as roff (man macros): verbs with their options, exit codes, files, environment, examples.
/// `date`: of the page, "2026-02-13".
std::string man_page(const CommandWords& command, const std::string& date);

}  // namespace taut::cli
