#pragma once
#include <map>
#include <set>
#include <string>
#include <utility>

#include "taut/calc/result.hpp"
#include "taut/machine/model.hpp"
#include "taut/machine/state.hpp"
#include "taut/units/display.hpp"

namespace taut::checks {

/// Blocks that run into each other: two neighbours of one rope, sheaves, saddles or drums on different bodies, whose
/// centres are nearer to each other than the sum of their radii. Rounds on carriages do not count. And a part without a
/// round at the end of a rope that is drawn into a sheave, saddle or drum of another part: the free rope between them
/// is shorter than its radius. A carriage passes a saddle. Of two parts that both stand that is how they are built.
class TwoBlocked {
 public:
  /// `words`: which state it is, "sweep, loads[0].mass = 40 t". `broken`: ropes that do not count.
  void take(const machine::Model& model, const machine::State& state, const std::set<std::string>& broken,
            const std::string& words);

  /// Each pair at its worst, as an unsafe warning.
  void add_warnings(Result& r, const Display& display = {}) const;

 private:
  struct Worst {
    double gap = 0;       ///< between the rounds, below 0, m
    double distance = 0;  ///< of the centres, m
    std::string where;
  };

  void take_end(const machine::Model& model, const machine::State& state, const machine::Node& round,
                const machine::Node& end, const std::string& words);

  std::map<std::pair<std::string, std::string>, Worst> worst_;  ///< by the names of the rounds
  std::map<std::pair<std::string, std::string>, Worst> ends_;   ///< by those of the round and of the end; gap: of rope
};

}  // namespace taut::checks
