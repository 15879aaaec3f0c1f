#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/machine/compile/path.hpp"
#include "taut/machine/description/machine.hpp"
#include "taut/machine/model.hpp"
#include "taut/machine/state.hpp"

namespace taut::machine {

/// The carriage (index) of `holds: ahead_of CARRIAGE`; none without the key or where it can't be read.
std::optional<int> ahead_of(const Machine& machine, const description::Round& round);

/// Complains of `holds` that can't be read.
void check_holds(const Machine& machine, std::vector<Complaint>& complaints);

/// The bodies of the carriages; those of beams stand behind them.
struct CarriageBodies {
  int first = 0, count = 0;
  bool contains(int body) const { return body >= first && body < first + count; }
};

/// The guides at the ends of a rope's path. Complains, at the guide's element of the path, of one that does not stand
/// beside the end at its carriage, and of guides that do not follow one another along the line in the order of the
/// path. `places`: of the stops, in the ground frame.
Array<Guides> guides_of(const Array<Stop>& stops, const Array<Vector3>& places, CarriageBodies carriages,
                        std::vector<Complaint>& complaints);

/// Takes the guides that hold ahead of the carriage `body` out of all paths, or puts those into them that hold where
/// the carriage stands at x = place . along. `along`: horizontal unit vector.
void release_guides(Model& model, int body);
void hold_guides(Model& model, int body, double x, const Vector3& along);

/// The model with the guides that hold where the carriages start.
Model with_guides_at_start(Model model);

/// The same where the bodies stand in a state.
Model with_guides_at(Model model, const State& state);

/// Whether two models made of one have the same guides in their paths.
bool same_guides(const Model& a, const Model& b);

/// A guide and where it stands at the start.
struct PlacedGuide {
  const Node* node = nullptr;
  Vector3 place = Vector3::Zero();
};

/// The guides that hold ahead of a carriage, whether the path has them or not.
Array<PlacedGuide> guides_ahead_of(const Model& model, int carriage);

/// Where a carriage is found on the other side of a guide than the path of its rope has it: a sentence; empty without
/// one.
std::string misplaced_guide(const Model& model, const Array<Pose>& bodies);

}  // namespace taut::machine
