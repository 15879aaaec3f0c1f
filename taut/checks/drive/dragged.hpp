#pragma once
#include <map>
#include <string>
#include <utility>

#include "taut/calc/result.hpp"
#include "taut/machine/model.hpp"
#include "taut/solve/motion/transient.hpp"
#include "taut/units/display.hpp"

namespace taut::checks {

/// Drives that give way to their load until a motion ends, by more than the swing of a load that they bear: drums by a
/// torque, a pull, or by none; driven sheaves by a torque; cylinders by a force, a law, or that are free. And ropes
/// that slip over their supports while loads fall. Not told is what other drives draw out: a haulback that is kept
/// tight.
class Dragged {
 public:
  explicit Dragged(Display display = {}) : display_(std::move(display)) {}

  /// A moment of a motion, `time` after the one before, s.
  void take_moment(const machine::Model& model, const solve::TransientFrame& moment, double time,
                   const std::string& words);
  /// What gives way when a motion ends, in words. Another motion may begin then.
  std::map<Part, std::string> at_end(const machine::Model& model, const solve::TransientResult& motion);

 private:
  enum class Kind { drum, pulling_drum, motor, cylinder, support };
  using Which = std::pair<Kind, int>;
  struct Way {
    double way = 0;    ///< that its load has dragged it so far, m
    double least = 0;  ///< a shorter way gives no warning, m
    double speed = 0;  ///< m/s
    Part part;
    std::string words;
  };
  class Moment;

  void take_drums(const Moment& now, std::map<Which, Way>& gives) const;
  void take_motors(const Moment& now, std::map<Which, Way>& gives) const;
  void take_cylinders(const Moment& now, std::map<Which, Way>& gives) const;
  void take_supports(const Moment& now, std::map<Which, Way>& gives) const;
  static bool still_so(const machine::Model& model, const solve::DynamicState& end, const Which& which, double speed);

  Display display_;
  std::map<Which, Way> ways_;  ///< of what gives way now
};

}  // namespace taut::checks
