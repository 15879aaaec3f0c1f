#pragma once
#include "taut/io/deck/document.hpp"

namespace taut::io {

/// Includes inside each other, and files in all, at most.
inline constexpr int deepest_include = 16;
inline constexpr int most_includes = 100;

/// Replaces the key `include:` (a path or a list of paths, relative to the folder of the including file) by what those
/// files say. Maps are merged key by key, at any depth; where both say something the including deck wins, a later
/// include wins over an earlier one; lists are replaced whole, unless the key ends with + ("contacts+: [...]"), which
/// adds to the list below. Values keep their own file in messages.
/// Mistakes at the include's place: a file that can't be read, that is no map, that includes itself, too deep, too
/// many; the mistakes of an included file at their own places. False where a file is left out for one of them: then the
/// document lacks what it says.
bool resolve_includes(Document& document, Diagnostics& mistakes);

/// `over` laid over `under`, as above.
Node merge(Node under, const Node& over);

}  // namespace taut::io
