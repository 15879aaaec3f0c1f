#include "taut/model/model.hpp"

namespace taut::model {

int branch_count(const Reeving& reeving) {
  const auto nodes = static_cast<int>(reeving.nodes.size());
  return reeving.closed ? nodes : nodes - 1;
}

}  // namespace taut::model
