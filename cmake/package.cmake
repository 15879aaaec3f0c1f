# What is installed with the program, and the Debian package made of it (`./dev package`, `cpack`). The man page, the
# completions and the schema are printed by the program itself while it is installed.
set(pages ${PROJECT_BINARY_DIR}/pages)
set(doc_folder ${CMAKE_INSTALL_DATADIR}/doc/taut)
install(TARGETS taut_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
install(CODE "execute_process(COMMAND \"${CMAKE_COMMAND}\" \"-DPROGRAM=$<TARGET_FILE:taut_cli>\"
  \"-DROOT=${PROJECT_SOURCE_DIR}\" \"-DPAGES=${pages}\" -DVERSION=${PROJECT_VERSION}
  -P \"${PROJECT_SOURCE_DIR}/cmake/package_pages.cmake\" COMMAND_ERROR_IS_FATAL ANY)" COMPONENT program)
install(FILES ${pages}/taut.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(FILES ${pages}/completion.bash RENAME taut DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
  COMPONENT program)
install(FILES ${pages}/completion.zsh RENAME _taut DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions
  COMPONENT program)
install(FILES ${pages}/completion.fish RENAME taut.fish
  DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT program)
install(FILES ${pages}/taut.schema.json DESTINATION ${CMAKE_INSTALL_DATADIR}/taut COMPONENT program)
# What `taut serve` sends, where `./dev web` has made it.
install(DIRECTORY build-web/page DESTINATION ${CMAKE_INSTALL_DATADIR}/taut COMPONENT program OPTIONAL)
install(FILES README.md ${pages}/copyright ${pages}/changelog.gz ${pages}/changelog.Debian.gz DESTINATION ${doc_folder}
  COMPONENT program)
install(DIRECTORY ${pages}/third-party DESTINATION ${doc_folder} COMPONENT program)
install(DIRECTORY docs DESTINATION ${doc_folder} COMPONENT program PATTERN "*.py" EXCLUDE)
install(DIRECTORY examples DESTINATION ${doc_folder} COMPONENT program PATTERN cpp EXCLUDE PATTERN python EXCLUDE)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME taut)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "checked, explained calculations of rope-driven machines")
set(CPACK_PACKAGE_DESCRIPTION "taut calculates cable yarders, skylines, rope saws, telescopic booms,
tackles and guyed masts. A text file describes the machine or names a
published method. The answer is a report that an engineer can sign:
formulas with their numbers, limits, drawings, and a verdict.")
set(CPACK_PACKAGE_CONTACT "The taut authors <authors@taut.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL program) # the library is installed with `cmake --install`
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "chromium, xdg-utils") # for --pdf and --open
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)
