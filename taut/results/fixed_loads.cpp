#include "taut/results/fixed_loads.hpp"

#include <fmt/format.h>

#include "taut/base/array.hpp"

namespace taut::results {

std::vector<std::string> fixed_load_warnings(const machine::Model& model) {
  Array<Vector3> sums(model.bodies.size(), Vector3::Zero());
  for (const machine::Load& load : model.loads) sums[load.at.body] += load.force;
  std::vector<std::string> all;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const machine::Body& body = model.bodies[i];
    if (sums[i].norm() == 0 || !machine::stands_fast(body) || model.is_on_screw(static_cast<int>(i))) continue;
    all.push_back(
        fmt::format("'{}' cannot move, and bears its load of {:.4g} kN by itself: no rope feels it; say what is 'free' "
                    "where the ropes have to hold the body",
                    body.name, sums[i].norm() / 1e3));
  }
  return all;
}

}  // namespace taut::results
