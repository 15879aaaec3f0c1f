#include "taut/checks/anchor/support_checks_deck.hpp"

namespace taut::checks {

const Description& SupportCheckRequest::describe() {
  using R = SupportCheckRequest;
  static const Description d =
      Describe<R>()
          .field(&R::tree_diameter, "tree_diameter", "", si::m.in("cm"),
                 "diameter of the tree at breast height; what it needs follows from the force on it and its height")
          .above(0)
          .at_most(5)
          .field(&R::height, "height", "h", si::m,
                 "height of the saddle over the ground; default: over the machine's terrain")
          .above(0)
          .at_most(100)
          .field(&R::lashing, "lashing", "", si::m, "height of the lashing on the trunk above the saddle")
          .at_least(0)
          .at_most(20)
          .field(&R::with, "with",
                 "what else pulls at the same tree: other sheaves on it, and points at which ropes or guys end")
          .field(&R::dynamic_factor, "dynamic_factor", "phi", si::one, "dynamic factor of the largest force")
          .at_least(1)
          .at_most(10);
  return d;
}

}  // namespace taut::checks
