#pragma once
#include <algorithm>
#include <string>

namespace taut::results {

/// What a picture shows, in the order in which it is wanted on page 1.
enum class Pictured { payload, load_path, motion, modes, machine, nothing };

/// The picture of page 1 so far.
struct KeyFigure {
  Pictured shows = Pictured::nothing;
  std::string name;  ///< of a figure of the result

  /// Takes the figure where it goes before the one that is there; of equals the first stays. One of an analysis that
  /// is not judged goes behind all that are.
  void offer(Pictured other, const std::string& figure, bool judged = true) {
    if (!judged) other = std::max(other, Pictured::machine);
    if (other >= shows || figure.empty()) return;
    shows = other;
    name = figure;
  }
};

}  // namespace taut::results
