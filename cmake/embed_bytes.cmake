# The script half of taut_embed: writes one .cpp with the bytes of FILES (separated by |) as string literals.
# Every byte is written as \xHH: no delimiter to choose, no quoting, and a literal compiles far faster than an array.
cmake_minimum_required(VERSION 3.25)

function(literal file out_text out_size)
  file(READ ${file} hex HEX)
  string(LENGTH "${hex}" digits)
  math(EXPR size "${digits} / 2")
  # Short lines keep editors and error messages usable; adjacent literals are joined by the compiler.
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" text "${hex}")
  string(REPEAT "." 320 line)
  string(REGEX REPLACE "(${line})" "\\1\"\n    \"" text "${text}")
  set(${out_text} "\n    \"${text}\"" PARENT_SCOPE)
  set(${out_size} ${size} PARENT_SCOPE)
endfunction()

string(REPLACE "|" ";" FILES "${FILES}")
set(body)
if(TABLE)
  set(count 0)
  foreach(file IN LISTS FILES)
    literal(${file} text size)
    cmake_path(GET file FILENAME name)
    string(APPEND body "    {\"${name}\", std::string_view(${text}, ${size})},\n")
    math(EXPR count "${count} + 1")
  endforeach()
  set(definition
"namespace {
constexpr std::pair<std::string_view, std::string_view> rows[${count}] = {
${body}};
}  // namespace
constinit const std::span<const std::pair<std::string_view, std::string_view>> ${NAME}(rows);")
else()
  literal(${FILES} text size)
  set(definition "constinit const std::string_view ${NAME}(${text}, ${size});")
endif()

file(WRITE ${OUTPUT}
"// Made by taut_embed; do not edit.
#include \"${HEADER}\"

#ifdef __clang__
#pragma clang diagnostic ignored \"-Woverlength-strings\"
#endif

namespace ${NAMESPACE} {
${definition}
}  // namespace ${NAMESPACE}
")
