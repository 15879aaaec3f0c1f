#pragma once
#include <map>
#include <string>

#include "taut/machine/model.hpp"

namespace taut::checks {

/// What a state asks of a part.
struct AskedLoad {
  double weight = 0;  ///< of the whole machine: weights of its bodies and sizes of the forces of its loads, N
  double least = 0;   ///< what the part bears at least where that state stands, N m
};

/// N, of all bodies and of the loads on them.
double weight_of(const machine::Model& model);

/// Parts that only some states can show: a brake holds while its drum stands. Where the other states have a heavier
/// load than those, they show that too little is known.
class ShownLoads {
 public:
  void show(const std::string& part, const AskedLoad& load);
  /// `words`: which state has the part under that load, and does not show it.
  void leave_out(const std::string& part, const AskedLoad& load, const std::string& words);

  struct Missing {
    std::string words;    ///< which state
    bool by_less = true;  ///< the part is shown, under less load; false: it is shown by no state
  };
  /// By part, in the order of their names.
  std::map<std::string, Missing> missing() const;

 private:
  struct LeftOut {
    AskedLoad most;                        // the weight and what is borne may be of two states
    std::string first, heaviest, hardest;  // the words of the first state, and of those two
  };
  std::map<std::string, AskedLoad> shown_;  // the most of each
  std::map<std::string, LeftOut> left_out_;
};

}  // namespace taut::checks
