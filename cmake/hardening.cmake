# WebAssembly has walls of its own: code cannot be written, a jump only goes to a function of the right type.
if(EMSCRIPTEN)
  function(taut_check_containers)
  endfunction()
  return()
endif()
# Decks come from anywhere, so the code that reads them is built to stop where it would write or read outside of its
# memory: bounds of C functions (FORTIFY) and of stack frames are checked, and in the layers that read, name and show
# those of the standard library's containers (taut_check_containers). The program's address is drawn by chance (PIE) and
# its table of functions is read-only (full RELRO).
# In the optimised builds only: FORTIFY needs -O1 at least, and the sanitizers check the same and more.
if(NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  set(optimised "$<CONFIG:Release,RelWithDebInfo,MinSizeRel>")
  # Some compilers come with a FORTIFY level of their own and warn of a second one.
  add_compile_options("$<${optimised}:-U_FORTIFY_SOURCE>" "$<${optimised}:-D_FORTIFY_SOURCE=2>"
    "$<${optimised}:-fstack-protector-strong>")
  add_link_options("$<${optimised}:LINKER:-z,relro,-z,now>")
endif()
# The library's code is position independent, so that a shared object can be made of it, a Python module for one.
# Its functions call and inline each other directly all the same, as if it were no shared object.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options(-fno-semantic-interposition)
endif()

# Not for the engine: with checked containers there a motion takes 1.31 times as long (1.10 with those of one half of
# taut/analysis alone); all the other flags together cost nothing that can be measured (0.99 to 1.00).
function(taut_check_containers)
  if(NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
    foreach(target IN LISTS ARGN)
      target_compile_options(${target} PRIVATE "$<$<CONFIG:Release,RelWithDebInfo,MinSizeRel>:-D_GLIBCXX_ASSERTIONS>")
    endforeach()
  endif()
endfunction()

include(CheckPIESupported)
check_pie_supported()
