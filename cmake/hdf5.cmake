# HDF5's C library, serial. As an archive where there is one: Debian's shared library draws in the whole of libcurl (for
# files on the net), which would make every start of the program five times as long.
find_path(HDF5_INCLUDE hdf5.h PATH_SUFFIXES hdf5/serial REQUIRED)
find_library(HDF5_ARCHIVE NAMES libhdf5_serial.a libhdf5.a)
find_library(HDF5_SZ NAMES sz)
find_library(HDF5_Z NAMES z)
add_library(taut_hdf5 INTERFACE)
target_include_directories(taut_hdf5 SYSTEM INTERFACE $<BUILD_INTERFACE:${HDF5_INCLUDE}>)
find_library(HDF5_SHARED NAMES hdf5_serial hdf5 REQUIRED)
if(HDF5_ARCHIVE AND HDF5_SZ AND HDF5_Z)
  # Debian's archive is not position independent: a target that is a shared object has the property TAUT_SHARED_HDF5.
  set(in_module "$<BOOL:$<TARGET_PROPERTY:TAUT_SHARED_HDF5>>")
  target_link_libraries(taut_hdf5 INTERFACE
    "$<IF:${in_module},${HDF5_SHARED},${HDF5_ARCHIVE};${HDF5_SZ};${HDF5_Z};${CMAKE_DL_LIBS};m>")
else()
  target_link_libraries(taut_hdf5 INTERFACE ${HDF5_SHARED})
endif()
install(TARGETS taut_hdf5 EXPORT tautTargets)
