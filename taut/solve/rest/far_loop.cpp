#include "taut/solve/rest/far_loop.hpp"

#include <fmt/format.h>

namespace taut::solve {
namespace {

constexpr double longest = 10;  ///< times the way

}  // namespace

Outcome no_far_loop(const mechanics::System& system, const mechanics::Configuration& c,
                    const mechanics::Evaluation& e) {
  for (const mechanics::Layout::Rope& rope : system.layout.ropes) {
    if (rope.row != system.layout.coordinate_row || rope.count == 0) continue;
    double length = 0, way = 0;
    for (int k = rope.first; k < rope.first + rope.count; ++k) {
      length += c.branches[k].length;
      way += e.branches[k].chord.norm();
    }
    if (length <= longest * way) continue;
    const int reeving = system.layout.branches[rope.first].reeving;
    return infeasible(fmt::format("'{}' could hold the carriage there by a loop of {:.4g} m only; choose another x",
                                  system.model.reevings[reeving].name, length));
  }
  return {};
}

}  // namespace taut::solve
