#include "taut/io/override.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <vector>

namespace taut::io {
namespace {

/// One step of a path: a key, or an index.
struct Step {
  std::string key;
  std::optional<std::size_t> index;  ///< "[3]", or a key that is a whole number
  bool bracket = false;
  Spot spot;
};

std::optional<std::size_t> index_of(std::string_view text) {
  std::size_t i = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), i);
  if (code != std::errc{} || end != text.data() + text.size() || text.empty()) return std::nullopt;
  return i;
}

class Override {
 public:
  Override(const std::string& assignment, Diagnostics& mistakes) : mistakes_(mistakes) {
    auto source = std::make_shared<Source>();
    source->name = "--set";
    source->text = assignment;
    source_ = source;
  }

  void apply(Document& document) {
    const std::string& text = source_->text;
    Diagnostics unreadable = check_text(source_);
    if (!unreadable.empty()) return add(mistakes_, unreadable.front());
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) return wrong(0, text.size(), "write path=value, such as 'input.span=200 m'");
    if (text.find_first_not_of(" \t", equals + 1) == std::string::npos) {
      return wrong(equals, 1, "there is no value behind the '='");
    }
    const auto steps = read_path(equals);
    if (!steps) return;
    auto value = parse(std::string(equals + 1, ' ') + text.substr(equals + 1), source_);
    for (Diagnostic& d : value ? value->mistakes : value.error()) add(mistakes_, std::move(d));
    if (!value) return;
    if (Node* target = find(document.root, *steps)) *target = std::move(value->root);
  }

 private:
  void wrong(std::size_t offset, std::size_t width, std::string message) {
    add(mistakes_, {source_, offset, width}, std::move(message));
  }

  std::optional<std::vector<Step>> read_path(std::size_t end) {
    const std::string_view path = std::string_view(source_->text).substr(0, end);
    std::vector<Step> steps;
    std::size_t i = 0;
    bool expects_key = true;
    while (i < path.size() || expects_key) {
      const std::size_t from = i;
      if (!expects_key && path[i] == '[') {
        const std::size_t close = path.find(']', i);
        const auto index = close == std::string_view::npos ? std::nullopt : index_of(path.substr(i + 1, close - i - 1));
        if (!index) return wrong(from, 1, "an index such as [0] is expected"), std::nullopt;
        i = close + 1;
        steps.push_back({{}, index, true, {source_, from, i - from}});
      } else if (!expects_key && path[i] == '.') {
        ++i;
        expects_key = true;
        continue;
      } else if (expects_key) {
        i = std::min(path.find_first_of(".[", i), path.size());
        const std::string key(path.substr(from, i - from));
        if (key.empty()) return wrong(from, 1, "a key is missing in the path"), std::nullopt;
        steps.push_back({key, index_of(key), false, {source_, from, key.size()}});
        expects_key = false;
      } else {
        return wrong(from, 1, "'.' or '[' is expected here"), std::nullopt;
      }
    }
    if (steps.size() > static_cast<std::size_t>(deepest_nesting)) {
      return wrong(0, path.size(), fmt::format("nested deeper than {}", deepest_nesting)), std::nullopt;
    }
    return steps;
  }

  Node* find(Node& root, const std::vector<Step>& steps) {
    Node* node = &root;
    for (const Step& step : steps) {
      node = node->kind == Node::Kind::sequence ? item(*node, step) : member(*node, step);
      if (node == nullptr) return nullptr;
    }
    return node;
  }

  Node* item(Node& list, const Step& step) {
    const std::size_t size = list.items.size();
    if (!step.index) {
      add(mistakes_,
          at(step.spot, fmt::format("{} is asked of a list: write an index such as [0]", in_quotes(step.key))));
      return nullptr;
    }
    if (*step.index > size) {
      add(mistakes_, step.spot, fmt::format("the list has {} entries, the first is [0]", size));
      return nullptr;
    }
    if (*step.index == size) list.items.emplace_back().spot = step.spot;
    return &list.items[*step.index];
  }

  Node* member(Node& map, const Step& step) {
    if (step.bracket) {
      if (map.kind != Node::Kind::map && map.kind != Node::Kind::null && *step.index == 0) return &map;  // list of one
      add(mistakes_, step.spot, fmt::format("this is {}, not a list", kind_text(map)));
      return nullptr;
    }
    if (map.kind == Node::Kind::scalar) {
      add(mistakes_, step.spot, fmt::format("{} is asked of a text, not of a map", in_quotes(step.key)));
      return nullptr;
    }
    if (map.kind == Node::Kind::null) {
      map.kind = Node::Kind::map;
      map.spot = step.spot;
    }
    if (Node* known = map.find(step.key)) return known;
    map.entries.push_back({step.key, step.spot, {}});
    map.entries.back().value.spot = step.spot;
    return &map.entries.back().value;
  }

  Diagnostics& mistakes_;
  SourcePtr source_;
};

}  // namespace

void override_value(Document& document, const std::string& assignment, Diagnostics& mistakes) {
  Override(assignment, mistakes).apply(document);
}

}  // namespace taut::io
