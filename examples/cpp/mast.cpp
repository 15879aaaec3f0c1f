// A published method called from C++, and a deck run by the same program: the mast of a tractor yarder.
#include <iostream>

#include "taut/methods/mast_section/mast_section.hpp"
#include "taut/taut.hpp"

int main() {
  const char* deck = R"(
taut: 1
method: mast_section
input:
  skyline_force: 100 kN
  mainline_force: 40 kN
  skyline_block_height: 8.0 m
  branch_angle: 12 deg
  allowable_stress: 160 MPa
)";
  taut::app::Job job;
  job.text = deck;
  const taut::Result result = taut::app::run(job);
  std::cout << taut::to_text(result.status) << ": " << result.values.size() << " values, " << result.steps.size()
            << " lines of the calculation\n";

  taut::mast_section::Input in;
  in.skyline_force = 100e3;
  in.mainline_force = 40e3;
  in.skyline_block_height = 8;
  in.branch_angle = taut::parse_quantity("12 deg", taut::si::rad).value();
  in.allowable_stress = 160e6;
  taut::mast_section::Output out;
  const taut::Outcome outcome = taut::mast_section::solve(in, out);
  std::cout << "bending moment at the clamp " << out.M / 1e3 << " kN m\n";
  return outcome.ok() && result.status == taut::Status::ok ? 0 : 1;
}
