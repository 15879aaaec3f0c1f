#pragma once
#include <string>
#include <vector>

#include "taut/calc/result.hpp"

namespace taut::report {

/// What the margins leave of a page in print, mm; A4 by default.
struct PrintedSheet {
  double width = 176, height = 258;
};

struct PageOne {
  std::string html;
  std::vector<const Figure*> figures;  ///< those that it shows
};

/// Page 1, what an engineer signs: project, verdict, what to build or what it carries, the key picture, the
/// utilisations by part, the gravest warnings, and the line of the signature. Every text is bounded, so that all of it
/// is one page in print; the key picture takes the room that is left, with a plot below it where that is much, and
/// stands away where it is too little. A bad deck shows its mistakes.
PageOne page_one(const Result& r, const PrintedSheet& sheet = {});

/// Texts of page 1 that are shortened there, in full; empty when none is.
std::string full_texts_html(const Result& r);

/// The title of the result, else that of its method.
std::string title_of(const Result& r);

/// The mistakes of a deck with their lines, at most `most` of them.
std::string errors_html(const Result& r, std::size_t most);

}  // namespace taut::report
