#pragma once
#include <string>
#include <string_view>

#include "taut/io/deck/source.hpp"

namespace taut::io {

/// What a message of the YAML scanner means to the author of a deck, reported at the place where it went wrong.
Diagnostic yaml_mistake(const SourcePtr& source, std::size_t offset, std::string_view scanner_message);

}  // namespace taut::io
