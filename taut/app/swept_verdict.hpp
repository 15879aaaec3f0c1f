#pragma once
#include <set>
#include <string>
#include <vector>

#include "taut/calc/result.hpp"

namespace taut::app {

/// What is said against a machine at the values of a sweep, each judged as a deck of its own: of every check the worst,
/// of every kind of warning the first, of every value of the checks and every row of their tables the worst.
class SweptVerdict {
 public:
  /// `words`: which state it is, "ropes.sky.breaking_force = 60 kN, at rest".
  void take(Result at, const std::string& words);
  /// Adds it to the result of the whole deck, but for values and tables.
  void put_into(Result& r);
  /// Adds these, behind the deck's own checks and theirs.
  void put_numbers_into(Result& r) &&;

 private:
  void take_warnings(const Result& at, const std::string& words);
  bool is_new(const std::string& sentence);
  bool is_new(const std::string& kind, const std::string& sentence, const About& about);

  Result all_;
  std::vector<Value> values_;
  std::vector<Table> tables_;
  std::set<std::string> known_;  ///< sentences without their numbers, or what no state loads
};

}  // namespace taut::app
