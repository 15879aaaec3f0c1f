# Every warning that pays for itself, for all code of this project and for nobody who links it.
add_compile_options(-Wall -Wextra -Wpedantic -Wconversion -Wshadow)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  # The instrumentation's own branches make g++ 12 see uses of variables that never were.
  add_compile_options(-Wno-maybe-uninitialized)
endif()
