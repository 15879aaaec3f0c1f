#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/base/long_rows.hpp"
#include "taut/solve/motion/transient.hpp"

namespace taut::study {

/// What is kept of a motion as it goes, so that its size in memory does not grow with its duration: the lines of its
/// series with their numbers (on disk where they are many), and the frames that pictures show: all of them, or of a
/// long motion every second, fourth, eighth one and so on, the first, the last and the one nearest to the largest
/// tension among them.
class TransientRecord {
 public:
  /// After an output step: TransientOptions::take.
  void take(const solve::TransientResult& so_far);

  /// Puts the frames and observed values that are shown into the result, in place of its first and last one.
  void show(solve::TransientResult& result) const;

  bool empty() const { return !lines_; }
  std::size_t count() const { return count_; }  ///< of the output steps
  /// t, then the observed quantities.
  const std::shared_ptr<LongRows>& lines() const { return lines_; }
  /// Kinetic, elastic, potential, supplied, dissipated, residual, J.
  const LongRows& energy() const { return *energy_; }

 private:
  struct Shown {
    solve::TransientFrame frame;
    Array<double> observed;
  };
  void follow_peak(const solve::TransientResult& so_far);
  void thin();

  std::size_t count_ = 0, every_ = 1, most_ = 0;
  std::shared_ptr<LongRows> lines_, energy_;
  Array<Shown> shown_;
  Shown peak_;  ///< nearest to the largest tension so far
  std::optional<double> t_peak_;
};

}  // namespace taut::study
