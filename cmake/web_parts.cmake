# Parts of others for WebAssembly. Debian has no packages for it, so headers are those of the native packages, and the
# four libraries with code are compiled from Debian's source packages, which `./dev web` puts into TAUT_WEB_SOURCES.
# Defines the same targets as the native build, so that the library's own lines do not change.
enable_language(C)
set(TAUT_WEB_SOURCES "" CACHE PATH "Folder with Debian's source packages of yaml-cpp, NLopt and SUNDIALS")

# Exceptions by the engine of the browser: those of JavaScript make each call that may throw ten times as long.
add_compile_options(-fwasm-exceptions)
add_link_options(-fwasm-exceptions)

# Only these folders: the rest of /usr/include belongs to the C library of this machine.
set(web_headers ${PROJECT_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${web_headers})
foreach(folder fmt tl boost eigen3 nlohmann kainjow)
  if(NOT EXISTS /usr/include/${folder})
    message(FATAL_ERROR "/usr/include/${folder} is missing: ./dev web installs it")
  endif()
  file(CREATE_LINK /usr/include/${folder} ${web_headers}/${folder} SYMBOLIC)
endforeach()

function(taut_web_headers target folder)
  add_library(${target} INTERFACE IMPORTED)
  target_include_directories(${target} SYSTEM INTERFACE ${folder})
endfunction()
taut_web_headers(fmt::fmt ${web_headers})
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
taut_web_headers(tl::expected ${web_headers})
taut_web_headers(Boost::headers ${web_headers})
# long double has 128 bits there and is computed by software: with it a column takes fifteen times as long.
target_compile_definitions(Boost::headers INTERFACE BOOST_MATH_PROMOTE_DOUBLE_POLICY=false)
taut_web_headers(nlohmann_json::nlohmann_json ${web_headers})
taut_web_headers(Eigen3::Eigen ${web_headers}/eigen3)

# taut_web_source(FOLDER NAME): the one folder of that source package.
function(taut_web_source variable name)
  file(GLOB found LIST_DIRECTORIES true ${TAUT_WEB_SOURCES}/${name}-*)
  list(FILTER found EXCLUDE REGEX "\\.(xz|gz|dsc|asc)$")
  list(LENGTH found count)
  if(NOT count EQUAL 1)
    message(FATAL_ERROR "TAUT_WEB_SOURCES has ${count} folders ${name}-*: ./dev web makes one")
  endif()
  set(${variable} ${found} PARENT_SCOPE)
endfunction()

# Code of others is compiled without our warnings.
function(taut_web_library target)
  add_library(${target} STATIC ${ARGN})
  target_compile_options(${target} PRIVATE -w)
  set_target_properties(${target} PROPERTIES UNITY_BUILD OFF)
endfunction()

taut_web_source(yaml yaml-cpp)
file(GLOB yaml_sources ${yaml}/src/*.cpp)
taut_web_library(yaml-cpp ${yaml_sources})
target_include_directories(yaml-cpp SYSTEM PUBLIC ${yaml}/include)

# IDA with its own headers and the native package's settings, but for MPI, which a browser has not.
taut_web_source(sundials sundials)
file(READ /usr/include/sundials/sundials_config.h settings)
string(REPLACE "#define SUNDIALS_MPI_ENABLED 1" "#define SUNDIALS_MPI_ENABLED 0" settings "${settings}")
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/sundials/sundials/sundials_config.h CONTENT "${settings}" @ONLY)
file(COPY_FILE /usr/include/sundials/sundials_export.h ${PROJECT_BINARY_DIR}/sundials/sundials/sundials_export.h)
file(GLOB sundials_sources ${sundials}/src/ida/*.c ${sundials}/src/sundials/*.c ${sundials}/src/sunlinsol/dense/*.c
  ${sundials}/src/sunmatrix/dense/*.c ${sundials}/src/sunmatrix/band/*.c ${sundials}/src/nvector/serial/*.c
  ${sundials}/src/sunnonlinsol/newton/*.c)
list(FILTER sundials_sources EXCLUDE REGEX "/f[a-z]+_[a-z]+\\.c$|xbraid")
taut_web_library(taut_sundials ${sundials_sources})
target_include_directories(taut_sundials SYSTEM PUBLIC ${PROJECT_BINARY_DIR}/sundials ${sundials}/include
  PRIVATE ${sundials}/src ${sundials}/src/sundials)

taut_web_source(nlopt nlopt)
foreach(part CXX FORTRAN PYTHON OCTAVE MATLAB GUILE SWIG TESTS)
  set(NLOPT_${part} OFF CACHE BOOL "" FORCE)
endforeach()
set(BUILD_SHARED_LIBS OFF CACHE BOOL "" FORCE)
add_subdirectory(${nlopt} ${PROJECT_BINARY_DIR}/nlopt EXCLUDE_FROM_ALL)
target_compile_options(nlopt PRIVATE -w)
add_library(taut_nlopt INTERFACE)
target_link_libraries(taut_nlopt INTERFACE nlopt)
target_include_directories(taut_nlopt SYSTEM INTERFACE ${PROJECT_BINARY_DIR}/nlopt)

# There are no threads and no HDF5: see taut/app/cases/on_threads.hpp and taut/io/hdf5.cpp.
add_library(taut_hdf5 INTERFACE)
add_library(TBB::tbb INTERFACE IMPORTED)
