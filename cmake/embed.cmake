# taut_embed: puts files into the program, so that it runs from anywhere and needs nothing beside it.
#
#   taut_embed(TARGET taut NAMESPACE taut::catalogue::embedded NAME ropes_csv FILE data/ropes/ropes.csv)
#
# makes a header, included under the path that the namespace spells,
#
#   #include "taut/catalogue/embedded/ropes_csv.hpp"   // namespace taut::catalogue::embedded
#                                                      // { extern const std::string_view ropes_csv; }
#
# and compiles the bytes into TARGET. Any bytes do: text, CSV, fonts. The view lives as long as the program, is ready
# before main() and before every other static object. Paths are relative to the folder of the project's CMakeLists.txt.
#
#   taut_embed(TARGET taut NAMESPACE taut::app::embedded NAME examples FILES examples/a.yaml examples/b.yaml)
#
# makes a table in the order given, keyed by the file's name without its folder:
#
#   extern const std::span<const std::pair<std::string_view, std::string_view>> examples;   // {"a.yaml", "..."}, ...
#
# The header is for .cpp files of TARGET and its tests; it is not installed, so no public header may include it.
# A change of a file rebuilds only its own bytes. Call it in taut/<layer>/embed.cmake, which the build picks up by itself.
function(taut_embed)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "TARGET;NAMESPACE;NAME;FILE" "FILES")
  foreach(needed TARGET NAMESPACE NAME)
    if(NOT arg_${needed})
      message(FATAL_ERROR "taut_embed: ${needed} is missing")
    endif()
  endforeach()
  if(arg_UNPARSED_ARGUMENTS OR (arg_FILE AND arg_FILES) OR NOT (arg_FILE OR arg_FILES))
    message(FATAL_ERROR "taut_embed: give either FILE or FILES, and nothing else (${arg_UNPARSED_ARGUMENTS})")
  endif()

  set(files)
  foreach(file IN LISTS arg_FILE arg_FILES)
    cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
    if(NOT EXISTS ${file})
      message(FATAL_ERROR "taut_embed: no such file: ${file}")
    endif()
    list(APPEND files ${file})
  endforeach()

  string(REPLACE "::" "/" folder ${arg_NAMESPACE})
  set(root ${PROJECT_BINARY_DIR}/embedded)
  set(stem ${root}/${folder}/${arg_NAME})
  if(arg_FILE)
    set(declaration "extern const std::string_view ${arg_NAME};")
    set(headers "#include <string_view>")
  else()
    set(declaration
        "extern const std::span<const std::pair<std::string_view, std::string_view>> ${arg_NAME};")
    set(headers "#include <span>\n#include <string_view>\n#include <utility>")
  endif()
  file(CONFIGURE OUTPUT ${stem}.hpp @ONLY CONTENT
"// Made by taut_embed; do not edit.
#pragma once

@headers@

namespace @arg_NAMESPACE@ {
@declaration@
}  // namespace @arg_NAMESPACE@
")

  set(script ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/embed_bytes.cmake)
  # A semicolon would split the list into several arguments of the command.
  string(REPLACE ";" "|" joined "${files}")
  add_custom_command(
    OUTPUT ${stem}.cpp
    COMMAND ${CMAKE_COMMAND} "-DOUTPUT=${stem}.cpp" "-DHEADER=${folder}/${arg_NAME}.hpp" "-DNAMESPACE=${arg_NAMESPACE}"
            "-DNAME=${arg_NAME}" "-DTABLE=$<BOOL:${arg_FILES}>" "-DFILES=${joined}" -P ${script}
    DEPENDS ${files} ${script}
    COMMENT "Embedding ${arg_NAMESPACE}::${arg_NAME}"
    VERBATIM)
  target_sources(${arg_TARGET} PRIVATE ${stem}.cpp)
  set_source_files_properties(${stem}.cpp PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
  target_include_directories(${arg_TARGET} PUBLIC $<BUILD_INTERFACE:${root}>)
endfunction()
