# The tables as bytes in the library: the program needs no data folder at run time.
taut_embed(TARGET taut NAMESPACE taut::catalogue::embedded NAME ropes_csv FILE data/ropes/ropes.csv)
taut_embed(TARGET taut NAMESPACE taut::catalogue::embedded NAME rope_factors_csv FILE data/ropes/rope_factors.csv)
taut_embed(TARGET taut NAMESPACE taut::catalogue::embedded NAME sections_csv FILE data/sections/sections.csv)
taut_embed(TARGET taut NAMESPACE taut::catalogue::embedded NAME steels_csv FILE data/steels.csv)
taut_embed(TARGET taut NAMESPACE taut::catalogue::embedded NAME rules_csv FILES
  data/rules/safety_factors.csv data/rules/diameter_ratios.csv data/rules/grooves.csv data/rules/friction.csv
  data/rules/sheave_efficiency.csv data/rules/terminations.csv data/rules/buckling_curves.csv
  data/rules/hoist_factors.csv data/rules/layout_limits.csv data/rules/rope_modulus.csv
  data/rules/groove_pressures.csv data/rules/wires.csv data/rules/temperatures.csv data/rules/life.csv
  data/rules/discard.csv)
taut_embed(TARGET taut NAMESPACE taut::catalogue::embedded NAME anchor_trees_csv FILE data/trees/anchor_trees.csv)
taut_embed(TARGET taut NAMESPACE taut::catalogue::embedded NAME support_trees_csv FILE data/trees/support_trees.csv)
taut_embed(TARGET taut NAMESPACE taut::catalogue::embedded NAME carriages_csv FILE data/carriages/carriages.csv)
taut_embed(TARGET taut NAMESPACE taut::catalogue::embedded NAME yarders_csv FILE data/yarders/yarders.csv)
