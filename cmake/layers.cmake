# The layer rule, in one table: what each layer may include besides itself. An include only goes down.
# check_layers.cmake enforces it, one ctest per layer; a line here is a decision about the design.

set(layers base units math calc catalogue rope structure model analysis methods report io app study cli web python)

set(may_base)
set(may_units base)
set(may_math base)
set(may_calc ${may_units} units math)
set(may_catalogue ${may_calc} calc)

# The engine: general mechanics.
set(may_rope ${may_catalogue} catalogue)
set(may_structure ${may_catalogue} catalogue)
set(may_model ${may_catalogue} catalogue rope structure)
set(may_analysis ${may_model} model)

# The published calculations: the other wing, which never sees the engine nor is seen by it.
set(may_methods ${may_catalogue} catalogue)

set(may_report ${may_calc} calc) # a report is made of a Result, and of nothing else
set(may_io ${may_catalogue} catalogue)
set(may_app ${may_analysis} analysis methods report io)
set(may_study ${may_app} app)

# The doors: they parse, call app::run and print; no mechanics.
set(may_cli ${may_catalogue} catalogue report io app study)
set(may_web ${may_cli})
set(may_python ${may_cli})

# Parts of others that stay behind one layer: "<regular expression of the header> <layers that may include it>".
# Tests are free of this second rule, not of the first.
set(fenced_headers
  "^yaml-cpp/ io"
  "^udunits2?\\.h$ tests"
  "^nlohmann/ io app cli"
  "^kainjow/ report"
  "^CLI/ cli"
  "^httplib\\.h$ web"
  "^pybind11/ python"
  "^nlopt\\.h$ analysis"
  "^hdf5\\.h$ io"
  "^(kinsol|cvode|ida|sunlinsol|sunmatrix|nvector|sundials)/ analysis")
