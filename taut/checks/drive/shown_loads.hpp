#pragma once
#include <map>
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/machine/model.hpp"
#include "taut/math/vector.hpp"

namespace taut::checks {

/// What a machine bears, and where.
struct Situation {
  /// Masses of its bodies, components of the forces of its loads, tensions and torques that are given, forces along its
  /// ropes.
  std::vector<double> loads;
  Array<Vector3> places;  ///< of its bodies and of what is on them, m; empty: a motion, which goes through many
  double extent = 0;      ///< of the machine, m
};
Situation situation_of(const machine::Model& model, Array<Vector3> places);
/// Of a motion.
Situation situation_of(const machine::Model& model);

/// What a part would bear where a state that moves stood, N m: between these.
struct BorneAtRest {
  double least = 0, most = 0;
};

/// Parts that only some states can show: a brake holds while its drum stands. Where the other states may ask more of
/// them than was shown, and than they hold, they show that too little is known.
class ShownLoads {
 public:
  /// `borne`: in that state, N m.
  void show(const std::string& part, const Situation& situation, double borne);
  /// `words`: which state has the part in that situation, and does not show it. `holds`: what the part can bear, N m.
  void leave_out(const std::string& part, const Situation& situation, const BorneAtRest& borne, double holds,
                 const std::string& words);

  struct Missing {
    std::string words;    ///< which state
    bool by_less = true;  ///< the part is shown, under less load; false: it is shown by no state
  };
  /// By part, in the order of their names. A state asks for its `most`. One in a situation that is shown asks for
  /// nothing, unless its `least` is more than any that is shown: then the part bears more there than at rest.
  std::map<std::string, Missing> missing() const;

 private:
  struct Shown {
    std::vector<Situation> situations;
    double most = 0;
  };
  struct LeftOut {
    Situation situation;
    BorneAtRest borne;  // the largest of each in it, which may be of two states
    double holds = 0;
    std::string words;  // of the state with the most
  };
  std::map<std::string, Shown> shown_;
  std::map<std::string, std::vector<LeftOut>> left_out_;
  std::map<std::string, std::string> first_;  // the words of the first that is left out
};

}  // namespace taut::checks
