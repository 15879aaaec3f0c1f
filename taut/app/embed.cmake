# The example decks: `taut new` prints them, `taut explain` runs them.
file(GLOB example_decks CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/examples/*.yaml)
list(FILTER example_decks EXCLUDE REGEX "\\.part\\.yaml$")
taut_embed(TARGET taut NAMESPACE taut::app::embedded NAME examples FILES ${example_decks})
# Decks of machines: `taut new` prints those that run alone.
file(GLOB machine_decks CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/examples/machines/*.yaml)
list(FILTER machine_decks EXCLUDE REGEX "\\.part\\.yaml$")
taut_embed(TARGET taut NAMESPACE taut::app::embedded NAME machine_examples FILES ${machine_decks})
# `taut explain KEY` shows a line with the key, of an example that has it.
foreach(kind design motion)
  file(GLOB kind_decks CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/examples/${kind}/*.yaml)
  list(FILTER kind_decks EXCLUDE REGEX "\\.part\\.yaml$")
  taut_embed(TARGET taut NAMESPACE taut::app::embedded NAME ${kind}_examples FILES ${kind_decks})
endforeach()
