#pragma once
#include <tl/expected.hpp>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/solve/equilibrium.hpp"

namespace taut::solve {

/// +1: as the ropes run while the machine hauls in, -1: the other way, 0: at rest.
int sign_of(Motion motion);

/// Flow through every node, [reeving][node]: the options' own, or by their motion and the places of the machine alone.
Array<Array<int>> flow_of(const machine::Model& model, const EquilibriumOptions& options);

/// Which way ropes run, [reeving][node].
struct RopesRun {
  Array<Array<int>> flow;   ///< +1 along the path, -1 against it, 0 neither
  Array<Array<int>> creep;  ///< as EquilibriumOptions::creep: nothing says which way it runs there; or empty
};

/// By the options' own flow, or by their motion: as the places of the machine say, and by rope that passes as winches
/// take in (rest/hauled.hpp). `start`: of the search for the answer without loss.
RopesRun ropes_run(const machine::Model& model, const EquilibriumOptions& options,
                   const std::optional<machine::State>& start);

/// Unstretched rope that runs along its path over a place of the round of a node which stays where it is on it, between
/// two answers, m: an arc may grow by rope that comes from both sides, as its ends move, and none of it runs. The rope
/// does not run beside its node `still`.
double passed(const machine::Model& model, const EquilibriumResult& before, const EquilibriumResult& now, int reeving,
              int node, int still);

/// A rope that runs steadily along itself carries the centrifugal tension c = m v^2 everywhere; its shape, its supports
/// and the laws of its contacts know T - c alone (Routh; docs/theory/drives.md). With T' = T - c the rope stretches as
/// one that is longer by 1 + c/EA and has the stiffness EA + c: (1 + T/EA) = (1 + c/EA)(1 + T'/(EA + c)).

/// c of one rope, N; 0 where the flow lets it rest.
double centrifugal(const machine::Reeving& rope, const Array<int>& flow);

/// The machine in terms of T'. The error says whose given tension is not above c.
tl::expected<machine::Model, std::string> running(const machine::Model& model, const Array<Array<int>>& flow);

/// Adds c to the tensions of a result in terms of T'.
void add_centrifugal(const machine::Model& model, const Array<Array<int>>& flow, EquilibriumResult& result);

/// The machine with its loads held as they are at rest: by the haul, not by the motion.
machine::Model with_loads_held(machine::Model model);

}  // namespace taut::solve
