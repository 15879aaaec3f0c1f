// One rope between two points: an elastic catenary, solved exactly.
#include "taut/rope/span.hpp"

#include <iostream>

int main() {
  taut::rope::CatenaryRope rope;
  rope.length = 205;      // m, unstretched
  rope.weight = 18;       // N/m
  rope.stiffness = 20e6;  // EA, N

  const auto span = taut::rope::solve_span(rope, {200, 0, 30});  // from the lower end to the upper one, m
  if (!span) return 1;
  std::cout << "tension below " << tension_at_start(*span) / 1e3 << " kN, above " << tension_at_end(*span) / 1e3
            << " kN; sag " << largest_sag(*span) << " m\n";
  // The tensions of a catenary differ by weight times height, but for the stretch.
  const double difference = tension_at_end(*span) - tension_at_start(*span);
  return difference > 0.99 * 18 * 30 && difference < 18 * 30 * 1.001 ? 0 : 1;
}
