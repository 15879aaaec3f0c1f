#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

#include "taut/machine/model.hpp"

namespace taut::checks {

/// The loads of a machine: masses of its bodies, components of the forces of its loads. Two states with the same ones
/// differ by their places and by how their ropes run.
using MachineLoads = std::vector<double>;
MachineLoads machine_loads(const machine::Model& model);

/// What a part would bear where a state that moves stood, N m: between these.
struct BorneAtRest {
  double least = 0, most = 0;
};

/// Parts that only some states can show: a brake holds while its drum stands. Where the other states may ask more of
/// them than was shown, they show that too little is known.
class ShownLoads {
 public:
  /// `borne`: in that state, N m.
  void show(const std::string& part, const MachineLoads& loads, double borne);
  /// `words`: which state has the part under those loads, and does not show it.
  void leave_out(const std::string& part, const MachineLoads& loads, const BorneAtRest& borne,
                 const std::string& words);

  struct Missing {
    std::string words;    ///< which state
    bool by_less = true;  ///< the part is shown, under less load; false: it is shown by no state
  };
  /// By part, in the order of their names. A state with loads that are shown asks at least for its `least`, one with
  /// other loads for its `most`.
  std::map<std::string, Missing> missing() const;

 private:
  struct Shown {
    std::set<MachineLoads> loads;
    double most = 0;
  };
  struct LeftOut {
    BorneAtRest borne;              // the largest of each, which may be of two states
    std::string by_least, by_most;  // the words of these
  };
  std::map<std::string, Shown> shown_;
  std::map<std::string, std::map<MachineLoads, LeftOut>> left_out_;
  std::map<std::string, std::string> first_;  // the words of the first that is left out
};

}  // namespace taut::checks
