// A stranger's whole program: it calls one published method and reads a quantity from text.
#include <iostream>

#include "taut/base/version.hpp"
#include "taut/methods/boom_ropes/boom_ropes.hpp"
#include "taut/units/parse.hpp"

// NOLINTNEXTLINE(bugprone-exception-escape): a text that is no quantity may end it
int main() {
  namespace boom = taut::boom_ropes;
  boom::Input in;
  in.section_weight = taut::parse_quantity("8.44 kN", taut::si::N).value();
  in.pad_friction = 0.15;
  in.tackle_efficiency = 0.95;
  in.extension_stiffness = boom::printed_C1;
  in.retraction_stiffness = boom::printed_C2;
  in.cases = {{.name = "retract 3 t",
               .operation = boom::Operation::retract,
               .luffing_angle = 0.087,
               .suspended_weight = 32.4e3,
               .falls = 6}};
  boom::Output out;
  const auto outcome = boom::solve(in, out);
  std::cout << "taut " << taut::version << ": S20 >= " << out.S20_min << " N\n";
  return outcome.ok() && out.S20_min > 0 ? 0 : 1;
}
