#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>

#include "taut/calc/progress.hpp"

namespace taut::app {

/// Tells how many cases are done, one thread at a time, and remembers that it shall end.
class CaseCounter {
 public:
  using Ask = std::function<bool(const Progress&)>;

  /// `what`: as in Progress. `most`: so many cases there are at most; the share that is done is one of these. `exact`:
  /// there are so many. An empty `ask` never ends. `ask` outlives it.
  CaseCounter(std::string what, std::uint64_t most, bool exact, const Ask& ask)
      : what_(std::move(what)), most_(most), exact_(exact), ask_(ask) {}

  /// After each case; false: it is to end. Where another thread is telling, this one does not wait.
  bool go_on();
  bool ended() const { return ended_; }

 private:
  std::string what_;
  std::uint64_t most_;
  bool exact_;
  const Ask& ask_;
  std::atomic<std::uint64_t> done_ = 0;
  std::atomic<bool> ended_ = false;
  std::mutex turn_;
};

}  // namespace taut::app
