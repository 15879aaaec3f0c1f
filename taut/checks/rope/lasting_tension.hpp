#pragma once
#include <deque>

namespace taut::checks {

/// The largest tension that a rope of a motion has without a break for a while: what counts as a tension at rest,
/// beside that before the motion. It is the largest T for which some interval of `lasts` has no tension below T. In an
/// interval that is longer than a swing the tension is below its mean at times, so it is never more than the tension
/// that the same load would give at rest.
///
/// A load that comes and goes within `lasts` leaves no trace in that. The mean over such an interval shows it: swings
/// that are shorter go as far above the tension at rest as below, so that a mean beyond it is one of a load. Its limit:
/// of a load that stays for a part of the interval it has that part; and a swing whose tension takes longer than 5 s,
/// as of a pendulum of more than 25 m, raises it too. So it tells that the tension at rest is not known, and not what
/// it is.
class LastingTension {
 public:
  static constexpr double lasts = 5;   ///< s; most swings of ropes and loads on them are shorter
  static constexpr double gap = 0.25;  ///< s; without a moment for longer, several steps of the motion say nothing

  /// A moment, s, N, after so many steps of the motion. One that is not after the last one begins a new motion.
  void take(double t, double T, long steps);
  double largest() const { return largest_; }      ///< N; 0: none has lasted
  double when() const { return when_; }            ///< where that interval ends, s
  double mean() const { return mean_; }            ///< the largest mean over `lasts`, N; 0: no motion was so long
  double when_mean() const { return when_mean_; }  ///< where that interval ends, s
  /// The largest mean from some moment to the last one, of all in the interval that are at least `gap` before it, N:
  /// of a motion that has come to rest its tension there. Of a shorter motion the mean of all of it.
  double at_end() const;
  double last_moment() const { return all_.empty() ? 0 : all_.back().t; }  ///< s
  /// Tension `gap` before the last moment, or at the first one, N.
  double before_end() const;
  /// The largest tension `within` so long of the last moment, s, N.
  double largest_within(double within) const;
  /// By how much that is more than the largest in as long before it, relative; of a motion shorter than that with half
  /// of it. 0: it is not more.
  double growth(double within) const;

 private:
  struct Moment {
    double t = 0, T = 0;
  };
  void take_mean();

  long steps_ = 0;
  std::deque<Moment> all_;     ///< in the interval
  std::deque<Moment> rising_;  ///< those below all later ones
  double impulse_ = 0;         ///< of all in the interval, N s
  double largest_ = 0, when_ = 0;
  double mean_ = 0, when_mean_ = 0;
};

}  // namespace taut::checks
