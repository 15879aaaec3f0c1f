# Test programs, found by where their files lie. One per layer would instantiate the same templates a dozen times, so
# layers share a program (the table below); a layer that it does not name makes one of its own:
#   taut/<layer>/**/*_test.cpp           -> taut_<layer>_test
#   cli/*_test.cpp, web/*_test.cpp       -> taut_cli_test
#   test/<folder>/*_test.cpp             -> taut_whole_test
#   test/<folder>/*_test.py, *_test.sh   -> run with TAUT_PROGRAM and TAUT_SOURCE_DIR in the environment
# A folder that does not exist yet is simply no test. Several files are compiled as one (TAUT_UNITY), which more than
# halves the time: each has its own namespace, named like the file.
set(parts_layers base units math calc chance catalogue rope structure)
set(words_layers machine io report)
set(engine_layers mechanics solve study)
set(app_layers checks design results app)
include(GoogleTest)
# What hangs is ended at last. No test may come near it on a machine that has other things to do, so it is wide: a test
# that has to be quick asks for its processor time itself.
set(hangs_after 3600)
# Long series take fewer cases under the sanitizers (taut_test::watched, TAUT_FEWER, RapidCheck's properties here): what
# they look for there is a fault of the code, which the first cases walk through as the last ones do.
set(fewer_properties)
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  set(fewer_properties ENVIRONMENT RC_PARAMS=max_success=20)
endif()

function(taut_add_test name)
  add_executable(${name} ${ARGN})
  target_link_libraries(${name} PRIVATE taut_test_support)
  target_precompile_headers(${name} REUSE_FROM taut_test_support)
  # The library comes first, so that templates which both have instantiated are taken from it, as optimised there.
  target_link_options(${name} PRIVATE LINKER:--whole-archive,$<TARGET_FILE:taut>,--no-whole-archive)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/test
    UNITY_BUILD ${TAUT_UNITY} UNITY_BUILD_BATCH_SIZE ${tests_as_one})
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST TEST_PREFIX ${name}. PROPERTIES TIMEOUT ${hangs_after} ${fewer_properties})
endfunction()

set(library_tests ${taut_files})
list(FILTER library_tests INCLUDE REGEX "_test\\.cpp$")
file(GLOB folder_tests CONFIGURE_DEPENDS test/*/*_test.cpp)
# The longest come first, so that no core waits for the last.
set(groups engine parts words app methods whole)
foreach(file IN LISTS library_tests folder_tests)
  cmake_path(RELATIVE_PATH file BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE path)
  if(path MATCHES "^taut/([^/]+)/")
    set(group ${CMAKE_MATCH_1})
    foreach(shared parts words engine app)
      if(group IN_LIST ${shared}_layers)
        set(group ${shared})
      endif()
    endforeach()
  else()
    set(group whole)
  endif()
  list(APPEND groups ${group})
  list(APPEND files_${group} ${file})
endforeach()
list(REMOVE_DUPLICATES groups)
foreach(group IN LISTS groups)
  taut_add_test(taut_${group}_test ${files_${group}})
endforeach()
target_link_libraries(taut_parts_test PRIVATE UDUNITS2::UDUNITS2)
# test/house tries the build's own tools.
taut_embed(TARGET taut_whole_test NAMESPACE taut_test::embedded NAME bytes FILE test/house/bytes.bin)
taut_embed(TARGET taut_whole_test NAMESPACE taut_test::embedded NAME table FILES LICENSE test/house/bytes.bin)

file(GLOB cli_tests CONFIGURE_DEPENDS cli/*_test.cpp web/*_test.cpp)
if(cli_tests)
  taut_add_test(taut_cli_test ${cli_tests})
  target_link_libraries(taut_cli_test PRIVATE taut_cli_parts taut_serve_parts taut_serve_http)
  add_dependencies(taut_cli_test taut_cli)
endif()

file(GLOB script_tests CONFIGURE_DEPENDS test/*/*_test.py test/*/*_test.sh)
if(script_tests)
  # The distribution's interpreter: its packages (jsonschema, ruamel.yaml) are the ones ./dev installs.
  find_program(TAUT_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH REQUIRED)
  find_program(TAUT_BASH bash REQUIRED)
endif()
# Long series of decks take fewer cases under the sanitizers.
set(script_environment "TAUT_PROGRAM=${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/taut" "TAUT_SOURCE_DIR=${PROJECT_SOURCE_DIR}"
  "TAUT_EXAMPLE_RUNS=${PROJECT_BINARY_DIR}/test/example_runs")
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  list(APPEND script_environment "TAUT_FEWER=1")
endif()
foreach(file IN LISTS script_tests)
  cmake_path(GET file STEM name)
  cmake_path(GET file PARENT_PATH folder)
  cmake_path(GET folder FILENAME folder)
  if(file MATCHES "\\.py$")
    add_test(NAME ${folder}.${name} COMMAND ${TAUT_PYTHON} ${file})
  else()
    add_test(NAME ${folder}.${name} COMMAND ${TAUT_BASH} ${file})
  endif()
  # They are the longest and come last in the list: begun first, no core waits for one of them in the end.
  set_tests_properties(${folder}.${name} PROPERTIES
    ENVIRONMENT "${script_environment}" TIMEOUT ${hangs_after} COST 10)
endforeach()

# The examples are run once, for all tests that look at their answers.
add_test(NAME program.examples COMMAND ${TAUT_PYTHON} ${PROJECT_SOURCE_DIR}/test/program/example_runs.py)
set_tests_properties(program.examples PROPERTIES FIXTURES_SETUP example_runs
  ENVIRONMENT "${script_environment}" TIMEOUT ${hangs_after} PROCESSORS 2 COST 100)
foreach(name boom example_verdicts motion placement report)
  set_tests_properties(program.${name}_test PROPERTIES FIXTURES_REQUIRED example_runs)
endforeach()

# The rules of the house. Every folder below taut/ counts as a layer, so that a new one has to be placed in the table.
include(layers)
file(GLOB folders CONFIGURE_DEPENDS LIST_DIRECTORIES true RELATIVE ${PROJECT_SOURCE_DIR}/taut taut/*)
list(FILTER folders EXCLUDE REGEX "\\.") # taut.hpp includes of all rooms what users need
foreach(layer IN LISTS layers folders)
  if(NOT TEST layers.${layer})
    add_test(NAME layers.${layer} COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR} -DLAYER=${layer}
      -P ${PROJECT_SOURCE_DIR}/cmake/check_layers.cmake)
  endif()
endforeach()
add_test(NAME layers.check_works COMMAND ${CMAKE_COMMAND} -DWORK=${PROJECT_BINARY_DIR}/check_layers_test
  -P ${PROJECT_SOURCE_DIR}/cmake/check_layers_test.cmake)
add_test(NAME house.file_lengths COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR}
  -P ${PROJECT_SOURCE_DIR}/cmake/check_lengths.cmake)

# find_package(taut), as a stranger would: install into the build tree, configure, build and run a small program.
# Not under the sanitizers: a stranger does not link their runtime.
if(NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  add_test(NAME consumer COMMAND ${CMAKE_COMMAND} -DBUILD=${PROJECT_BINARY_DIR} -DCOMPILER=${CMAKE_CXX_COMPILER}
    -DVERSION=${PROJECT_VERSION} -P ${PROJECT_SOURCE_DIR}/test/consumer/run.cmake)
  set_tests_properties(consumer PROPERTIES TIMEOUT ${hangs_after})
endif()
