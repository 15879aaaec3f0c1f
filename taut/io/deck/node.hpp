#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "taut/io/deck/source.hpp"

namespace taut::io {

struct Entry;

/// One value of a deck with its place. Maps keep the order of their entries and have no key twice.
struct Node {
  enum class Kind { null, scalar, sequence, map };

  Kind kind = Kind::null;
  Spot spot;                   ///< where it stands: the scalar with its quotes, the first entry of a map
  std::string text;            ///< scalar
  bool quoted = false;         ///< scalar: in quotes or as a block, never a number, flag or null
  bool literal = false;        ///< scalar: stands in the source letter by letter, so that a caret can point into it
  bool is_difference = false;  ///< scalar: of two temperatures, by its formula
  std::vector<Node> items;     ///< sequence
  std::vector<Entry> entries;  ///< map

  /// Value of a key of a map; nullptr when there is none, also for other kinds.
  const Node* find(std::string_view key) const;
  Node* find(std::string_view key);
  const Entry* find_entry(std::string_view key) const;

  /// Bytes `offset` to `offset + width` of a scalar's text; all of it when the caret can't point inside.
  Spot inside(std::size_t offset, std::size_t width) const;
};

/// A key of a map with its place, and its value.
struct Entry {
  std::string key;
  Spot key_spot;
  Node value;
};

/// "a map", "a list", "a text", "nothing": for messages.
std::string_view kind_text(const Node& n);

/// The node of "span.load" or "cases[1].falls" below `root`, or the nearest one above it that exists; for a missing
/// key the place of its map. `found` says whether all of the path does.
struct Found {
  const Node* node = nullptr;
  bool all = false;
};
Found follow(const Node& root, std::string_view path);

}  // namespace taut::io
