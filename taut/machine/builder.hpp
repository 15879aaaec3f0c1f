#pragma once
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/calc/field.hpp"
#include "taut/machine/description/machine.hpp"
#include "taut/machine/model.hpp"

/// Machines written in C++, in the words of a deck: parts have names, and ropes run along lists of names. SI units,
/// radians, z up. docs/guide/cpp.md has whole programs.
namespace taut::machine {

/// A stop of a rope's path: the end of a rope at a point, body or carriage.
description::PathElement anchor(const std::string& name);
/// The rope runs over a sheave, saddle or point.
description::PathElement over(const std::string& name, description::Side side = description::Side::automatic);
/// A carriage rides on the rope here.
description::PathElement through(const std::string& carriage);
/// The rope ends on a drum.
description::PathElement on_drum(const std::string& name, description::Side side = description::Side::automatic);
/// `count` parallel falls between two blocks; the rope comes to `first` first.
description::PathElement falls(int count, const std::string& first, const std::string& second);

/// What is known of a rope besides its path. Exactly one of them.
struct Known {
  std::optional<double> length;            ///< unstretched, from end to end of the path, m
  std::optional<double> tension_at_start;  ///< held in every state, N
  std::optional<double> tension_at_end;    ///< the same, N
};
Known length(double metres);
Known tension_at_start(double newtons);
Known tension_at_end(double newtons);

/// Figures of a rope that is in no catalogue.
struct RopeFigures {
  double mass = 0;                       ///< kg per unstretched metre, >= 0
  double stiffness = 0;                  ///< EA, N, > 0
  std::optional<double> breaking_force;  ///< N; without it there is no safety factor
  std::optional<double> diameter;        ///< m
};

/// Collects the parts of a machine. Nothing is checked before `model`, so that parts may be named before they are
/// there. Each function adds one part and returns the builder.
class Builder {
 public:
  /// A point of the ground, m.
  Builder& point(const std::string& name, const Triple& at);
  /// A rope of the catalogue by its id, "EN 12385-4|6x36-IWRC|20|1960", or in words, "6x36-IWRC 20 mm 1960 MPa".
  Builder& rope(const std::string& name, const std::string& catalogue_id);
  Builder& rope(const std::string& name, const RopeFigures& figures);
  /// A body of `mass` kg with its origin at a place, m. `free`: the ways it may move, of x y z (slides) and rx ry rz
  /// (turns about its origin).
  Builder& body(const std::string& name, const Triple& at, double mass,
                const std::vector<std::string>& free = {"x", "y", "z"});
  /// A turning sheave of pitch diameter `diameter`, m, its axis along y; `efficiency`: smaller over larger tension of
  /// a rope that runs over it, 0 < efficiency <= 1. With `body` the place is in the frame of that body.
  Builder& sheave(const std::string& name, const Triple& at, double diameter, double efficiency = 1,
                  const std::optional<std::string>& body = std::nullopt);
  /// A support in which the rope lies and slips, with the friction of the rope on it. diameter 0: a point.
  Builder& saddle(const std::string& name, const Triple& at, double friction, double diameter = 0);
  /// A drum that is held; the rope lies on its core.
  Builder& drum(const std::string& name, const Triple& at, double core_diameter);
  /// A carriage of `mass` kg that rolls on the reeving `rides`; `mainline`: the reeving whose length sets its place.
  Builder& carriage(const std::string& name, double mass, const std::string& rides,
                    const std::optional<std::string>& mainline = std::nullopt);
  /// A rope on its path, two stops at least. The reeving has the rope's name.
  Builder& reeve(const std::string& rope, Array<description::PathElement> path, const Known& known);
  /// A mass that hangs on a point, body or carriage, kg.
  Builder& load(const std::string& at, double mass);
  /// A dead force on it, N.
  Builder& force(const std::string& at, const Triple& force);
  /// A guy between two points, put up with a tension at its top, N; then it keeps its length.
  Builder& guy(const std::string& name, const std::string& rope, const std::string& from, const std::string& to,
               double tension);
  /// What moves the rope on a drum that is there: a speed as text, "0.5 m/s", or the name of a signal. A positive one
  /// takes rope in.
  Builder& drive(const std::string& drum, const std::string& speed);
  /// Heights of the ground at x, m, at least two, x growing.
  Builder& ground(Array<double> x, Array<double> z);

  /// The description, for all that has no function here; taut/machine/description/machine.hpp says what there is.
  Machine& description() { return machine_; }
  const Machine& description() const { return machine_; }

  /// The machine, ready to be solved, or every mistake with its place, "reevings[1].path[0].anchor". See compile.
  tl::expected<Model, std::vector<Complaint>> model() const;

 private:
  Machine machine_;
};

/// Indices by name: of a reeving (a guy is one), a body (a carriage is one), a carriage. Empty: there is none.
std::optional<int> reeving_named(const Model& model, const std::string& name);
std::optional<int> body_named(const Model& model, const std::string& name);
std::optional<int> carriage_named(const Model& model, const std::string& name);

}  // namespace taut::machine
