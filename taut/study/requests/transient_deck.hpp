#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/calc/field.hpp"

namespace taut::study {

/// The dynamic factor of hoisting after EN 13001-2, phi2 = phi2_min + beta2 v_h, against which a rope's is checked.
struct HoistFactor {
  enum class Class { HC1, HC2, HC3, HC4 };
  std::string rope;  ///< a reeving
  Class hoisting_class = Class::HC2;
  double speed = 0;  ///< steady hoisting speed of the load, m/s
  static const Description& describe();
};

/// What has come slowly into its place before a motion begins, with all friction against that.
struct SlidRequest {
  std::optional<std::string> actuator, drum;
  double by = 0;  ///< m: extended, or taken in
  static const Description& describe();
};

/// A motion of the machine from its start on.
struct TransientRequest {
  enum class Method { implicit, verlet, reference };
  enum class Start { settled, assembled, sliding };
  enum class Branches { straight, catenary, by_weight };

  std::optional<std::string> name;    ///< ending of its files' names
  double duration = 0;                ///< s
  std::optional<double> output_step;  ///< s
  std::optional<double> tolerance;
  std::optional<double> step;  ///< s, fixed
  Method method = Method::implicit;
  Start start = Start::settled;
  std::vector<SlidRequest> slid;
  bool quasi_static = false;
  double damping_ratio = 0;
  bool rope_mass = true;
  Branches branches = Branches::straight;
  std::optional<std::string> save;     ///< file for the state at the end, in the folder of the results
  std::optional<std::string> restart;  ///< file with such a state, looked for beside the deck
  std::optional<HoistFactor> hoist_factor;
  std::string state;  ///< text of that file, read before
  bool judge = true;  ///< false: its states do not count for the verdict
  static const Description& describe();
};

}  // namespace taut::study
