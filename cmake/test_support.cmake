# What all test programs share. Its precompiled header is the first thing a build makes, beside the library's.
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/test/paths.cpp @ONLY CONTENT [[
#include "test/paths.hpp"

namespace taut_test {
std::filesystem::path source_dir() { return "@PROJECT_SOURCE_DIR@"; }
std::filesystem::path program() { return "@CMAKE_RUNTIME_OUTPUT_DIRECTORY@/taut"; }
}  // namespace taut_test
]])
file(GLOB witnesses CONFIGURE_DEPENDS test/witness/*.cpp)
list(FILTER witnesses EXCLUDE REGEX "_test\\.cpp$")
add_library(taut_test_support OBJECT ${PROJECT_BINARY_DIR}/test/paths.cpp ${witnesses})
target_link_libraries(taut_test_support PUBLIC taut GTest::gmock_main rapidcheck)
# The library is tested as shipped; the tests themselves only need to compile fast.
target_compile_options(taut_test_support PUBLIC ${quick_to_build})
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  # The sanitizers watch the library and the program. With the tests' own code watched too a build takes a quarter longer,
  # and each of three thousand processes needs twice the time to start (as it does where its addresses are drawn by chance).
  target_compile_options(taut_test_support PUBLIC -fno-sanitize=all)
  # Eigen allocates in another way under the sanitizers: one way for both halves.
  target_compile_definitions(taut_test_support PUBLIC TAUT_WATCHED EIGEN_MALLOC_ALREADY_ALIGNED=0)
  target_link_options(taut_test_support PUBLIC -no-pie)
endif()
# gtest and rapidcheck cost about two seconds in every file without it.
target_precompile_headers(taut_test_support PRIVATE
  <gtest/gtest.h> <rapidcheck/gtest.h> <Eigen/Geometry> <fmt/format.h> <cmath> <map> <set> <string> <vector>)

# Twice as fast as the usual linker, where there is one.
find_program(GOLD_LINKER ld.gold)
mark_as_advanced(GOLD_LINKER)
if(GOLD_LINKER)
  target_link_options(taut_test_support PUBLIC -fuse-ld=gold)
endif()
