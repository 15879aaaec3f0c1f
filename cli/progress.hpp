#pragma once
#include <chrono>

#include "taut/app/job.hpp"

namespace taut::cli {

/// From now on an interrupt (Ctrl-C, SIGTERM) ends the program with exit code 130: at once, or while a calculation asks
/// whether to go on (ProgressLine, up to Progress::last), as soon as it has kept what is done. A second one always ends
/// it at once.
void take_interrupts();

/// While it lives, an interrupt does not end the program: what works asks `goes_on` and ends by itself.
class InterruptHeld {
 public:
  InterruptHeld();
  ~InterruptHeld();
  InterruptHeld(const InterruptHeld&) = delete;
  InterruptHeld& operator=(const InterruptHeld&) = delete;
  static bool goes_on();  ///< no interrupt has come since the program began
};

/// Says on standard error how far a calculation is and how long it may still take, a few times a second, and whether to
/// go on.
class ProgressLine {
 public:
  explicit ProgressLine(bool shown) : shown_(shown) {}  ///< `shown`: false keeps it silent
  bool operator()(const taut::Progress& progress);
  void clear();  ///< takes the line away again

 private:
  using Clock = std::chrono::steady_clock;
  bool shown_ = false;
  bool printed_ = false;
  double first_done_ = 0;
  Clock::time_point first_, last_;
};

}  // namespace taut::cli
