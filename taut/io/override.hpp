#pragma once
#include <string>

#include "taut/io/document.hpp"

namespace taut::io {

/// Puts a value over that of the deck: "input.cases[0].falls=6", also "input.cases.0.falls=6". Map keys that do not
/// exist are made, a list grows by one when its next index is named. The value is read like one line of a deck: a
/// number, a text, [a, b] or {a: b}. A mistake is told in "file" `--set`, at its column in `assignment`.
void override_value(Document& document, const std::string& assignment, Diagnostics& mistakes);

}  // namespace taut::io
