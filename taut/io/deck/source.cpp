#include "taut/io/deck/source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace taut::io {
namespace {

constexpr std::size_t longest_line = 100000;
constexpr std::size_t longest_quote = 60;

std::size_t line_start(std::string_view text, std::size_t offset) {
  if (offset == 0) return 0;
  const std::size_t before = text.rfind('\n', offset - 1);
  return before == std::string_view::npos ? 0 : before + 1;
}

unsigned char byte(std::string_view text, std::size_t at) {
  return at < text.size() ? static_cast<unsigned char>(text[at]) : static_cast<unsigned char>(0);
}

/// First bytes of a UTF-8 character, how many it has, and which second byte they take; all further ones are 80 to BF.
struct FirstByte {
  unsigned first, last;
  std::size_t length;
  unsigned second_low, second_high;
};
constexpr std::array<FirstByte, 8> first_bytes{
    {{.first = 0xC2U, .last = 0xDFU, .length = 2, .second_low = 0x80U, .second_high = 0xBFU},
     {.first = 0xE0U, .last = 0xE0U, .length = 3, .second_low = 0xA0U, .second_high = 0xBFU},  // less would be overlong
     {.first = 0xE1U, .last = 0xECU, .length = 3, .second_low = 0x80U, .second_high = 0xBFU},
     {.first = 0xEDU, .last = 0xEDU, .length = 3, .second_low = 0x80U, .second_high = 0x9FU},  // more would be a
                                                                                               // surrogate
     {.first = 0xEEU, .last = 0xEFU, .length = 3, .second_low = 0x80U, .second_high = 0xBFU},
     {.first = 0xF0U, .last = 0xF0U, .length = 4, .second_low = 0x90U, .second_high = 0xBFU},  // less would be overlong
     {.first = 0xF1U, .last = 0xF3U, .length = 4, .second_low = 0x80U, .second_high = 0xBFU},
     {.first = 0xF4U, .last = 0xF4U, .length = 4, .second_low = 0x80U, .second_high = 0x8FU}}};  // Unicode ends at
                                                                                                 // 10FFFF

/// Length of the UTF-8 character that begins here; 0 when it is not valid UTF-8 (overlong, surrogate, out of range).
std::size_t character_length(std::string_view text, std::size_t i) {
  const unsigned b = byte(text, i);
  if (b < 0x80U) return 1;
  const auto kind = std::find_if(first_bytes.begin(), first_bytes.end(),
                                 [&](const FirstByte& one) { return b >= one.first && b <= one.last; });
  if (kind == first_bytes.end()) return 0;
  const unsigned second = byte(text, i + 1);
  if (second < kind->second_low || second > kind->second_high) return 0;
  for (std::size_t k = 2; k < kind->length; ++k) {
    const unsigned next = byte(text, i + k);
    if (next < 0x80U || next > 0xBFU) return 0;
  }
  return kind->length;
}

/// What is wrong with the character at `i`; empty when nothing is.
std::string wrong_character(std::string_view text, std::size_t i, std::size_t length) {
  const unsigned b = byte(text, i);
  if (length == 0) return fmt::format("byte 0x{:02X} is not valid UTF-8: save the file as UTF-8 text", b);
  if (b == 0) return "a NUL byte: this is not a text file";
  if (b == '\r') {
    return byte(text, i + 1) == '\n' ? "" : "a carriage return alone: save the file with Unix or Windows line ends";
  }
  if ((b < 0x20U && b != '\t' && b != '\n') || b == 0x7FU) return fmt::format("control character 0x{:02X}", b);
  const unsigned second = byte(text, i + 1);
  if (b == 0xC2U && second < 0xA0U && second != 0x85U) return fmt::format("control character U+{:04X}", second);
  if (b == 0xEFU && second == 0xBFU && byte(text, i + 2) >= 0xBEU) return "a character that Unicode does not have";
  if (b == 0xEFU && second == 0xBBU && byte(text, i + 2) == 0xBFU) return "a byte order mark inside the text";
  return {};
}

std::size_t indentation(std::string_view line) { return std::min(line.find_first_not_of(" \t-"), line.size()); }

/// The line of a value, and what belongs to it: as far as it reaches, and the deeper lines below it.
std::string_view near(std::string_view text, std::size_t offset, std::size_t width) {
  const std::size_t from = line_start(text, std::min(offset, text.size()));
  std::size_t to = std::min(text.find('\n', std::min(offset + width, text.size())), text.size());
  const std::size_t own = indentation(text.substr(from, to - from));
  while (to < text.size()) {
    const std::size_t end = std::min(text.find('\n', to + 1), text.size());
    const std::string_view line = text.substr(to + 1, end - to - 1);
    if (indentation(line) <= own && indentation(line) < line.size()) break;
    to = end;
  }
  return text.substr(from, to - from);
}

/// Without what quoting, folding and cutting change.
std::string bare(std::string_view text) {
  std::string kept;
  for (const char c : text) {
    if (std::string_view(" \t\r\n'\"\\?").find(c) == std::string_view::npos) kept += c;
  }
  return kept;
}

/// The message with '...' for every text in quotes that stands in `hidden`, also for the last words of "not 5 m".
std::string without_words(const std::string& message, std::string_view hidden) {
  constexpr std::string_view cut = "...", instead = "'...'";
  const std::string there = bare(hidden);
  const auto stands_there = [&](std::string_view words) {
    if (words.ends_with(cut)) words.remove_suffix(cut.size());
    const std::string sought = bare(words);
    return sought.size() > 1 && there.find(sought) != std::string::npos;
  };
  const auto in_word = [&](std::size_t i) {
    return i < message.size() && std::isalnum(static_cast<unsigned char>(message[i])) != 0;
  };
  std::string shown;
  for (std::size_t i = 0; i < message.size();) {
    const bool opens = message[i] == '\'' && (i == 0 || !in_word(i - 1));
    std::size_t close = opens ? message.rfind('\'') : i;
    // the opening quote of the words behind closes nothing
    while (close > i && (in_word(close + 1) || !stands_there(std::string_view(message).substr(i + 1, close - i - 1)))) {
      close = message.rfind('\'', close - 1);
    }
    if (close > i) shown += instead;
    if (close == i) shown += message[i];
    i = close + 1;
  }
  constexpr std::string_view before = ", not ";
  const std::size_t last = shown.rfind(before);
  if (last == std::string::npos || !stands_there(std::string_view(shown).substr(last + before.size()))) return shown;
  return shown.substr(0, last + before.size()) + std::string(instead);
}

}  // namespace

Place Source::place(std::size_t offset) const {
  const std::size_t o = std::min(offset, text.size());
  const auto lines = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(o), '\n');
  return {.line = static_cast<int>(lines) + 1, .column = static_cast<int>(o - line_start(text, o)) + 1};
}

std::string Source::line(std::size_t offset) const {
  const std::size_t o = std::min(offset, text.size());
  const std::size_t from = line_start(text, o);
  const std::size_t to = std::min(text.find('\n', o), text.size());
  if (to - from > longest_line) return {};
  std::string found = text.substr(from, to - from);
  if (!found.empty() && found.back() == '\r') found.pop_back();
  return found;
}

Place Spot::place() const { return source->place(offset); }

Diagnostic without_text(Diagnostic mistake, const std::string& text) {
  std::size_t from = 0;
  for (int line = 1; line < mistake.place.line && from < text.size(); ++line) {
    from = std::min(text.find('\n', from), text.size() - 1) + 1;
  }
  mistake.message = without_words(mistake.message, near(text, from, 1));
  mistake.source_line.clear();
  return mistake;
}

Diagnostic at(const Spot& spot, std::string message) {
  const Source& source = *spot.source;
  if (source.named_by_deck) {
    return {.file = source.name,
            .place = spot.place(),
            .message = without_words(message, near(source.text, spot.offset, spot.width)),
            .source_line = {},
            .width = 1};
  }
  Diagnostic d{.file = source.name,
               .place = spot.place(),
               .message = std::move(message),
               .source_line = source.line(spot.offset),
               .width = 1};
  const auto column = static_cast<std::size_t>(d.place.column) - 1;
  const std::size_t room = d.source_line.size() > column ? d.source_line.size() - column : 1;
  d.width = static_cast<int>(std::clamp<std::size_t>(spot.width, 1, room));
  return d;
}

void add(Diagnostics& all, Diagnostic d) {
  if (enough(all)) return;
  if (all.size() + 1 == most_mistakes) d.message += " (the mistakes after this one are not shown)";
  all.push_back(std::move(d));
}

void add(Diagnostics& all, const Spot& spot, std::string message) {
  // finding the line takes time: not for what is not reported
  if (!enough(all)) add(all, at(spot, std::move(message)));
}

Diagnostics check_text(const SourcePtr& source) {
  const std::string_view text = source->text;
  if (text.size() > largest_deck) {
    const auto megabytes = largest_deck / 1024U / 1024U;
    return {Diagnostic{.file = source->name,
                       .place = {.line = 1, .column = 1},
                       .message = fmt::format("larger than {} MB, too large for a deck", megabytes),
                       .source_line = {},
                       .width = 1}};
  }
  const std::string_view head = text.substr(0, 2);
  if (head == "\xFF\xFE" || head == "\xFE\xFF") {
    return {Diagnostic{.file = source->name,
                       .place = {.line = 1, .column = 1},
                       .message = "this is UTF-16: save the file as UTF-8 text",
                       .source_line = {},
                       .width = 1}};
  }
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = character_length(text, i);
    const unsigned b = byte(text, i);
    const bool plain = b >= 0x20U && b < 0x7FU;
    std::string wrong = plain ? std::string{} : wrong_character(text, i, length);
    if (!wrong.empty()) return {at({.source = source, .offset = i, .width = 1}, std::move(wrong))};
    i += length;
  }
  return {};
}

std::string in_quotes(std::string_view text) {
  std::string shown(text.substr(0, longest_quote));
  if (text.size() > longest_quote) {
    while (!shown.empty() && (static_cast<unsigned char>(shown.back()) & 0xC0U) == 0x80U) shown.pop_back();
    if (!shown.empty() && static_cast<unsigned char>(shown.back()) >= 0xC0U) shown.pop_back();
    shown += "...";
  }
  std::replace_if(
      shown.begin(), shown.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20U; }, '?');
  return fmt::format("'{}'", shown);
}

}  // namespace taut::io
