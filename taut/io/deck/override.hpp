#pragma once
#include <string>
#include <vector>

#include "taut/io/deck/document.hpp"

namespace taut::io {

/// Puts a value over that of the deck, by the path that a sweep's `parameter` has too: "machine.loads[0].mass", also
/// "machine.loads.0.mass"; an entry of a list by its name, its rope, or the body it is at, "machine.reevings.skyline";
/// a component of a vector, "machine.points.head.z". 'machine.' may be left away, of a method 'input.': a path begins
/// there where its first step is not (nearly) one of `deck_keys`. Map keys that do not exist are made, a list grows by
/// one when its next index is named. The value is read like one line of a deck: a number, a text, [a, b] or {a: b};
/// `null` takes a whole block out, "design=null". A mistake has the "file" `--set` and its column in `assignment`.
void override_value(Document& document, const std::string& assignment, const std::vector<std::string>& deck_keys,
                    Diagnostics& mistakes);

}  // namespace taut::io
