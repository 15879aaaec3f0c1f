// A stranger's whole program: it reads a force and says which library did it.
#include <cstdio>

#include "taut/base/version.hpp"
#include "taut/units/parse.hpp"

int main() {
  const auto force = taut::parse_quantity("63 kN", taut::si::N);
  std::printf("taut %s reads 63 kN as %g N\n", taut::version.data(), force.value_or(0));
  return force == 63e3 ? 0 : 1;
}
