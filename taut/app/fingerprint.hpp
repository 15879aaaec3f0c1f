#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace taut::app {

/// SHA-1 of a text as 40 hexadecimal digits: tells decks apart in reports; a fingerprint, not a seal.
std::string fingerprint(std::string_view text);

/// Of everything that decides the numbers of a run. Of a deck alone it is that of its text, what `sha1sum` prints. With
/// more it is that of a list, one line for each: "deck HASH", "file HASH" of every file that the deck names (included
/// decks, terrain, catalogue, saved state) in the order in which they are read, "set HASH" of every override as given.
std::string fingerprint(std::string_view deck, const std::vector<std::string>& files,
                        const std::vector<std::string>& set);

}  // namespace taut::app
