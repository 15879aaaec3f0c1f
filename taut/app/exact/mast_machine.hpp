#pragma once
#include <string>
#include <vector>

#include "taut/methods/mast_section/sizing.hpp"
#include "taut/solve/equilibrium.hpp"

/// The mast of a `mast_section` deck with its guys as a machine: a beam that stands up from the origin, x towards the
/// span, ropes from anchors to places on it. All SI.
namespace taut::app {

/// A guy of the deck as a rope, put up while the mast stands plumb, unloaded and not shortened.
struct MastGuy {
  std::string name;
  double height = 0;                 ///< of its fixing on the mast's axis, m
  Vector3 anchor = Vector3::Zero();  ///< m
  double stiffness = 0;              ///< EA, N
  double weight = 0;                 ///< N/m
  double breaking_force = 0;         ///< N; 0: not known
  double length = 0;                 ///< unstretched, m
  double installed = 0;              ///< tension at its upper end while it is put up, N
  double installed_most = 0;         ///< the largest anywhere in it then, N
};

/// Not ok: no length gives a guy its tension.
struct MastGuys {
  Outcome outcome;
  std::vector<MastGuy> all;
};
MastGuys put_up_guys(const mast_section::Input& in);

/// The mast under the block forces of one carriage position: its only beam; the guys are its reevings, in their order.
machine::Model mast_machine(const mast_section::Input& in, const std::vector<MastGuy>& guys,
                            const mast_section::ClampForces& forces, const structure::BeamSection& section);

/// Why such a mast finds no equilibrium, with the share of the block forces that it holds, found by halving to a
/// thousandth; the outcome as it is where there is one, where the guys had none, and where the engine found no answer
/// without knowing that there is none.
Outcome with_share_held(const machine::Model& model, const Outcome& outcome);

/// What is left of moments about the foot in the deflected shape, N m: a check of the result that shares nothing with
/// the equations. The own weight is summed by the trapezoidal rule.
double moment_balance(const machine::Model& model, const solve::EquilibriumResult& found);

/// A rope not shorter than its chord: it carries no more than its own weight.
bool hangs(const solve::BranchResult& guy);

}  // namespace taut::app
