#include "taut/app/explain/example_lines.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>
#include <vector>

#include "taut/app/embedded/design_examples.hpp"
#include "taut/app/embedded/examples.hpp"
#include "taut/app/embedded/machine_examples.hpp"
#include "taut/app/embedded/motion_examples.hpp"
#include "taut/app/explain/keys.hpp"
#include "taut/app/explain/terms.hpp"
#include "taut/io/deck/document.hpp"

namespace taut::app {
namespace {

/// A value on one line, as YAML writes it in flow style; empty where it is a map or holds one.
std::string flat(const io::Node& node) {
  using Kind = io::Node::Kind;
  if (node.kind == Kind::scalar) return node.quoted ? fmt::format("\"{}\"", node.text) : node.text;
  if (node.kind != Kind::sequence || node.items.empty()) return {};
  std::string text;
  for (const io::Node& item : node.items) {
    const std::string one = flat(item);
    if (one.empty()) return {};
    text += (text.empty() ? "" : ", ") + one;
  }
  return fmt::format("[{}]", text);
}

std::string trimmed(std::string line) {
  line.erase(0, line.find_first_not_of(" -"));
  const std::size_t comment = line.find(" #");
  if (comment != std::string::npos) line.resize(comment);
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

/// Every key of a deck by its path in the deck, "machine.reevings[].length".
using Lines = std::vector<std::pair<std::string, ExampleLine>>;

void collect(const io::Node& node, const std::string& path, const std::string& deck, Lines& lines) {
  for (const io::Entry& entry : node.entries) {
    const std::string below = path.empty() ? entry.key : path + "." + entry.key;
    const std::string value = flat(entry.value);
    const io::Spot& spot = entry.key_spot;
    lines.push_back(
        {below,
         {.text = value.empty() ? trimmed(spot.source->line(spot.offset)) : fmt::format("{}: {}", entry.key, value),
          .deck = deck}});
    collect(entry.value, below, deck, lines);
  }
  for (const io::Node& item : node.items) collect(item, path + "[]", deck, lines);
}

Lines lines_of_examples() {
  Lines lines;
  const auto add = [&lines](const auto& decks) {
    for (const auto& [file, text] : decks) {
      const std::string name(file);
      const auto document = io::parse(text, name);
      if (!document) continue;
      const io::Node* method = document->root.find("method");
      collect(document->root, method == nullptr ? std::string() : method->text, name, lines);
    }
  };
  add(embedded::examples);
  add(embedded::machine_examples);
  add(embedded::motion_examples);
  add(embedded::design_examples);
  return lines;
}

/// Whether a path of a deck, "sheaves.head.diameter", is one of the key "sheaves.NAME.diameter".
bool is_of_key(std::string_view path, std::string_view key) {
  while (true) {
    const std::size_t end = path.find('.'), end_of_key = key.find('.');
    const std::string_view word = key.substr(0, end_of_key);
    if (word != "NAME" && word != path.substr(0, end)) return false;
    const bool last = end == std::string_view::npos, last_of_key = end_of_key == std::string_view::npos;
    if (last || last_of_key) return last && last_of_key;
    path.remove_prefix(end + 1);
    key.remove_prefix(end_of_key + 1);
  }
}

/// From choices, unit, range and default alone.
std::string made_value(const Field& f, const std::string& given) {
  if (!f.choices.empty()) return f.choices.front();
  if (f.kind == FieldKind::flag) return "true";
  const bool number = f.kind == FieldKind::number || f.kind == FieldKind::numbers || f.kind == FieldKind::whole_number;
  if (!number) return {};
  if (given != "-" && given != "required") return given;
  if (f.kind == FieldKind::whole_number || !f.unit.needs_text()) return f.range.contains(1) ? "1" : std::string();
  return f.range.contains(0) || f.range.low == 0 ? fmt::format("1 {}", f.unit.shown) : std::string();
}

}  // namespace

ExampleLine example_line(const Term& key) {
  static const Lines lines = lines_of_examples();
  for (const auto& [path, line] : lines) {
    if (is_of_key(path, key.path)) return line;
  }
  const std::string value = made_value(*key.field, default_of(*key.description, *key.field));
  if (value.empty()) return {};
  return {.text = fmt::format("{}: {}", key.field->key, value), .deck = {}};
}

}  // namespace taut::app
