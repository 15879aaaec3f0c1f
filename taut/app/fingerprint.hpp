#pragma once
#include <string>
#include <string_view>

namespace taut::app {

/// SHA-1 of a text as 40 hexadecimal digits: tells decks apart in reports; a fingerprint, not a seal.
std::string fingerprint(std::string_view text);

}  // namespace taut::app
