#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

#include "cli/say.hpp"
#include "cli/verbs.hpp"

namespace taut::cli {
namespace {

volatile std::sig_atomic_t somebody_asks = 0;
volatile std::sig_atomic_t asked_to_end = 0;

/// Files are moved into place only when whole, so an interrupt may end the program at once.
extern "C" void on_interrupt(int) {
  if (somebody_asks == 0 || asked_to_end != 0) _exit(interrupted);
  asked_to_end = 1;
}

std::string time_words(double seconds) {
  if (seconds < 90) return fmt::format("{:.0f} s", seconds);
  if (seconds < 5400) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

}  // namespace

void take_interrupts() {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);  // a cluster that takes its time back asks so
}

InterruptHeld::InterruptHeld() { somebody_asks = 1; }
InterruptHeld::~InterruptHeld() { somebody_asks = 0; }
bool InterruptHeld::goes_on() { return asked_to_end == 0; }

bool ProgressLine::operator()(const taut::Progress& progress) {
  if (progress.last) {
    somebody_asks = 0;
    return asked_to_end == 0;
  }
  const Clock::time_point now = Clock::now();
  if (somebody_asks == 0) {
    somebody_asks = 1;
    first_ = last_ = now;
    first_done_ = progress.done;
  }
  const std::chrono::duration<double> since_last = now - last_, since_first = now - first_;
  constexpr double pause = 0.2;
  if (shown_ && since_last.count() > pause && progress.done > first_done_) {
    last_ = now;
    printed_ = true;
    const double left = since_first.count() * (1 - progress.done) / (progress.done - first_done_);
    say("\r\033[K{}: {} ({:.0f} %), about {} left", progress.what, progress.words, 100 * progress.done,
        time_words(left));
    std::fflush(stderr);
  }
  return asked_to_end == 0;
}

void ProgressLine::clear() {
  if (printed_) say("\r\033[K");
  printed_ = false;
  somebody_asks = 0;
}

}  // namespace taut::cli
