# cmake -DWORK=<scratch folder> -P check_layers_test.cmake
# Proves check_layers.cmake: in a made-up tree each forbidden include is refused by name, and the allowed ones pass.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${WORK})

function(expect layer file include wanted)
  file(REMOVE_RECURSE ${WORK}/tree)
  file(WRITE ${WORK}/tree/${file} "#pragma once\n#include <vector>\n${include}\n")
  execute_process(
    COMMAND ${CMAKE_COMMAND} -DROOT=${WORK}/tree -DLAYER=${layer} -P ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/check_layers.cmake
    RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE out)
  string(REGEX REPLACE "[ \n]+" " " out "${out}")
  string(FIND "${out}" "${wanted}" place)
  if(wanted STREQUAL "passes" AND NOT code EQUAL 0)
    message(SEND_ERROR "${file} with '${include}' should pass, but: ${out}")
  elseif(NOT wanted STREQUAL "passes" AND (code EQUAL 0 OR place EQUAL -1))
    message(SEND_ERROR "${file} with '${include}' should fail with '${wanted}', but (${code}): ${out}")
  endif()
endfunction()

# Down: allowed.
expect(calc taut/calc/a.hpp "#include \"taut/units/unit.hpp\"" passes)
expect(app taut/app/a.cpp "#include \"taut/solve/equilibrium.hpp\"" passes)
expect(methods taut/methods/boom/a.cpp "#include \"taut/methods/boom/a.hpp\"" passes)
expect(cli cli/main.cpp "#include \"taut/app/run.hpp\"" passes)
# Up.
expect(base taut/base/a.hpp "#include \"taut/units/unit.hpp\"" "base must not see units")
expect(calc taut/calc/a_test.cpp "#include \"taut/report/html.hpp\"" "calc must not see report")
expect(app taut/app/a.cpp "#include \"cli/options.hpp\"" "app must not see cli")
# Sideways.
expect(units taut/units/a.cpp "#  include  <taut/math/root.hpp>" "units must not see math")
expect(report taut/report/a.cpp "#include \"taut/io/json.hpp\"" "report must not see io")
# The two wings never meet below app.
expect(methods taut/methods/boom/a.cpp "#include \"taut/structure/mast.hpp\"" "methods must not see structure")
expect(methods taut/methods/boom/a.cpp "#include \"taut/rope/contact.hpp\"" "methods must not see rope")
expect(solve taut/solve/a.cpp "#include \"taut/methods/boom/boom.hpp\"" "solve must not see methods")
expect(machine taut/machine/a.cpp "#include \"taut/methods/boom/boom.hpp\"" "machine must not see methods")
# Rooms that are closed to the layers above, but not to their tests.
expect(study taut/study/a.cpp "#include \"taut/solve/rest/newton.hpp\"" "taut/solve/rest/newton.hpp: an inside of solve")
expect(study taut/study/a.cpp "#include \"taut/mechanics/branch.hpp\"" "an inside of solve")
expect(study taut/study/a_test.cpp "#include \"taut/mechanics/branch.hpp\"" passes)
expect(study taut/study/a.cpp "#include \"taut/solve/motion/transient.hpp\"" passes)
expect(solve taut/solve/rest/a.cpp "#include \"taut/mechanics/branch.hpp\"" passes)
# Doors hold no mechanics.
expect(cli cli/main.cpp "#include \"taut/methods/boom/boom.hpp\"" "cli must not see methods")
# Paths that hide the layer.
expect(base taut/base/a.cpp "#include \"../units/unit.hpp\"" "spell the whole path")
expect(base taut/base/a.cpp "#include \"unit.hpp\"" "spelt with their whole path")
expect(base taut/base/a.cpp "#include \"test/paths.hpp\"" "only tests see test/")
# Parts of others behind one layer.
expect(io taut/io/a.cpp "#include <yaml-cpp/yaml.h>" passes)
expect(calc taut/calc/a.cpp "#include <yaml-cpp/yaml.h>" "<yaml-cpp/yaml.h>: stays behind io")
expect(units taut/units/a.cpp "#include <udunits2.h>" "<udunits2.h>: stays behind tests")
expect(units taut/units/a_test.cpp "#include <udunits2.h>" passes)
expect(methods taut/methods/boom/a.cpp "#include <nlohmann/json.hpp>" "<nlohmann/json.hpp>: stays behind")
expect(app taut/app/a.cpp "#include <CLI/CLI.hpp>" "<CLI/CLI.hpp>: stays behind cli")
# A layer nobody has placed yet.
expect(misc taut/misc/a.cpp "" "is not in the table")
