# cmake -DPROGRAM=<taut> -DROOT=<source tree> -DPAGES=<folder> -DVERSION=<x.y.z> -P package_pages.cmake
#
# The files of an installation that the program prints or that are written for a package, in the folder PAGES. The
# install script runs it (cmake/package.cmake).
cmake_minimum_required(VERSION 3.25)
# Libraries that are compiled into the program and whose licences ask to be named.
set(compiled_in libhdf5-dev libsundials-dev libeigen3-dev libcli11-dev nlohmann-json3-dev libcpp-httplib-dev)
set(page_there FALSE)
if(EXISTS ${ROOT}/build-web/page)
  # its engine holds more of them
  set(page_there TRUE)
  list(APPEND compiled_in libyaml-cpp-dev libnlopt-dev libfmt-dev libexpected-dev libboost-dev libkainjow-mustache-dev)
endif()
file(REMOVE_RECURSE ${PAGES})
file(MAKE_DIRECTORY ${PAGES}/third-party)

function(print_page name)
  execute_process(COMMAND ${PROGRAM} ${ARGN} OUTPUT_FILE ${PAGES}/${name} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
function(compress name)
  execute_process(COMMAND gzip -9nf ${PAGES}/${name} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
# A text as a field of a Debian control file: a blank before each line, a dot for an empty one.
function(indented file result)
  file(READ ${file} text)
  string(REGEX REPLACE "\n+$" "" text "${text}")
  string(REPLACE "\n" "\n " text " ${text}")
  string(REGEX REPLACE "\n[ \t]+\n" "\n .\n" text "${text}")
  string(REGEX REPLACE "\n[ \t]+\n" "\n .\n" text "${text}")
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

print_page(taut.1 man)
compress(taut.1)
foreach(shell bash zsh fish)
  print_page(completion.${shell} completion ${shell})
endforeach()
print_page(taut.schema.json schema)

file(COPY_FILE ${ROOT}/CHANGELOG.md ${PAGES}/changelog)
compress(changelog)
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE ${PAGES}/changelog.Debian "taut (${VERSION}-1) unstable; urgency=medium

  * Package of taut ${VERSION}; changelog.gz says what is new in it.

 -- The taut authors <authors@taut.invalid>  ${date}
")
compress(changelog.Debian)

indented(${ROOT}/LICENSE licence)
indented(${ROOT}/taut/report/assets/taut_math.LICENSE.txt font_licence)
file(WRITE ${PAGES}/copyright "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: taut
Comment: The licences of the libraries that are compiled into the program are in the folder third-party.

Files: *
Copyright: 2026 The taut authors
License: MIT

Files: taut/report/assets/taut_math.woff2 taut/report/assets/taut_math_italic.woff2
Copyright: 2001-2011 the STI Pub Companies
           1998-2003 MicroPress, Inc.
           1990 Elsevier, Inc.
License: OFL-1.1

License: MIT
${licence}

License: OFL-1.1
${font_licence}
")
foreach(package IN LISTS compiled_in)
  if(EXISTS /usr/share/doc/${package}/copyright)
    file(COPY_FILE /usr/share/doc/${package}/copyright ${PAGES}/third-party/${package}.txt)
  else()
    message(WARNING "the licence of ${package} is missing; it belongs into a package that is passed on")
  endif()
endforeach()
if(page_there)
  set(modules ${ROOT}/web/node_modules)
  file(GLOB licences RELATIVE ${modules} ${modules}/@codemirror/*/LICENSE ${modules}/@lezer/*/LICENSE ${modules}/@marijn/*/LICENSE
    ${modules}/crelt/LICENSE ${modules}/style-mod/LICENSE ${modules}/w3c-keyname/LICENSE ${modules}/three/LICENSE
    ${modules}/uplot/LICENSE)
  if(NOT licences)
    message(WARNING "the licences of the page's parts are missing: npm --prefix web ci")
  endif()
  foreach(licence IN LISTS licences)
    cmake_path(GET licence PARENT_PATH name)
    string(REGEX REPLACE "^@" "" name "${name}")
    string(REPLACE "/" "-" name "page-${name}")
    file(COPY_FILE ${modules}/${licence} ${PAGES}/third-party/${name}.txt)
  endforeach()
endif()
