# cpp-httplib as Debian has it, compiled into a shared library with TLS and compression: its classes have the size that
# these definitions give them.
find_path(HTTPLIB_INCLUDE httplib.h REQUIRED)
find_library(HTTPLIB_LIBRARY NAMES cpp-httplib REQUIRED)
find_package(Threads REQUIRED)
add_library(taut_httplib INTERFACE)
target_include_directories(taut_httplib SYSTEM INTERFACE ${HTTPLIB_INCLUDE})
target_compile_definitions(taut_httplib INTERFACE CPPHTTPLIB_OPENSSL_SUPPORT CPPHTTPLIB_ZLIB_SUPPORT
  CPPHTTPLIB_BROTLI_SUPPORT)
target_link_libraries(taut_httplib INTERFACE ${HTTPLIB_LIBRARY} Threads::Threads)
