# The Python package `taut` (TAUT_PYTHON_PACKAGE): python/*.cpp as its module _taut, python/taut/*.py beside it. The
# build tree has it whole in the folder `python`, which is what PYTHONPATH names in the tests. Python3_EXECUTABLE is the
# distribution's interpreter where nobody says otherwise.
if(NOT Python3_EXECUTABLE AND NOT SKBUILD AND EXISTS /usr/bin/python3)
  set(Python3_EXECUTABLE /usr/bin/python3)
endif()
find_package(Python3 3.11 REQUIRED COMPONENTS Interpreter Development.Module)
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

# ---- what is installed, and its Debian package
set(PYTHON_INSTALL_FOLDER "lib/python3/dist-packages" CACHE STRING "Where the package `taut` is installed")
if(SKBUILD)
  set(PYTHON_INSTALL_FOLDER ".")
endif()
install(TARGETS taut_python LIBRARY DESTINATION ${PYTHON_INSTALL_FOLDER}/taut COMPONENT python)
install(FILES ${python_files} DESTINATION ${PYTHON_INSTALL_FOLDER}/taut COMPONENT python)
if(NOT SKBUILD)
  set(python_doc ${CMAKE_INSTALL_DATADIR}/doc/python3-taut)
  install(DIRECTORY examples DESTINATION ${python_doc} COMPONENT python PATTERN cpp EXCLUDE)
  install(FILES docs/guide/python.md DESTINATION ${python_doc} COMPONENT python)
  # of the program's package, which the install script of package.cmake has made
  install(FILES ${PROJECT_BINARY_DIR}/pages/copyright ${PROJECT_BINARY_DIR}/pages/changelog.gz
    ${PROJECT_BINARY_DIR}/pages/changelog.Debian.gz DESTINATION ${python_doc} COMPONENT python)
  install(DIRECTORY ${PROJECT_BINARY_DIR}/pages/third-party DESTINATION ${python_doc} COMPONENT python)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/CPackPythonConfig.cmake @ONLY CONTENT [[
# cpack --config: the same as the program's package, with another name and other files.
include("@PROJECT_BINARY_DIR@/CPackConfig.cmake")
set(CPACK_PACKAGE_NAME python3-taut)
set(CPACK_COMPONENTS_ALL python)
set(CPACK_PACKAGE_FILE_NAME python3-taut)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "rope-driven machines in Python: decks, arrays, reports")
set(CPACK_DEBIAN_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3 (>= 3.11), python3 (<< 3.12), python3-numpy")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "python3-pandas, python3-matplotlib, python3-pint, taut")
]])
endif()

# ---- tests: ctest -L python (./dev python)
if(NOT SKBUILD)
  enable_testing()
  file(GLOB python_tests CONFIGURE_DEPENDS python/test/*_test.py)
  foreach(file IN LISTS python_tests)
    cmake_path(GET file STEM name)
    add_test(NAME python.${name} COMMAND ${Python3_EXECUTABLE} ${file})
    set_tests_properties(python.${name} PROPERTIES LABELS python TIMEOUT 3600 ENVIRONMENT
      "PYTHONPATH=${python_tree};TAUT_SOURCE_DIR=${PROJECT_SOURCE_DIR};TAUT_PROGRAM=${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/taut;TAUT_BUILD_DIR=${PROJECT_BINARY_DIR};MPLBACKEND=Agg")
  endforeach()
  add_test(NAME python.stub_is_fresh COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/python/tools/make_stub.py
    --check ${PROJECT_SOURCE_DIR}/python/taut)
  set_tests_properties(python.stub_is_fresh PROPERTIES LABELS python ENVIRONMENT "PYTHONPATH=${python_tree}")
endif()
