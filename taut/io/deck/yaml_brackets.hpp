#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace taut::io {

/// What a text opens and never closes.
struct Unclosed {
  std::size_t offset = 0;  ///< of the bracket or quote
  std::string words;
};

/// The first bracket of a YAML text that is never closed, or is closed by another kind; empty where each has its other
/// half. The scanner says a missing bracket only where it can't go on, lines later. Brackets in quotes, comments, block
/// texts (| and >) and within words don't count.
std::optional<Unclosed> unclosed_bracket(std::string_view text);

/// A quoted text that ends in a later line, before `offset` and nearest to it: where the scanner stumbles behind one,
/// its closing quote is missing, and the next one was taken for it.
std::optional<Unclosed> long_quote_before(std::string_view text, std::size_t offset);

}  // namespace taut::io
