#pragma once
#include <string>

#include "taut/calc/result.hpp"

namespace taut::report {

/// What the calculation starts from, as far as the deck gives it or a design has chosen it: one table for each kind of
/// part, and one for what stands alone.
std::string given_html(const Result& r);

/// The other inputs: each default once, with the parts that it applies to.
std::string defaults_html(const Result& r);

}  // namespace taut::report
