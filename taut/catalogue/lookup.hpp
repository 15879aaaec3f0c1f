#pragma once
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace taut::catalogue {

/// Why a row was not found, in words for the user's eyes, and what to write instead.
struct LookupError {
  std::string message;                  ///< says what was asked for and what there is
  std::vector<std::string> candidates;  ///< texts that would be found, the most likely first; may be empty
};

/// A row, or why there is none.
template <class Row>
using Found = tl::expected<Row, LookupError>;

tl::unexpected<LookupError> failure(std::string message, std::vector<std::string> candidates);

/// How many candidates a message names.
inline constexpr std::size_t suggested = 5;

/// The message, and the candidates on the same line: `no steel 'S350'; did you mean 'S355' or 'S235'?`
std::string to_text(const LookupError& error);

/// `name` for comparison: lower case, no spaces, `×` and Cyrillic `х` as `x`, `–` as `-`. Other bytes stay as they are.
std::string normalised(std::string_view name);

/// Whether `name` normalised is `wanted`, which is normalised. Makes no text: a study asks for thousands of rows.
bool is_named(std::string_view name, std::string_view wanted);

/// Up to `count` of `names` that are nearest to `word` by edits, nearest first, ties in the order given; those that
/// have little in common with it (more than half differs) are left out.
std::vector<std::string> nearest_names(std::string_view word, const std::vector<std::string>& names, std::size_t count);

/// `text` in single quotes for a message: cut after 60 bytes (never within a character), control characters as '?'.
std::string in_quotes(std::string_view text);

/// `a number` as a table prints it: at most 6 significant digits, no trailing zeros. For messages.
std::string short_number(double value);

/// "a, b, c" of at most `count` texts; the rest as "and 12 more".
std::string listed(const std::vector<std::string>& texts, std::size_t count = 8);

}  // namespace taut::catalogue
