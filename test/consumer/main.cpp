#include <cstdio>

#include "taut/base/version.hpp"
#include "taut/units/parse.hpp"

int main() {
  std::printf("taut %s\n", taut::version.data());
  return 0;
}
