#pragma once
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "taut/io/deck/node.hpp"

namespace taut::io {

/// Maps and lists inside each other, at most.
inline constexpr int deepest_nesting = 64;
/// Values, keys, maps and lists of one deck, at most; and bytes of all its texts and of one value.
inline constexpr std::size_t most_values = 200000;
inline constexpr std::size_t most_text = std::size_t{4} * 1024 * 1024;
inline constexpr std::size_t longest_value = std::size_t{1024} * 1024;

/// A YAML text as a tree in which every value knows its place.
/// `mistakes` are those that do not stop the reading (a key twice, an anchor, a tag): tell them together with those
/// that reading the values finds; a deck with any must not be run.
struct Document {
  SourcePtr source;
  Node root;
  Diagnostics mistakes;
  std::vector<Node> replaced{};  ///< what stood where `--set` has put something else
};

/// Reads one YAML document (1.2 core meaning: plain `on` and `y` are texts). `name` is what messages call it.
/// Refused with a diagnostic at the place: what is not YAML, more than one document, an empty one, more than the limits
/// above, unreadable bytes (check_text). Anchors, aliases, tags beyond the core ones and keys that are not texts are
/// mistakes. Never throws for any text; linear in its size.
tl::expected<Document, Diagnostics> parse(std::string_view text, std::string name);

/// The same for a text whose messages show another one: `text` has the length of `source->text`, with spaces for what
/// is not YAML ("input.span=" before the value).
tl::expected<Document, Diagnostics> parse(std::string_view text, SourcePtr source);

}  // namespace taut::io
