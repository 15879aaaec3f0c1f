#pragma once
#include <string>
#include <vector>

#include "taut/calc/figure.hpp"
#include "taut/report/text/quantity.hpp"

namespace taut::report {

/// Any figure as one static <svg> (a paragraph that says so when there is nothing to show): a drawing, a plot, a
/// profile, or of an animation a strip of four to six moments. No script, no id: the same figure may stand twice in a
/// page.
std::string figure_svg(const Figure& figure, const Display& display);

/// What the figures of a page so far have shown.
struct FiguresAbove {
  int animations = 0;               ///< number of the next one
  std::vector<std::string> listed;  ///< events below the last plot that lists any
};

/// The same where the report plays it: an animation with its button and slider. Plots with the same events list them
/// once.
std::string live_figure(const Figure& figure, const Display& display, FiguresAbove& above);

/// Whether it has a turned page of its own.
bool is_turned(const Figure& figure);

struct FigureWords {
  std::string name;
  std::string title;
  std::string caption;
  std::string scale;  ///< what it says of its scales; may be empty
  std::string csv;    ///< file of its data; empty: none
};
FigureWords words_of(const Figure& figure);

}  // namespace taut::report
