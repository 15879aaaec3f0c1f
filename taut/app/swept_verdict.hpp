#pragma once
#include <set>
#include <string>
#include <vector>

#include "taut/calc/result.hpp"

namespace taut::app {

/// What is said against a machine at the values of a sweep, each judged as a deck of its own: of every check the worst,
/// of every kind of warning the first.
class SweptVerdict {
 public:
  /// `words`: which state it is, "ropes.sky.breaking_force = 60 kN, at rest".
  void take(Result at, const std::string& words);
  /// Adds it to the result of the whole deck.
  void put_into(Result& r) &&;

 private:
  bool is_new(const std::string& sentence);

  Result all_;
  std::set<std::string> known_;  ///< sentences without their numbers
};

}  // namespace taut::app
