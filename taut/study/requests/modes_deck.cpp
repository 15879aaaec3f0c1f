#include "taut/study/requests/modes_deck.hpp"

namespace taut::study {

const Description& ModesRequest::describe() {
  using Start = TransientRequest::Start;
  using Branches = TransientRequest::Branches;
  static const Description d =
      Describe<ModesRequest>()
          .field(&ModesRequest::name, "name", "appended to the names of its tables, when a deck has several")
          .field(&ModesRequest::judge, "judge", "false: its states do not count for the verdict")
          .field(&ModesRequest::count, "count", "n", si::one, "number of modes, lowest first")
          .at_least(1)
          .at_most(400)
          .choice(&ModesRequest::start, "start", {{"settled", Start::settled}, {"assembled", Start::assembled}},
                  "settled: about the equilibrium at rest; assembled: places and lengths as described")
          .field(&ModesRequest::damping_ratio, "damping_ratio", "zeta", si::one,
                 "damping ratio of ropes without their own, in the lowest mode that stretches the rope")
          .at_least(0)
          .at_most(10)
          .field(&ModesRequest::rope_mass, "rope_mass", "false: ropes without weight and inertia")
          .choice(
              &ModesRequest::branches, "branches",
              {{"straight", Branches::straight}, {"catenary", Branches::catenary}, {"by_weight", Branches::by_weight}},
              "branches, as in a transient");
  return d;
}

}  // namespace taut::study
