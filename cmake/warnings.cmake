# Every warning that pays for itself, for all code of this project and for nobody who links it.
add_compile_options(-Wall -Wextra -Wpedantic -Wconversion -Wshadow)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  # The instrumentation's own branches make g++ 12 see uses of variables that never were.
  add_compile_options(-Wno-maybe-uninitialized)
endif()
if(EMSCRIPTEN)
  # A count of cases has 64 bits everywhere and one of things in memory 32 there: a set that is too large ends in
  # bad_alloc, not in a wrong number.
  add_compile_options(-Wno-shorten-64-to-32)
endif()
