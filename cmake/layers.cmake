# The layer rule, in one table: what each layer may include besides itself. An include only goes down.
# check_layers.cmake enforces it, one ctest per layer; a line here is a decision about the design.

set(layers base units math calc chance catalogue rope structure machine mechanics solve study checks design results
  methods report io app cli web python)

set(may_base)
set(may_units base)
set(may_math base)
set(may_chance ${may_math} math)
set(may_calc ${may_units} units math)
set(may_catalogue ${may_calc} calc)

# The engine: general mechanics. What asks it, judges it and shows it stands above.
set(may_rope ${may_catalogue} catalogue)
set(may_structure ${may_catalogue} catalogue)
set(may_machine ${may_catalogue} catalogue rope structure)
set(may_mechanics ${may_machine} machine)
set(may_solve ${may_mechanics} mechanics)
set(may_study ${may_solve} solve chance)
set(may_checks ${may_study} study)
set(may_design ${may_checks} checks)
set(may_results ${may_checks} checks)

# The published calculations: the other wing, which never sees the engine nor is seen by it.
set(may_methods ${may_catalogue} catalogue)

set(may_report ${may_calc} calc) # a report is made of a Result, and of nothing else
set(may_io ${may_catalogue} catalogue)
set(may_app ${may_results} results design methods report io)

# The doors: they parse, call app::run and print; no mechanics.
set(may_web ${may_catalogue} catalogue report io app)
set(may_python ${may_web})
set(may_cli ${may_web} web) # taut serve

# What only the layers at work in it may include, beside tests: "<regular expression of the header> <inside of> <layers>".
set(closed_rooms
  "^taut/mechanics/ solve mechanics solve"
  "^taut/solve/rest/ solve solve"
  "^taut/solve/motion/(parts|step|run)/ solve solve")

# Parts of others that stay behind one layer: "<regular expression of the header> <layers that may include it>".
# Tests are free of this second rule, not of the first.
set(fenced_headers
  "^yaml-cpp/ io"
  "^udunits2?\\.h$ tests"
  "^nlohmann/ io results app cli web"
  "^kainjow/ report"
  "^CLI/ cli"
  "^httplib\\.h$ web"
  "^pybind11/ python"
  "^nlopt\\.h$ design chance"
  "^hdf5\\.h$ io"
  "^oneapi/tbb/ app"
  "^(kinsol|cvode|ida|sunlinsol|sunmatrix|nvector|sundials)/ mechanics solve")
