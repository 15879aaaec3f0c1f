# SUNDIALS' IDA, which integrates the reference of motions. As archives where there are any: nothing of it has to be
# installed where the program runs.
find_path(SUNDIALS_INCLUDE ida/ida.h REQUIRED)
add_library(taut_sundials INTERFACE)
target_include_directories(taut_sundials SYSTEM INTERFACE $<BUILD_INTERFACE:${SUNDIALS_INCLUDE}>)
foreach(part ida sunlinsoldense sunmatrixdense nvecserial generic)
  find_library(SUNDIALS_${part} NAMES libsundials_${part}.a sundials_${part} REQUIRED)
  target_link_libraries(taut_sundials INTERFACE ${SUNDIALS_${part}})
endforeach()
target_link_libraries(taut_sundials INTERFACE m)
install(TARGETS taut_sundials EXPORT tautTargets)
