#pragma once
#include <string>

#include "taut/calc/figure.hpp"
#include "taut/report/text/quantity.hpp"

namespace taut::report {

/// Any figure as it stands still, for print: an <svg>, of an animation with the readings of its first time. Empty:
/// there is nothing to draw.
std::string still_figure(const Figure& figure, const Display& display);

/// The same where the report plays it: an animation with its button and slider. `number`: of the animations in the
/// page, from 0; raised by each.
std::string live_figure(const Figure& figure, const Display& display, int& number);

struct FigureWords {
  std::string name;
  std::string title;
  std::string caption;
  std::string scale;  ///< what a drawing says of its scales; may be empty
  std::string csv;    ///< file of its data; empty: none
};
FigureWords words_of(const Figure& figure);

}  // namespace taut::report
