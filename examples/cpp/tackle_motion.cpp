// A load on four falls, hoisted from rest: how much more the rope bears than in slow hoisting.
#include <iostream>

#include "taut/taut.hpp"

using namespace taut::machine;

int main() {
  Builder crane;
  crane.rope("hoist", RopeFigures{.mass = 0.9, .stiffness = 12e6, .breaking_force = 160e3, .diameter = 0.016});
  crane.body("hook", {0, 0, 4}, 6200, {"x", "z"}).point("pin", {0.2, 0, 10});
  crane.sheave("head", {0, 0, 10}, 0.4, 0.97).sheave("block", {0, 0, 0}, 0.4, 0.97, "hook");
  crane.drum("winch", {-6, 0, 1}, 0.4);
  crane.reeve("hoist", {on_drum("winch"), falls(4, "head", "block"), anchor("pin")}, length(40));
  crane.drive("winch", "start");
  taut::machine::description::Signal start;  // 0 to 1 m/s of rope within 0.4 s
  start.name = "start";
  start.ramp = taut::machine::description::Ramp{};
  start.ramp->from = "0 m/s";
  start.ramp->to = "1 m/s";
  start.ramp->start = 0.2;
  start.ramp->duration = 0.4;
  crane.description().signals.push_back(start);
  const auto model = crane.model();
  if (!model) {
    for (const taut::Complaint& c : model.error()) std::cerr << c.path << ": " << c.message << "\n";
    return 1;
  }

  taut::solve::EquilibriumOptions hoisting;
  hoisting.motion = taut::solve::Motion::hoist;
  const auto slow = taut::solve::equilibrium(*model, hoisting);
  taut::solve::TransientOptions options;
  options.duration = 2;
  options.damping_ratio = 0.02;
  const auto motion = taut::solve::transient(*model, options);
  if (!slow.outcome.ok() || !motion.outcome.ok()) return std::cerr << motion.outcome.message << "\n", 1;
  const double factor = motion.ropes[0].T.max / slow.ropes[0].T_max;
  std::cout << "slowly hoisted " << slow.ropes[0].T_max / 1e3 << " kN, started " << motion.ropes[0].T.max / 1e3
            << " kN: dynamic factor " << factor << "; ledger open by " << motion.open << "\n";
  return factor > 1 && motion.open < 1e-3 ? 0 : 1;
}
