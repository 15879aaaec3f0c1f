#pragma once
#include <string>

#include "taut/app/methods.hpp"

namespace taut::app {

/// `taut explain METHOD`: source, scope, limits, the equations as the program computes them (taken from a run of the
/// example deck, so that this text can't drift from the code), the deck's keys with units, ranges and defaults, the
/// result's names, the errata of the published text.
std::string explain_text(const MethodEntry& method);

/// The keys of a description and its nested ones, one line each with unit, default and words; `prefix` before each.
std::string keys_text(const std::string& prefix, const Description& description);

/// The keys and names alone, as a Markdown section of the reference guide.
std::string reference_markdown(const MethodEntry& method);

/// docs/guide/reference.md: every key and every result name of every method.
std::string reference_guide();

}  // namespace taut::app
