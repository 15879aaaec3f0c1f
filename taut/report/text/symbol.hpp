#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace taut::report {

/// The letter of a Greek name ("gamma" -> "γ", "Delta" -> "Δ"); empty when it is none.
std::string_view greek_letter(std::string_view name);

/// A source's symbol, taken apart: "gamma_span_sky" is γ with the subscripts "span" and "sky"; "S1" is S with "1";
/// "[sigma]" stands in brackets; "T'" has a prime; "F_0*" a star. A name of several letters that is no Greek one
/// ("branch_angle") is a word: it is not split.
struct Symbol {
  std::string base;                     ///< letters as shown
  std::vector<std::string> subscripts;  ///< as shown, without underscores
  std::string after;                    ///< primes or a star
  bool bracketed = false;
  bool is_word = false;
};
Symbol split_symbol(std::string_view name);

/// True for text that is meant as a symbol wherever it stands in a sentence: "R_sky", "T_max", "alpha", not "mast_1".
bool looks_like_symbol(std::string_view word);

/// A stretch of text with one style.
struct Run {
  enum class Style { plain, variable, subscript, subscript_variable };
  std::string text;
  Style style = Style::plain;
};
using Runs = std::vector<Run>;

Runs symbol_runs(std::string_view symbol);
/// A sentence with its symbols set as such ("R_sky", "alpha"); everything else stays as it is.
Runs prose_runs(std::string_view text);
/// A label of a drawing: like prose, but a text that is one name ("l", "S1"), or starts with one before " = ", is a
/// symbol too.
Runs label_runs(std::string_view text);

/// For a cell of a table: <math>, or plain text for a word.
std::string symbol_html(std::string_view symbol);
/// The elements inside <math>.
std::string symbol_mathml(std::string_view symbol);
/// <i> and <sub>.
std::string to_html(const Runs& runs);
/// <tspan>; to be put into one <text>.
std::string to_svg(const Runs& runs);

/// Shorthand for to_html(prose_runs(text)).
std::string prose_html(std::string_view text);

}  // namespace taut::report
