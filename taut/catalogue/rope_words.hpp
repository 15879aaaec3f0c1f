#pragma once
#include <string>

#include "taut/catalogue/rope_search.hpp"

namespace taut::catalogue {

/// What the words name: "6x36-IWRC 16 mm 1960 MPa", in any order, with a standard or without. A length is the diameter,
/// a stress the grade; what is neither size, core nor construction belongs to the standard's name.
RopeDescription describe_rope(const std::string& words);

/// "EN 12385-4 6x36-IWRC 16 mm 1960 MPa": words that describe_rope understands, for people.
std::string words_of_rope(const RopeRow& row);

/// A rope by its id, or by words: construction, core, diameter and grade. Spaces and case don't count.
Found<RopeRow> find_rope_in_words(const std::string& text, const std::vector<RopeRow>& table = ropes());

}  // namespace taut::catalogue
