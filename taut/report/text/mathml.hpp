#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "taut/calc/formula.hpp"

namespace taut::report {

/// What the leaves of a formula show: its symbols, or their values with six significant digits.
enum class Leaves { symbols, numbers };

/// A number as MathML: proper minus, powers of ten; π where it is that number exactly.
std::string number_mathml(double x);

/// The formula as the elements inside one <math>. `unknown`: this symbol stays a symbol among the numbers, as the
/// unknown of an equation does.
std::string to_mathml(const Formula& f, Leaves leaves, std::string_view unknown = {});

/// A part of a line, for a <math> of its own.
struct Piece {
  std::string mathml;
  double width = 0;  ///< estimated, in multiples of the font size
};

/// The formula in pieces between which a line may be broken: before the terms of a sum, before the factors of a
/// product, and inside a term that is wider than `most_width`, before its factors. One piece for anything else; none
/// for no formula.
std::vector<Piece> mathml_pieces(const Formula& f, Leaves leaves, std::string_view unknown = {},
                                 double most_width = 34);

}  // namespace taut::report
