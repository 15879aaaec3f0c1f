#pragma once
#include <string>

namespace taut {

/// Progress of a long calculation.
struct Progress {
  std::string what;   ///< "transient"
  double done = 0;    ///< 0 .. 1
  std::string words;  ///< "t = 1.2 s of 10 s"
  bool last = false;  ///< what follows, checks and pictures, asks no more whether to go on
};

}  // namespace taut
