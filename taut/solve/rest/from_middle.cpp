#include "taut/solve/rest/from_middle.hpp"

#include "taut/machine/middle.hpp"

namespace taut::solve {
namespace {

void shift(const Vector3& by, machine::State& state) {
  for (machine::Pose& body : state.bodies) body.position += by;
}

void shift(const Vector3& by, EquilibriumResult& result) {
  shift(by, result.state);
  for (BranchResult& branch : result.branches) {
    branch.start += by;
    branch.end += by;
  }
  for (RopeLoadResult& load : result.rope_loads) load.at += by;
  for (BeamResult& beam : result.beams) {
    for (BeamPoint& point : beam.points) point.place += by;
  }
  for (EquilibriumResult& bound : result.bounds) shift(by, bound);
}

}  // namespace

std::optional<EquilibriumResult> found_from_middle(const machine::Model& model, const EquilibriumOptions& options,
                                                   const std::optional<machine::State>& start) {
  const Vector3 middle = machine::far_middle(model);
  if (middle == Vector3::Zero()) return std::nullopt;
  EquilibriumOptions from_there = options;
  if (from_there.prescribed) {
    from_there.prescribed->x -= from_there.prescribed->along.dot(middle);
    if (from_there.prescribed->z) *from_there.prescribed->z -= middle.z();
  }
  std::optional<machine::State> near = start;
  if (near) shift(-middle, *near);
  EquilibriumResult result = equilibrium(machine::counted_from(middle, model), from_there, near);
  shift(middle, result);
  return result;
}

}  // namespace taut::solve
