# cmake -DBUILD=<build folder> -DCOMPILER=<c++> -DVERSION=<x.y.z> -P run.cmake: the ctest `consumer`.
cmake_minimum_required(VERSION 3.25)
set(work ${BUILD}/consumer)
file(REMOVE_RECURSE ${work})

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(NOT code EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nended with ${code}:\n${out}")
  endif()
  set(out "${out}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${work}/prefix)
# The install must not lean on the source tree or the build tree.
set(root ${CMAKE_CURRENT_LIST_DIR}/../..)
file(COPY ${CMAKE_CURRENT_LIST_DIR}/CMakeLists.txt ${CMAKE_CURRENT_LIST_DIR}/main.cpp DESTINATION ${work}/source)
file(COPY ${root}/examples/cpp/ DESTINATION ${work}/source/programs)
# The program that the guide shows is one of them.
file(READ ${root}/docs/guide/cpp.md guide)
string(REGEX MATCH "```cpp\n([^`]*)```" found "${guide}")
file(WRITE ${work}/source/programs/guide.cpp "${CMAKE_MATCH_1}")
run(${CMAKE_COMMAND} -S ${work}/source -B ${work}/build -G Ninja -DCMAKE_CXX_COMPILER=${COMPILER}
  -DCMAKE_PREFIX_PATH=${work}/prefix -DWANTED=${VERSION} -DPUBLIC_HEADERS=${root}/cmake/public_headers.cmake)
run(${CMAKE_COMMAND} --build ${work}/build)
run(${work}/build/consumer)
message("${out}")
if(NOT out MATCHES "taut ${VERSION}")
  message(FATAL_ERROR "The consumer should name version ${VERSION}")
endif()

# Each program ends with 0 where its numbers are what they should be.
file(GLOB programs ${work}/source/programs/*.cpp)
foreach(file IN LISTS programs)
  cmake_path(GET file STEM name)
  run(${work}/build/programs/${name})
  message("${name}: ${out}")
endforeach()
