#pragma once
#include <string_view>

#include "taut/report/text/symbol.hpp"

namespace taut::report {

/// Width of a text in pixels when its letters are `font_size` pixels high, on the safe side: the widths of Helvetica's
/// letters (Adobe's font metrics, which Arial and Liberation Sans share) and 8 % more; a letter that is not in that
/// table counts as a wide one.
double text_width(std::string_view utf8, double font_size);

/// The same for a label: subscripts are smaller, variables stand in the italic letters of the formula font.
double text_width(const Runs& runs, double font_size);

/// How far a line of text with this size reaches above and below its base line, subscripts included.
double ascent(double font_size);
double descent(double font_size);

}  // namespace taut::report
