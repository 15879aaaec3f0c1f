# NLopt, which searches the continuous unknowns of a design. Its shared library: parts of it are under the LGPL, so that
# whoever has the program can put another build of it in its place.
find_path(NLOPT_INCLUDE nlopt.h REQUIRED)
find_library(NLOPT_LIBRARY NAMES libnlopt.so nlopt REQUIRED)
add_library(taut_nlopt INTERFACE)
target_include_directories(taut_nlopt SYSTEM INTERFACE $<BUILD_INTERFACE:${NLOPT_INCLUDE}>)
target_link_libraries(taut_nlopt INTERFACE ${NLOPT_LIBRARY})
install(TARGETS taut_nlopt EXPORT tautTargets)
