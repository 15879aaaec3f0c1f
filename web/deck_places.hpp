#pragma once
#include <string>
#include <string_view>

namespace taut::web {

/// Where the values of a deck stand in its text, so that the page can put a number back and find the part under the
/// cursor. Places are counted in UTF-16 units, as an editor in a browser counts.
///   {outline [{path, key: [from, to] | null, value: [from, to], kind, text}],
///    handles [{path, name, kind, at [x, y, z] | on: NAME, numbers [{from, to, unit, factor, decimals, value, along,
///    least}]}]}
/// A handle is what the drawing can drag: numbers that stand in the text with their units (`value` in SI, `factor` SI
/// of one unit). Expressions, positions on bodies and what included decks give are none.
///   - Of kind "points", "sheaves", ..: a position `at`, three lengths in the ground's frame. "guess": of a carriage.
///   - "carriage": `on` the carriage of the result; the x, and z, that the first equilibrium gives it.
///   - "load": an arrow `on` a part of the result; the numbers are a force, or a mass.
/// `along`: what one SI unit moves in the ground's frame, m; for a load N. `least`: smallest number allowed.
/// An empty object for what is no YAML.
std::string places_of(std::string_view deck);

}  // namespace taut::web
