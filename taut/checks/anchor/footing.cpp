#include "taut/checks/anchor/footing.hpp"

#include <algorithm>
#include <optional>

#include "taut/machine/state.hpp"
#include "taut/math/index.hpp"

namespace taut::checks {
namespace {

constexpr double of_forces = 1e-6;   ///< of the largest force of a machine: to which its balance is known
constexpr double of_length = 1e-12;  ///< strain of a beam that its ends' rounding, 1e-16 of their places, may leave
                                     ///< where these are up to 10^4 times its length

/// Whether it turns about its origin, which the ground holds.
bool turns_on_joint(const machine::Body& body) {
  const auto moves = [](const auto& way) { return way.along != Vector3::Zero(); };
  return !body.free.empty() && !body.beam && !body.of_rope && std::none_of(body.free.begin(), body.free.end(), moves) &&
         std::none_of(body.driven.begin(), body.driven.end(), moves);
}

/// The force of a beam on the ground at its end: F' = w z along it.
Vector3 force_at_end(const machine::Beam& beam, const Array<machine::PieceState>& pieces) {
  const structure::RodPiece& last = beam.pieces.back().rod;
  return -(pieces.back().force + last.section.weight * (last.to - last.from) * Vector3::UnitZ());
}

}  // namespace

std::vector<Footing> footings_of(const machine::Machine& described, const machine::Model& model) {
  std::vector<Footing> all;
  const auto at = [&](const std::string& point, const std::string& beam) -> Footing& {
    auto known = std::find_if(all.begin(), all.end(), [&](const Footing& one) { return one.name == point; });
    if (known == all.end()) known = all.insert(known, {.name = point, .of = {}, .begin = {}, .end = {}});
    known->of.push_back(beam);
    return *known;
  };
  for (int i = 0; i < static_cast<int>(model.beams.size()); ++i) {
    const machine::Beam& beam = model.beams[i];
    const auto given = std::find_if(described.beams.begin(), described.beams.end(),
                                    [&](const auto& one) { return one.name == beam.name; });
    if (given == described.beams.end()) continue;
    if (beam.pieces.front().start.body == machine::ground) at(given->from, beam.name).begin.push_back(i);
    if (beam.pieces.back().end.body == machine::ground) at(given->to, beam.name).end.push_back(i);
  }
  for (const machine::Body& body : model.bodies) {
    if (turns_on_joint(body)) all.push_back({.name = body.name, .of = {}, .begin = {}, .end = {}});
  }
  return all;
}

Vector3 force_on(const Footing& footing, const machine::Model& model, const solve::EquilibriumResult& state) {
  Vector3 force = Vector3::Zero();
  const auto has = [&](int beam) { return as_size(beam) < state.beams.size(); };
  for (const int beam : footing.begin) {
    if (has(beam)) force -= state.beams[beam].base_force;
  }
  for (const int beam : footing.end) {
    if (has(beam)) force += force_at_end(model.beams[beam], state.state.beams[beam]);
  }
  if (!footing.of.empty()) return force;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    if (model.bodies[b].name == footing.name && turns_on_joint(model.bodies[b])) force -= state.reactions[b];
  }
  return force;
}

double force_rounding(const machine::Model& model, const solve::EquilibriumResult& state) {
  double largest = 0, stiffest = 0;
  for (const solve::RopeResult& rope : state.ropes) largest = std::max(largest, rope.T_max);
  for (const Vector3& reaction : state.reactions) largest = std::max(largest, reaction.norm());
  for (const solve::BeamResult& beam : state.beams) largest = std::max(largest, beam.base_force.norm());
  for (const auto& pieces : state.state.beams) {
    for (const machine::PieceState& piece : pieces) largest = std::max(largest, piece.force.norm());
  }
  for (const machine::Beam& beam : model.beams) {
    for (const auto& piece : beam.pieces) stiffest = std::max(stiffest, piece.rod.section.EA);
  }
  return std::max(of_forces * largest, of_length * stiffest);
}

}  // namespace taut::checks
