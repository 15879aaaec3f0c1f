# What a C++ user of the library includes. These headers and those that they include are installed, and no other: at
# most 30 of the former and 55 in all. test/consumer compiles each of them alone, from where they were installed.
set(public_headers
  taut/taut.hpp
  taut/app/job.hpp                    # run a deck: the one funnel of all doors
  taut/base/version.hpp
  taut/calc/sheet.hpp                 # an own method: formulas that record themselves
  taut/units/parse.hpp
  taut/catalogue/section.hpp
  taut/rope/span.hpp                  # one elastic catenary
  taut/rope/contact.hpp               # the law of a rope on a round
  taut/machine/builder.hpp            # a machine in code, by names
  taut/machine/compile.hpp            # description -> model
  taut/machine/model.hpp
  taut/solve/equilibrium.hpp
  taut/solve/condition.hpp            # equilibrium with a sag or tension given instead
  taut/solve/modes.hpp
  taut/solve/motion/transient.hpp
  taut/study/load_path.hpp
  taut/study/payload.hpp
  taut/study/limits.hpp
  taut/study/line/put_up_all.hpp      # guys and lines get their lengths
  taut/methods/mast_section/mast_section.hpp
  taut/methods/closed_loop/closed_loop.hpp
  taut/methods/friction_drive/friction_drive.hpp
  taut/methods/boom_ropes/boom_ropes.hpp)

# All headers of ours that `headers` include, themselves too, in `result`.
function(taut_included_headers root result headers)
  set(found)
  set(open ${headers})
  while(open)
    list(POP_FRONT open header)
    if(header IN_LIST found)
      continue()
    endif()
    list(APPEND found ${header})
    file(STRINGS ${root}/${header} lines REGEX "^#include \"taut/")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" other "${line}")
      list(APPEND open ${other})
    endforeach()
  endwhile()
  list(SORT found)
  set(${result} ${found} PARENT_SCOPE)
endfunction()
