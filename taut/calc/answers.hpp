#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "taut/calc/result.hpp"

/// The lines of a main answer, as all kinds of calculation make them.
namespace taut {

/// Labels of lines with a meaning for the order and the verdict. Other labels name what the line speaks of, "Motion".
inline constexpr std::string_view carries_label = "Carries";
inline constexpr std::string_view build_label = "Build";      ///< found by the calculation, passes its checks
inline constexpr std::string_view nearest_label = "Nearest";  ///< found, but it does not pass
inline constexpr std::string_view given_label = "Given";      ///< not found: the deck gives it
inline constexpr std::string_view needs_label = "Needs";      ///< asked for by the calculation, still to be chosen
inline constexpr std::string_view uses_label = "Uses";        ///< utilisations by part, where no table shows them

inline constexpr std::size_t most_answers = 8;
inline constexpr std::size_t longest_answer = 200;  ///< characters

/// Adds a line made of parts, "a; b; c"; empty ones are left out. Parts for which the line has no room are counted: "a;
/// b; 3 more".
void add_answer_line(Result& r, std::string_view label, const std::vector<std::string>& parts);

/// Cells by the name of their column; NaN and empty: no such row or column, or no value there.
double number_in(const Table& t, std::size_t row, std::string_view column);
std::string text_in(const Table& t, std::size_t row, std::string_view column);

/// The number of a value; NaN: there is none of that name.
double number_of(const Result& r, const std::string& value);

/// Completes the answer of a whole result, once: "Build" becomes "Nearest" where the verdict fails or there is no
/// answer, and "Given" where it is not judged; what is carried and what is built come first; the last line, "Uses",
/// has the largest utilisation of each part; at most `most_answers` lines.
void finish_answers(Result& r);

}  // namespace taut
