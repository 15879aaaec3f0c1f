#pragma once
#include <string>

namespace taut::app {

/// The JSON Schema (draft 7) of decks, with every method's fields.
std::string schema_text();

}  // namespace taut::app
