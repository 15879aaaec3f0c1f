#pragma once
#include <map>
#include <string>
#include <utility>

#include "taut/calc/result.hpp"
#include "taut/solve/equilibrium.hpp"
#include "taut/solve/motion/transient.hpp"

namespace taut::checks {

/// Blocks that run into each other: two neighbours of one rope, sheaves or drums on different bodies, whose centres are
/// nearer to each other than the sum of their radii. Carriages pass supports, so these do not count.
class TwoBlocked {
 public:
  /// `words`: which state it is, "sweep, loads[0].mass = 40 t".
  void take(const machine::Model& model, const solve::EquilibriumResult& state, const std::string& words);
  void take(const machine::Model& model, const solve::TransientFrame& frame, const std::string& words);

  /// Each pair at its worst, as an unsafe warning.
  void add_warnings(Result& r) const;

 private:
  struct Worst {
    double gap = 0;       ///< between the rounds, below 0, m
    double distance = 0;  ///< of the centres, m
    std::string where;
  };
  template <class Places>
  void take_all(const machine::Model& model, const Places& place_of, const std::string& words);

  std::map<std::pair<std::string, std::string>, Worst> worst_;  ///< by the names of the rounds
};

}  // namespace taut::checks
