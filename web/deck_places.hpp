#pragma once
#include <string>
#include <string_view>

namespace taut::web {

/// Where the values of a deck stand in its text, so that the page can put a number back and find the part under the
/// cursor. Places are counted in UTF-16 units, as an editor in a browser counts.
///   {outline [{path, key: [from, to] | null, value: [from, to], kind, text}], handles [{path, name, kind, at [x, y,
///   z],
///    numbers [{from, to, unit, factor, decimals}]}]}
/// A handle is a position that stands in the text as three lengths, in the ground's frame; expressions, positions on
/// bodies and those of included decks are none. `factor`: metres of one unit. An empty object for what is no YAML.
std::string places_of(std::string_view deck);

}  // namespace taut::web
