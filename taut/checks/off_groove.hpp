#pragma once
#include <map>
#include <set>
#include <string>
#include <utility>

#include "taut/calc/result.hpp"
#include "taut/solve/equilibrium.hpp"
#include "taut/solve/motion/transient.hpp"
#include "taut/units/display.hpp"

namespace taut::checks {

/// Ropes that come to a sheave or a drum so far out of its plane that no groove holds them: the calculation goes on
/// there, a real rope climbs over the flange. The throat of a groove opens 35 to 45 deg, 60 deg where ropes deviate
/// (Unirope, public page); half of the widest is the limit. docs/guide/verdict.md.
class OffGroove {
 public:
  void take(const machine::Model& model, const solve::EquilibriumResult& state, const std::string& words);
  /// `broken`: ropes that do not count; `words`: of the moment too, "transient lift, t = 2 s".
  void take(const machine::Model& model, const solve::TransientFrame& frame, const std::set<std::string>& broken,
            const std::string& words);
  /// One unsafe warning for each rope and round, with the state in which it is worst.
  void add_warnings(Result& r, const Display& display = {}) const;

 private:
  struct Worst {
    double sine = 0;  ///< of the angle between the rope and the round's plane
    std::string where;
  };
  using Place = std::pair<std::string, std::string>;  ///< names of a rope and of a round
  void keep(const machine::Reeving& rope, const machine::Node& node, const Matrix3& turned, const Vector3& along,
            const std::string& words);

  std::map<Place, Worst> worst_;
};

}  // namespace taut::checks
