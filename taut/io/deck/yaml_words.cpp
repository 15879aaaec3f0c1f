#include "taut/io/deck/yaml_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace taut::io {
namespace {

using Row = std::pair<std::string_view, std::string_view>;

/// Beginning of a scanner's message -> what to tell.
constexpr std::array<Row, 26> rows = {{
    {"illegal map value",
     "a ':' can't stand here: check the indentation and the line above, and quote a text that contains ': '"},
    {"illegal map key", "a key can't stand here: check the indentation"},
    {"illegal block entry", "a '-' can't stand here: begin a list on its own line, or write [a, b]"},
    {"illegal flow end", "a closing bracket without an opening one"},
    {"end of map not found", "this can't follow here: check the indentation, and the quotes before it"},
    {"end of map flow not found", "a '}' or ',' is missing before this"},
    {"end of sequence not found", "this does not belong to the list above: check the indentation and the '-'"},
    {"end of sequence flow not found", "a ']' or ',' is missing before this"},
    {"illegal tab", "a tab in the indentation: use spaces"},
    {"illegal EOF in scalar", "a quoted text that is never closed"},
    {"illegal document indicator in scalar", "a quoted text is not closed before '---' or '...'"},
    {"unknown escape character", "an unknown escape in a text with double quotes: write '\\\\' for a backslash"},
    {"bad character found while scanning hex number", "a bad number of a character behind a backslash"},
    {"invalid unicode", "a character that Unicode does not have behind a backslash"},
    {"unknown token", "a value can't begin with this character: put the text in quotes"},
    {"cannot set zero indentation", "a block text can't have the indentation 0"},
    {"unexpected character in block scalar", "only a comment may follow '|' or '>' on its line"},
    {"the referenced anchor is not defined",
     "aliases (*) are not used in decks: write the value out, or quote the text"},
    {"alias not found", "aliases (*) are not used in decks: quote a text that begins with '*'"},
    {"illegal character found while scanning alias",
     "aliases (*) are not used in decks: quote a text that begins with '*'"},
    {"anchor not found", "anchors (&) are not used in decks: quote a text that begins with '&'"},
    {"illegal character found while scanning anchor",
     "anchors (&) are not used in decks: quote a text that begins with '&'"},
    {"cannot assign multiple", "anchors (&), aliases (*) and tags (!) are not used in decks"},
    {"aliases can't have", "aliases (*) are not used in decks"},
    {"tag handle", "tags (!) are not used in decks: quote a text that begins with '!'"},
    {"end of verbatim tag", "tags (!) are not used in decks: quote a text that begins with '!'"},
}};

/// Whether the line up to `offset` is indented with a tab.
bool tab_before(std::string_view text, std::size_t offset) {
  std::size_t from = offset == 0 ? std::string_view::npos : text.rfind('\n', offset - 1);
  from = from == std::string_view::npos ? 0 : from + 1;
  while (from < text.size() && text[from] == ' ') ++from;
  return from < text.size() && text[from] == '\t';
}

std::string words(std::string_view message) {
  const auto row = std::find_if(rows.begin(), rows.end(),
                                [&](const Row& r) { return message.substr(0, r.first.size()) == r.first; });
  return row != rows.end() ? std::string(row->second) : fmt::format("not YAML: {}", message);
}

}  // namespace

Diagnostic yaml_mistake(const SourcePtr& source, std::size_t offset, std::string_view scanner_message) {
  const std::string_view text = source->text;
  const std::size_t at_byte = std::min(offset, text.size());
  if (tab_before(text, at_byte) && scanner_message.find("scalar") == std::string_view::npos) {
    std::size_t tab = at_byte == 0 ? std::string_view::npos : text.rfind('\n', at_byte - 1);
    tab = text.find('\t', tab == std::string_view::npos ? 0 : tab + 1);
    return at({.source = source, .offset = tab, .width = 1}, "a tab in the indentation: use spaces");
  }
  return at({.source = source, .offset = at_byte, .width = 1}, words(scanner_message));
}

}  // namespace taut::io
