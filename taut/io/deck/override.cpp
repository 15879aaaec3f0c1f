#include "taut/io/deck/override.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <vector>

#include "taut/base/suggest.hpp"

namespace taut::io {
namespace {

/// One step of a path: a key or name, or an index.
struct PathStep {
  std::string key;                   ///< empty: "[3]"
  std::optional<std::size_t> index;  ///< "[3]", or a key that is a whole number
  bool bracket = false;              ///< "[3]", "[skyline]"
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
  Override(const std::string& assignment, const std::vector<std::string>& deck_keys, Diagnostics& mistakes)
      : deck_keys_(deck_keys), mistakes_(mistakes) {
    auto source = std::make_shared<Source>();
    source->name = "--set";
    source->text = assignment;
    source_ = source;
    source_of_value_ = source;
  }

  void apply(Document& document) {
    if (document.source) source_of_value_->reading = document.source->reading;
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
    if (steps->front().key == "include") {
      return wrong(0, equals, "the files of 'include' are read before '--set': write it in the deck");
    }
    if (says_nothing(text.substr(equals + 1))) {
      const std::string& block = steps->front().key;
      if (steps->size() > 1 || std::find(deck_keys_.begin(), deck_keys_.end(), block) == deck_keys_.end()) {
        return wrong(0, text.size(), "'null' takes a whole block out, as in 'design=null'");
      }
      return take_out(block, document);
    }
    auto value = parse(std::string(equals + 1, ' ') + text.substr(equals + 1), source_);
    for (Diagnostic& d : value ? value->mistakes : value.error()) add(mistakes_, std::move(d));
    if (!value) return;
    Node* target = find(below_machine(document.root, *steps), *steps);
    if (target == nullptr) return;
    document.replaced.push_back(std::move(*target));
    *target = std::move(value->root);
  }

 private:
  static bool says_nothing(std::string_view value) {
    const std::size_t from = value.find_first_not_of(" \t");
    const std::size_t to = value.find_last_not_of(" \t");
    return from != std::string_view::npos && value.substr(from, to - from + 1) == "null";
  }

  static void take_out(const std::string& block, Document& document) {
    auto& all = document.root.entries;
    const auto found = std::find_if(all.begin(), all.end(), [&](const Entry& e) { return e.key == block; });
    if (found == all.end()) return;
    document.replaced.push_back(std::move(found->value));
    all.erase(found);
  }

  void wrong(std::size_t offset, std::size_t width, std::string message) {
    add(mistakes_, {.source = source_, .offset = offset, .width = width}, std::move(message));
  }

  std::optional<std::vector<PathStep>> read_path(std::size_t end) {
    const std::string_view path = std::string_view(source_->text).substr(0, end);
    std::vector<PathStep> steps;
    std::size_t i = 0;
    bool expects_key = true;
    while (i < path.size() || expects_key) {
      const std::size_t from = i;
      if (!expects_key && path[i] == '[') {
        const std::size_t close = path.find(']', i);
        const auto inside = close == std::string_view::npos ? std::string_view() : path.substr(i + 1, close - i - 1);
        if (inside.empty()) return wrong(from, 1, "an index such as [0] is expected"), std::nullopt;
        const auto index = index_of(inside);
        i = close + 1;
        steps.push_back({index ? std::string() : std::string(inside),
                         index,
                         true,
                         {.source = source_, .offset = from, .width = i - from}});
      } else if (!expects_key && path[i] == '.') {
        ++i;
        expects_key = true;
        continue;
      } else if (expects_key) {
        i = std::min(path.find_first_of(".[", i), path.size());
        const std::string key(path.substr(from, i - from));
        if (key.empty()) return wrong(from, 1, "a key is missing in the path"), std::nullopt;
        steps.push_back({key, index_of(key), false, {.source = source_, .offset = from, .width = key.size()}});
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

  /// Where a path begins: that of a machine may leave 'machine.' away, that of a method 'input.'. What looks like a key
  /// of the deck is one.
  Node& below_machine(Node& root, const std::vector<PathStep>& steps) const {
    const std::string& first = steps.front().key;
    if (root.kind != Node::Kind::map || root.find(first) != nullptr) return root;
    if (std::find(deck_keys_.begin(), deck_keys_.end(), first) != deck_keys_.end()) return root;
    for (const char* key : {"machine", "input"}) {
      Node* below = root.find(key);
      if (below == nullptr || below->kind != Node::Kind::map) continue;
      if (below->find(first) != nullptr || did_you_mean(first, deck_keys_).empty()) return *below;
    }
    return root;
  }

  /// The node at the path, made where there is none yet.
  Node* find(Node& root, const std::vector<PathStep>& steps) {
    Node* node = &root;
    for (std::size_t i = 0; i < steps.size() && node != nullptr;) {
      node = node->kind == Node::Kind::sequence ? item(*node, steps, i) : member(*node, steps, i);
    }
    return node;
  }

  /// An entry of a list; `i` moves behind its steps.
  Node* item(Node& list, const std::vector<PathStep>& steps, std::size_t& i) {
    const PathStep& step = steps[i++];
    if (!step.index) return named_item(list, steps, i);
    const std::size_t size = list.items.size();
    if (*step.index > size) {
      add(mistakes_, step.spot, fmt::format("the list has {} entries, the first is [0]", size));
      return nullptr;
    }
    if (*step.index == size) list.items.emplace_back().spot = step.spot;
    return &list.items[*step.index];
  }

  /// An entry by its name, rope, place or body, or a component of a vector. `i`: behind the first step of the name.
  Node* named_item(Node& list, const std::vector<PathStep>& steps, std::size_t& i) {
    const PathStep& step = steps[i - 1];
    std::vector<std::string> known;
    for (const char* key : {"name", "rope", "at", "body"}) {
      std::vector<std::size_t> found;
      std::size_t longest = 0;  // "a.b" before "a"
      for (std::size_t k = 0; k < list.items.size(); ++k) {
        const Node& one = list.items[k];
        const Node* text = one.kind == Node::Kind::map ? one.find(key) : nullptr;
        if (text == nullptr || text->kind != Node::Kind::scalar) continue;
        known.push_back(text->text);
        const std::size_t count = fits(text->text, steps, i - 1);
        if (count > longest) found.clear(), longest = count;
        if (count > 0 && count == longest) found.push_back(k);
      }
      // what has no name of its own is called by its rope, place or body
      const auto named = [&](std::size_t k) { return list.items[k].find("name") != nullptr; };
      if (const auto own = std::find_if_not(found.begin(), found.end(), named);
          own != found.end() && std::all_of(own + 1, found.end(), named)) {
        found = {*own};
      }
      if (found.size() > 1) {
        add(mistakes_, step.spot,
            fmt::format("{} is the '{}' of {} entries: write the index of one, [{}]", in_quotes(step.key), key,
                        found.size(), fmt::join(found, "], [")));
        return nullptr;
      }
      if (!found.empty()) return i += longest - 1, &list.items[found.front()];
    }
    const bool vector = !list.items.empty() && std::all_of(list.items.begin(), list.items.end(), [](const Node& one) {
      return one.kind == Node::Kind::scalar;
    });
    if (vector && step.key == "at") return &list;  // the short form of {at: [..]}
    if (const auto k = component(step.key); vector && k && *k < list.items.size()) return &list.items[*k];
    if (vector && step.key == "angle") {
      add(mistakes_, step.spot, "the direction of a vector is for sweeps and designs; here write its components");
    } else if (known.empty()) {
      add(mistakes_,
          at(step.spot, fmt::format("{} is asked of a list: write an index such as [0]", in_quotes(step.key))));
    } else {
      add(mistakes_, step.spot,
          fmt::format("{} is not an entry of the list{}", in_quotes(step.key), did_you_mean(step.key, known)));
    }
    return nullptr;
  }

  static std::optional<std::size_t> component(std::string_view key) {
    constexpr std::string_view letters = "xyz";
    return key.size() == 1 && letters.find(key) != std::string_view::npos ? std::optional(letters.find(key))
                                                                          : std::nullopt;
  }

  /// How many steps from `from` on are this name, which may have dots; 0: they are not.
  static std::size_t fits(std::string_view name, const std::vector<PathStep>& steps, std::size_t from) {
    std::string joined;
    for (std::size_t i = from; i < steps.size() && joined.size() < name.size(); ++i) {
      joined += (i == from ? "" : ".") + steps[i].key;
      if (joined == name) return i - from + 1;
    }
    return 0;
  }

  /// A value of a map; `i` moves behind its steps.
  Node* member(Node& map, const std::vector<PathStep>& steps, std::size_t& i) {
    const PathStep& step = steps[i++];
    if (map.kind == Node::Kind::map) {
      Entry* found = nullptr;
      std::size_t longest = 0;  // "a.b" before "a"
      for (Entry& e : map.entries) {
        const std::size_t count = step.key.empty() ? 0 : fits(e.key, steps, i - 1);
        if (count > longest) found = &e, longest = count;
      }
      if (found != nullptr) return i += longest - 1, &found->value;
      // a component of {body: .., at: [..]}
      Node* place = map.find("at");
      const bool asked = step.index || component(step.key);
      if (asked && place != nullptr && place->kind == Node::Kind::sequence) return item(*place, steps, --i);
      if (place != nullptr && place->kind == Node::Kind::map && place->find(step.key) != nullptr)
        return member(*place, steps, --i);
    }
    if (step.bracket && step.index) {
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
    map.entries.push_back({step.key, step.spot, {}});
    map.entries.back().value.spot = step.spot;
    return &map.entries.back().value;
  }

  const std::vector<std::string>& deck_keys_;
  Diagnostics& mistakes_;
  SourcePtr source_;
  std::shared_ptr<Source> source_of_value_;  ///< the same, until its reading is known
};

}  // namespace

void override_value(Document& document, const std::string& assignment, const std::vector<std::string>& deck_keys,
                    Diagnostics& mistakes) {
  Override(assignment, deck_keys, mistakes).apply(document);
}

}  // namespace taut::io
