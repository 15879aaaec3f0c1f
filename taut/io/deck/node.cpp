#include "taut/io/deck/node.hpp"

#include <algorithm>
#include <charconv>

namespace taut::io {

const Entry* Node::find_entry(std::string_view key) const {
  const auto at = std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.key == key; });
  return at == entries.end() ? nullptr : &*at;
}

const Node* Node::find(std::string_view key) const {
  const Entry* e = find_entry(key);
  return e == nullptr ? nullptr : &e->value;
}

Node* Node::find(std::string_view key) {
  const auto at = std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.key == key; });
  return at == entries.end() ? nullptr : &at->value;
}

Spot Node::inside(std::size_t offset, std::size_t width) const {
  if (!literal) return spot;
  const std::size_t quote = quoted ? 1 : 0;
  const std::size_t from = std::min(offset, text.size());
  return {.source = spot.source,
          .offset = spot.offset + quote + from,
          .width = std::max<std::size_t>(1, std::min(width, text.size() - from))};
}

std::string_view kind_text(const Node& n) {
  switch (n.kind) {
    case Node::Kind::null:
      return "nothing";
    case Node::Kind::scalar:
      return "a text";
    case Node::Kind::sequence:
      return "a list";
    case Node::Kind::map:
      return "a map";
  }
  return "nothing";
}

namespace {

/// How much of the path, which begins with a key of this map, is the key: the longest that the map has, as names may
/// have dots ("boom.top"); else up to the next dot or bracket.
std::size_t key_width(const Node& map, std::string_view path) {
  std::size_t width = 0;
  for (const Entry& e : map.entries) {
    const std::size_t n = e.key.size();
    const bool ends = path.size() == n || (path.size() > n && (path[n] == '.' || path[n] == '['));
    if (n > width && ends && path.substr(0, n) == e.key) width = n;
  }
  return width > 0 ? width : std::min(path.find_first_of(".["), path.size());
}

}  // namespace

Found follow(const Node& root, std::string_view path) {
  const Node* node = &root;
  while (!path.empty()) {
    const Node* next = nullptr;
    if (path[0] == '[') {
      const std::size_t close = std::min(path.find(']'), path.size());
      std::size_t index = 0;
      const auto [end, code] = std::from_chars(path.data() + 1, path.data() + close, index);
      // a single value stands for a list of one
      if (node->kind != Node::Kind::sequence && index == 0) next = node;
      if (code == std::errc{} && node->kind == Node::Kind::sequence && index < node->items.size()) {
        next = &node->items[index];
      }
      path.remove_prefix(std::min(path.size(), close + 1));
    } else {
      const std::size_t stop = key_width(*node, path);
      next = node->find(path.substr(0, stop));
      path.remove_prefix(stop);
    }
    if (next == nullptr) return {.node = node, .all = false};
    node = next;
    if (!path.empty() && path[0] == '.') path.remove_prefix(1);
  }
  return {.node = node, .all = true};
}

}  // namespace taut::io
