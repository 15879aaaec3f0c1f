# The Python package `taut` (TAUT_PYTHON): python/*.cpp as its module _taut, python/taut/*.py beside it. The build tree
# has it whole in the folder `python`, which is what PYTHONPATH names in the tests.
# Python3_EXECUTABLE is the distribution's interpreter where nobody says otherwise.
if(NOT Python3_EXECUTABLE AND NOT SKBUILD AND EXISTS /usr/bin/python3)
  set(Python3_EXECUTABLE /usr/bin/python3)
endif()
find_package(Python3 3.11 REQUIRED COMPONENTS Interpreter Development.Module NumPy)
set(PYBIND11_NOPYTHON ON)
find_package(pybind11 2.10 REQUIRED)

file(GLOB python_sources CONFIGURE_DEPENDS python/*.cpp)
file(GLOB python_files CONFIGURE_DEPENDS python/taut/*.py python/taut/*.pyi python/taut/py.typed)
Python3_add_library(taut_python MODULE WITH_SOABI ${python_sources})
target_link_libraries(taut_python PRIVATE taut pybind11::headers)
target_compile_options(taut_python PRIVATE ${quick_to_build} -fvisibility=hidden)
# Nothing of the library is seen from outside: another module may have another version of the same parts in it.
target_link_options(taut_python PRIVATE LINKER:--exclude-libs,ALL)
set(python_tree ${PROJECT_BINARY_DIR}/python)
set_target_properties(taut_python PROPERTIES TAUT_SHARED_HDF5 ON OUTPUT_NAME _taut LIBRARY_OUTPUT_DIRECTORY ${python_tree}/taut)
foreach(file IN LISTS python_files)
  cmake_path(GET file FILENAME name)
  add_custom_command(OUTPUT ${python_tree}/taut/${name}
    COMMAND ${CMAKE_COMMAND} -E copy ${file} ${python_tree}/taut/${name} DEPENDS ${file} VERBATIM)
  list(APPEND python_copies ${python_tree}/taut/${name})
endforeach()
add_custom_target(taut_python_files ALL DEPENDS ${python_copies})
add_dependencies(taut_python taut_python_files)
