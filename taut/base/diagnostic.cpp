#include "taut/base/diagnostic.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace taut {
namespace {

constexpr std::size_t longest_line_shown = 160;

bool continues_a_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// White space that is as wide as `text` on a terminal: one column per UTF-8 character, tabs kept.
std::string blank_like(const std::string& text) {
  std::string blank;
  for (char c : text) {
    if (!continues_a_character(c)) blank += c == '\t' ? '\t' : ' ';
  }
  return blank;
}

std::string printable(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20U && c != '\t'; }, '?');
  return text;
}

}  // namespace

std::string to_text(const Diagnostic& d) {
  std::string text = d.place.line > 0
                         ? fmt::format("{}:{}:{}: error: {}\n", d.file, d.place.line, d.place.column, d.message)
                         : fmt::format("{}: error: {}\n", d.file, d.message);
  if (d.place.line <= 0 || d.source_line.empty()) return text;
  const auto column = static_cast<std::size_t>(std::max(1, d.place.column) - 1);
  const std::size_t at = std::min(column, d.source_line.size());
  std::size_t from = at > longest_line_shown / 2 ? at - longest_line_shown / 2 : 0;
  while (from > 0 && continues_a_character(d.source_line[from])) --from;
  const std::string line = printable(d.source_line.substr(from, longest_line_shown));
  const std::string lead = blank_like(line.substr(0, at - from));
  const auto room = line.size() > at - from ? line.size() - (at - from) : std::size_t{1};
  const std::size_t width = std::clamp<std::size_t>(static_cast<std::size_t>(std::max(1, d.width)), 1, room);
  text += fmt::format("  {}\n  {}^{}\n", line, lead, std::string(width - 1, '~'));
  return text;
}

bool only_unreadable_files(const Diagnostics& all) {
  return !all.empty() && std::all_of(all.begin(), all.end(), [](const Diagnostic& d) { return d.unreadable_file; });
}

std::string to_text(const Diagnostics& all) {
  std::string text;
  for (const Diagnostic& d : all) text += to_text(d);
  return text;
}

}  // namespace taut
