#pragma once
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/calc/field.hpp"
#include "taut/machine/description/machine.hpp"
#include "taut/machine/model.hpp"

/// Machines built in C++ with the words of a deck: parts have names, and the path of a rope is a list of names. SI
/// units, radians, z up. docs/guide/cpp.md shows complete programs.
namespace taut::machine {

/// Element of a rope path: the rope ends at this point, body or carriage.
description::PathElement anchor(const std::string& name);
/// Element of a rope path: the rope runs over this sheave, saddle or point. `side`: the side of the path on which the
/// sheave lies; automatic: found with the equilibrium.
description::PathElement over(const std::string& name, description::Side side = description::Side::automatic);
/// Element of a rope path: the carriage rides on the rope here.
description::PathElement through(const std::string& carriage);
/// Element of a rope path: the rope ends on this drum.
description::PathElement on_drum(const std::string& name, description::Side side = description::Side::automatic);
/// Element of a rope path: `count` parallel falls between two blocks. The rope reaches `first` first.
description::PathElement falls(int count, const std::string& first, const std::string& second);

/// The given quantity of a rope; set exactly one.
struct Known {
  std::optional<double> length;            ///< unstretched, from end to end of the path, m
  std::optional<double> tension_at_start;  ///< N, kept constant in every state
  std::optional<double> tension_at_end;    ///< the same at the end, N
};
Known length(double metres);
Known tension_at_start(double newtons);
Known tension_at_end(double newtons);

/// Properties of a rope that is in no catalogue.
struct RopeFigures {
  double mass = 0;                       ///< kg per unstretched metre, >= 0
  double stiffness = 0;                  ///< EA, N, > 0
  std::optional<double> breaking_force;  ///< N; without it there is no safety factor
  std::optional<double> diameter;        ///< m
};

/// Collects the parts of a machine. Each function adds one part and returns the builder. Names are resolved and checked
/// in `model`, so a part may be named before it is added; only `drive` needs its drum at once.
class Builder {
 public:
  /// A point of the ground, m.
  Builder& point(const std::string& name, const Triple& at);
  /// A rope of the catalogue, by its id, "EN 12385-4|6x36-IWRC|20|1960", or by its properties, "6x36-IWRC 20 mm 1960
  /// MPa".
  Builder& rope(const std::string& name, const std::string& catalogue_id);
  Builder& rope(const std::string& name, const RopeFigures& figures);
  /// A body of `mass` kg with its origin at `at`, m. `free`: its degrees of freedom, of x y z (translations) and rx ry
  /// rz (rotations about its origin).
  Builder& body(const std::string& name, const Triple& at, double mass,
                const std::vector<std::string>& free = {"x", "y", "z"});
  /// A turning sheave with its axis along y. `diameter`: pitch diameter, m. `efficiency`: smaller over larger tension
  /// of a rope that runs over it, 0 < efficiency <= 1. With `body`, `at` is in the frame of that body.
  Builder& sheave(const std::string& name, const Triple& at, double diameter, double efficiency = 1,
                  const std::optional<std::string>& body = std::nullopt);
  /// A support that does not turn: the rope slips on it. `friction`: coefficient of the rope on it. `diameter` 0: a
  /// point.
  Builder& saddle(const std::string& name, const Triple& at, double friction, double diameter = 0);
  /// A drum that does not turn. The rope leaves it at the core diameter, m.
  Builder& drum(const std::string& name, const Triple& at, double core_diameter);
  /// A carriage of `mass` kg that rolls on the reeving `rides`. `mainline`: the reeving whose length determines its
  /// position.
  Builder& carriage(const std::string& name, double mass, const std::string& rides,
                    const std::optional<std::string>& mainline = std::nullopt);
  /// Reeves a rope along its path of at least two elements. The reeving gets the name of the rope.
  Builder& reeve(const std::string& rope, Array<description::PathElement> path, const Known& known);
  /// A mass, kg, that hangs on a point, body or carriage.
  Builder& load(const std::string& at, double mass);
  /// A force on a point, body or carriage, N, constant in direction.
  Builder& force(const std::string& at, const Triple& force);
  /// A guy between two points, installed with a tension at its top, N. study::put_up_all puts it up; its length is
  /// constant afterwards.
  Builder& guy(const std::string& name, const std::string& rope, const std::string& from, const std::string& to,
               double tension);
  /// Drives a drum that was added before: `speed` is a text, "0.5 m/s", or the name of a signal. A positive speed takes
  /// rope in. Throws ContractViolation when there is no such drum.
  Builder& drive(const std::string& drum, const std::string& speed);
  /// Terrain: heights z at x, m; at least two points, x increasing.
  Builder& ground(Array<double> x, Array<double> z);

  /// The description itself, for parts that have no function here: taut/machine/description/machine.hpp.
  Machine& description() { return machine_; }
  const Machine& description() const { return machine_; }

  /// The compiled machine, or every mistake with its place ("reevings[1].path[0].anchor"). See compile.
  tl::expected<Model, std::vector<Complaint>> model() const;

 private:
  Machine machine_;
};

/// Index of a reeving (guys are reevings), of a body (carriages are bodies), of a carriage. Empty when no part has that
/// name.
std::optional<int> reeving_named(const Model& model, const std::string& name);
std::optional<int> body_named(const Model& model, const std::string& name);
std::optional<int> carriage_named(const Model& model, const std::string& name);

}  // namespace taut::machine
