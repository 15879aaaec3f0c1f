#pragma once
#include <string>
#include <vector>

#include "taut/calc/figure.hpp"
#include "taut/report/text/quantity.hpp"

namespace taut::report {

/// One picture of a strip.
struct Moment {
  std::size_t frame = 0;  ///< index into Animation::t
  std::string words;      ///< "start; brake of winch set"; empty: a moment between
};

/// Four to six moments in order of time (fewer when the animation has fewer times): the first, the last, the one of the
/// largest tension, events, and moments in the middle of the longest gaps.
std::vector<Moment> moments_of(const Animation& animation);

/// The moments side by side as one static <svg>, to one scale, each with its time and its words.
/// Without two times or anything to draw: a paragraph that says so.
std::string strip_svg(const Animation& animation, const Display& display);

}  // namespace taut::report
