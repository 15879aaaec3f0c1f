#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/calc/field.hpp"
#include "taut/solve/condition.hpp"

namespace taut::study {

struct Names;

/// A rope's end.
enum class RopeEnd { start, end };

/// What is asked in place of what one rope has given.
struct GivenRequest {
  std::string reeving;
  std::optional<double> winch_pull;   ///< N
  std::optional<double> loop_length;  ///< m
  std::optional<double> sag;          ///< m
  bool free_running = false;
  std::vector<std::string> of;       ///< ropes whose pull or length it is, in place of that one's
  std::optional<double> efficiency;  ///< of the lead from the winch to the rope's end
  RopeEnd at = RopeEnd::start;       ///< where the winch is
  std::optional<int> span;           ///< of a sag, from 1
  static const Description& describe();
};

/// The free branch of a rope with the longest chord, from 0: what a sag is of where a deck names none.
int longest_span(const machine::Model& model, int reeving);

/// What that means for the solver, where `carriage` is put somewhere.
solve::Condition condition_of(const GivenRequest& request, std::optional<int> carriage, const std::string& path,
                              Names& names);

}  // namespace taut::study
