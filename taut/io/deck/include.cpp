#include "taut/io/deck/include.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>
#include <unordered_map>
#include <utility>
#include <vector>

#include "taut/io/file.hpp"

namespace taut::io {
namespace {

namespace fs = std::filesystem;

/// The same file under any of its names.
std::string identity(const fs::path& path) {
  std::error_code failed;
  const fs::path found = fs::weakly_canonical(path, failed);
  return failed ? path.string() : found.string();
}

class Includer {
 public:
  explicit Includer(Diagnostics& mistakes) : mistakes_(mistakes) {}

  /// Resolves the includes of one file's root.
  void resolve(Node& root, const fs::path& file) {
    if (root.kind != Node::Kind::map) return;
    const Node* found = root.find("include");
    if (found == nullptr) return;
    const Node include = *found;
    std::erase_if(root.entries, [](const Entry& e) { return e.key == "include"; });
    under_way_.push_back(identity(file));
    Node under;
    under.kind = Node::Kind::map;
    under.spot = root.spot;
    for (const Node* one : paths(include)) {
      const fs::path path = file.parent_path() / one->text;
      auto part = read_part(*one, path);
      whole_ = whole_ && part.has_value();
      if (part) under = merge(std::move(under), *part);
    }
    under_way_.pop_back();
    root = merge(std::move(under), root);
  }

  bool whole() const { return whole_; }

 private:
  std::vector<const Node*> paths(const Node& include) {
    std::vector<const Node*> all;
    const bool list = include.kind == Node::Kind::sequence;
    const std::size_t count = list ? include.items.size() : 1;
    for (std::size_t i = 0; i < count; ++i) {
      const Node& one = list ? include.items[i] : include;
      const bool usable = one.kind == Node::Kind::scalar && !one.text.empty();
      if (usable) {
        all.push_back(&one);
      } else {
        whole_ = false;
        add(mistakes_, one.spot,
            fmt::format("include: the path of a deck, or a list of them, is expected, not {}",
                        one.kind == Node::Kind::scalar ? "an empty text" : kind_text(one)));
      }
    }
    return all;
  }

  std::optional<Node> fail(const Node& place, std::string message) {
    add(mistakes_, place.spot, fmt::format("include: {}", message));
    return std::nullopt;
  }

  std::optional<Node> read_part(const Node& place, const fs::path& path) {
    const std::string self = identity(path);
    for (const std::string& above : under_way_) {
      if (above == self) return fail(place, fmt::format("{} includes itself", in_quotes(path.string())));
    }
    if (under_way_.size() > static_cast<std::size_t>(deepest_include)) {
      return fail(place, fmt::format("more than {} decks inside each other", deepest_include));
    }
    if (++files_ > most_includes) {
      return files_ == most_includes + 1 ? fail(place, fmt::format("more than {} decks in all", most_includes))
                                         : std::nullopt;
    }
    const auto source = read_source(place, path);
    if (!source) return std::nullopt;
    bytes_ += source->text.size();
    if (bytes_ > largest_deck) return fail(place, "more than 16 MB of included decks");
    auto document = parse(source->text, source);
    for (Diagnostic& d : document ? document->mistakes : document.error()) add(mistakes_, std::move(d));
    if (!document) return std::nullopt;
    if (document->root.kind != Node::Kind::map) {
      return fail(place, fmt::format("{} is {}, not a map", in_quotes(path.string()), kind_text(document->root)));
    }
    resolve(document->root, path);
    return std::move(document->root);
  }

  SourcePtr read_source(const Node& place, const fs::path& path) {
    auto text = read_beside(*place.spot.source, path.string());
    if (!text) {
      // of a file that the deck includes the place alone is shown: it may be no deck at all
      const std::string why = under_way_.size() > 1 ? "the file named here can't be read" : text.error().message;
      Diagnostic mistake = at(place.spot, fmt::format("include: {}", why));
      mistake.unreadable_file = !text.error().missing;
      add(mistakes_, std::move(mistake));
      return nullptr;
    }
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    auto source = std::make_shared<Source>();
    source->name = path.string();
    source->reading = place.spot.source->reading;
    source->named_by_deck = true;
    if (source->reading) source->reading->texts.push_back(*text);
    source->text = text->starts_with(byte_order_mark) ? text->substr(byte_order_mark.size()) : std::move(*text);
    return source;
  }

  Diagnostics& mistakes_;
  bool whole_ = true;  ///< no file was left out
  std::vector<std::string> under_way_;
  int files_ = 0;
  std::size_t bytes_ = 0;
};

/// "contacts+: [...]" adds to the list `contacts` of the deck below; where it has none this is the list. One value
/// without brackets is a list of one.
void append_to_list(Node& under, const Entry& more, std::unordered_map<std::string, std::size_t>& index) {
  const std::string key = more.key.substr(0, more.key.size() - 1);
  const auto below = index.find(key);
  if (below == index.end()) {
    index.emplace(key, under.entries.size());
    under.entries.push_back({key, more.key_spot, more.value});
    return;
  }
  Node& list = under.entries[below->second].value;
  if (list.kind == Node::Kind::scalar) {
    Node one = list;
    list = more.value;
    list.items.insert(list.items.begin(), std::move(one));
  } else if (list.kind == Node::Kind::sequence) {
    list.items.insert(list.items.end(), more.value.items.begin(), more.value.items.end());
  } else {
    list = more.value;
  }
}

bool adds_to_list(const Entry& e) {
  return e.key.size() > 1 && e.key.back() == '+' && e.value.kind == Node::Kind::sequence;
}

}  // namespace

Node merge(Node under, const Node& over) {
  if (under.kind != Node::Kind::map || over.kind != Node::Kind::map) return over;
  std::unordered_map<std::string, std::size_t> index;
  for (std::size_t i = 0; i < under.entries.size(); ++i) index.emplace(under.entries[i].key, i);
  for (const Entry& e : over.entries) {
    if (adds_to_list(e)) continue;
    const auto below = index.find(e.key);
    if (below == index.end()) {
      index.emplace(e.key, under.entries.size());
      under.entries.push_back(e);
      continue;
    }
    Entry& mine = under.entries[below->second];
    mine.value = merge(std::move(mine.value), e.value);
    mine.key_spot = e.key_spot;
  }
  // behind all lists that are replaced, in whatever order the keys stand
  for (const Entry& e : over.entries) {
    if (adds_to_list(e)) append_to_list(under, e, index);
  }
  // what is missing in the whole is reported in the deck that the user runs
  under.spot = over.spot;
  return under;
}

bool resolve_includes(Document& document, Diagnostics& mistakes) {
  Includer includer(mistakes);
  includer.resolve(document.root, document.source->name);
  return includer.whole();
}

}  // namespace taut::io
