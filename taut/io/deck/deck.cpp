#include "taut/io/deck/deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "taut/base/suggest.hpp"
#include "taut/io/deck/include.hpp"
#include "taut/io/deck/override.hpp"
#include "taut/io/deck/parameters.hpp"
#include "taut/io/deck/read.hpp"
#include "taut/units/unit.hpp"

namespace taut::io {
namespace {

constexpr std::array block_keys = {"checks", "design", "study", "calibrate"};  // beside a machine or an input

void read_format(const Node& root, Diagnostics& mistakes) {
  const Node* n = root.find("taut");
  if (n == nullptr) {
    add(mistakes, root.spot, "the deck lacks 'taut: 1', the format it is written in");
  } else if (n->kind != Node::Kind::scalar || n->quoted || n->text != "1") {
    add(mistakes, n->spot, "taut: the format of a deck is 1; write 'taut: 1'");
  }
}

std::string read_title(const Node& root, Diagnostics& mistakes) {
  const Node* n = root.find("title");
  if (n == nullptr) return {};
  if (n->kind != Node::Kind::scalar)
    add(mistakes, n->spot, fmt::format("title: a text is expected, not {}", kind_text(*n)));
  return n->text;
}

Project read_project(const Node& root, Diagnostics& mistakes) {
  Project project;
  const Node* n = root.find("project");
  if (n != nullptr) read(*n, Project::describe(), &project, "project", mistakes);
  return project;
}

std::string read_method(const Node& root, const std::vector<std::string>& methods, Diagnostics& mistakes) {
  const Node* n = root.find("method");
  const std::string choices = fmt::format("{}", fmt::join(methods, ", "));
  if (n == nullptr) {
    add(mistakes, root.spot, fmt::format("the deck lacks 'method', one of {}, or a 'machine'", choices));
    return {};
  }
  if (n->kind != Node::Kind::scalar) {
    add(mistakes, n->spot, fmt::format("method: one of {} is expected, not {}", choices, kind_text(*n)));
    return {};
  }
  if (std::find(methods.begin(), methods.end(), n->text) != methods.end()) return n->text;
  const std::string hint = did_you_mean(n->text, methods);
  add(mistakes, n->spot,
      fmt::format("there is no method {}{}", in_quotes(n->text),
                  hint.empty() ? fmt::format("; the methods are {}", choices) : hint));
  return {};
}

Node read_input(const Node& root, bool has_method, Diagnostics& mistakes) {
  const Entry* e = root.find_entry("input");
  Node empty;
  empty.kind = Node::Kind::map;
  empty.spot = e != nullptr ? e->key_spot : root.spot;
  if (e == nullptr) {
    // with a method the fields that it needs are reported one by one
    if (!has_method) add(mistakes, root.spot, "the deck lacks 'input', the data of the method");
    return empty;
  }
  return e->value.kind == Node::Kind::null ? empty : e->value;
}

/// The keys of a machine's deck as the one map that is read.
Node read_machine(const Node& root, Diagnostics& mistakes) {
  Node both;
  both.kind = Node::Kind::map;
  both.spot = root.spot;
  for (const Entry& e : root.entries) {
    const bool block = std::find(block_keys.begin(), block_keys.end(), e.key) != block_keys.end();
    if (e.key == "machine" || e.key == "analyses" || block) both.entries.push_back(e);
    if (e.key != "method" && e.key != "input") continue;
    add(mistakes, e.key_spot, fmt::format("'{}' belongs to a published method; this deck has a machine", e.key));
  }
  return both;
}

}  // namespace

Display read_display(const Node& root, Diagnostics& mistakes) {
  const Node* n = root.find("display");
  if (n == nullptr) return {};
  if (n->kind != Node::Kind::map) {
    add(mistakes, n->spot,
        fmt::format("display: a map of kinds and units is expected, such as "
                    "'{{force: kN, length: mm}}', not {}",
                    kind_text(*n)));
    return {};
  }
  std::map<std::string, std::string> units;
  for (const Entry& e : n->entries) {
    if (enough(mistakes)) break;
    if (e.value.kind != Node::Kind::scalar) {
      add(mistakes, e.value.spot, fmt::format("display: a unit is expected, not {}", kind_text(e.value)));
      continue;
    }
    if (e.key == si::rad.kind && e.value.text == "%") {  // of a wrap of 180 deg that would be 0
      add(mistakes, e.value.spot,
          "display: '%' shows slopes, and most angles are none: angles are shown in deg, rad, mrad or gon");
      continue;
    }
    const auto checked = check_display(e.key, e.value.text);
    if (checked) {
      units[e.key] = e.value.text;
      continue;
    }
    const DisplayError& error = checked.error();
    const Spot spot =
        error.of_kind ? e.key_spot
                      : e.value.inside(static_cast<std::size_t>(error.offset), static_cast<std::size_t>(error.width));
    add(mistakes, spot, fmt::format("display: {}", error.message));
  }
  return Display(units);
}

const std::vector<std::string>& deck_keys() {
  static const std::vector<std::string> keys = {"taut",    "title",      "project", "method",   "display",
                                                "include", "parameters", "input",   "machine",  "analyses",
                                                "checks",  "design",     "study",   "calibrate"};
  return keys;
}

Deck read_deck(const Document& document, const std::vector<std::string>& methods, Diagnostics& mistakes) {
  Deck deck;
  if (document.source) deck.reading = document.source->reading;
  const Node& root = document.root;
  if (root.kind != Node::Kind::map) {
    add(mistakes, root.spot, fmt::format("a deck is a map, beginning with 'taut: 1'; this is {}", kind_text(root)));
    deck.input.kind = Node::Kind::map;
    deck.input.spot = root.spot;
    return deck;
  }
  for (const Entry& e : root.entries) {
    if (enough(mistakes)) break;
    if (std::find(deck_keys().begin(), deck_keys().end(), e.key) != deck_keys().end()) continue;
    std::string hint = did_you_mean(e.key, deck_keys());
    if (hint.empty()) hint = fmt::format("; it has {}", fmt::join(deck_keys(), ", "));
    add(mistakes, e.key_spot, fmt::format("{} is not a key of a deck{}", in_quotes(e.key), hint));
  }
  read_format(root, mistakes);
  deck.title = read_title(root, mistakes);
  deck.project = read_project(root, mistakes);
  deck.display = read_display(root, mistakes);
  if (const Node* parameters = root.find("parameters")) deck.parameters = *parameters;
  deck.is_machine =
      root.find("machine") != nullptr || (root.find("analyses") != nullptr && root.find("method") == nullptr);
  if (deck.is_machine) {
    deck.input = read_machine(root, mistakes);
    return deck;
  }
  if (const Entry* e = root.find_entry("analyses")) {
    add(mistakes, e->key_spot, "'analyses' belong to a machine; a published method has its 'input' alone");
  }
  for (const char* key : block_keys) {
    const Entry* e = root.find_entry(key);
    if (e == nullptr) continue;
    if (!deck.others) {
      deck.others.emplace();
      deck.others->kind = Node::Kind::map;
      deck.others->spot = e->key_spot;
    }
    deck.others->entries.push_back(*e);
  }
  deck.method = read_method(root, methods, mistakes);
  deck.input = read_input(root, !deck.method.empty(), mistakes);
  return deck;
}

std::optional<Document> read_document(std::string_view text, const std::string& name,
                                      const std::vector<std::string>& set, Diagnostics& mistakes, FileReader read) {
  auto document = parse(text, name);
  if (!document) {
    for (Diagnostic& d : document.error()) add(mistakes, std::move(d));
    return std::nullopt;
  }
  for (Diagnostic& d : document->mistakes) add(mistakes, std::move(d));
  document->source->reading->read = std::move(read);
  if (!resolve_includes(*document, mistakes)) return std::nullopt;
  for (const std::string& one : set) override_value(*document, one, deck_keys(), mistakes);
  return std::move(*document);
}

std::optional<Deck> read_deck(std::string_view text, const std::string& name, const std::vector<std::string>& set,
                              const std::vector<std::string>& methods, Diagnostics& mistakes, FileReader read) {
  auto document = read_document(text, name, set, mistakes, std::move(read));
  if (!document) return std::nullopt;
  resolve_parameters(*document, mistakes);
  // a deck that is not even a map has reported its one mistake
  if (document->root.kind != Node::Kind::map) {
    read_deck(*document, methods, mistakes);
    return std::nullopt;
  }
  return read_deck(*document, methods, mistakes);
}

}  // namespace taut::io
