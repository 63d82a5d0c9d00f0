# Installation, and a package of Debian: `cmake --build build/release --target deb`.
# Debian has another program called clevis (unlocking of disks): both cannot be
# installed at once, so the package is called clevis-links. docs/installation.md
# says what lies where; tests/package/try_package tries it on a bare Debian 12.
set(package clevis-links)
include(GNUInstallDirs)
set(CMAKE_INSTALL_DOCDIR ${CMAKE_INSTALL_DATAROOTDIR}/doc/${package})
install(FILES README.md CHANGELOG.md CONTRIBUTING.md LICENSE.md TYPE DOC)
install(FILES LICENSE.md DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR}
        FILES_MATCHING PATTERN "*.md" PATTERN "*.json" PATTERN "*.svg"
        PATTERN "*.txt")
# The documents link to these: they lie beside one another as in the sources.
install(DIRECTORY results/studies DESTINATION ${CMAKE_INSTALL_DOCDIR}/results
        FILES_MATCHING PATTERN "*.md" PATTERN "*.svg" PATTERN "*.png" PATTERN "*.txt"
        PATTERN "*.csv")
foreach(name compare error faces impact modes plan result scene simulate study
        transmission view_motion view_part)
  install(FILES docs/${name}.schema.json
          DESTINATION ${CMAKE_INSTALL_DATADIR}/clevis)
endforeach()
install(DIRECTORY geometry DESTINATION ${CMAKE_INSTALL_DOCDIR}
        FILES_MATCHING PATTERN "*.toml" PATTERN "*.geo" PATTERN "*.step" PATTERN "*.csv")
# Not those that clevis made here: of STEP files and of variants.
install(DIRECTORY meshes DESTINATION ${CMAKE_INSTALL_DOCDIR}
        FILES_MATCHING PATTERN "*.msh" PATTERN "step" EXCLUDE
        PATTERN "*-????????????????.msh" EXCLUDE)

# Completion, as `clevis completion` prints it.
set(completions ${CMAKE_BINARY_DIR}/completions)
file(MAKE_DIRECTORY ${completions})
foreach(shell bash zsh fish)
  add_custom_command(OUTPUT ${completions}/clevis.${shell}
                     COMMAND clevis completion ${shell} >clevis.${shell}
                     DEPENDS clevis WORKING_DIRECTORY ${completions})
endforeach()
add_custom_target(completions ALL DEPENDS ${completions}/clevis.bash
                  ${completions}/clevis.zsh ${completions}/clevis.fish)
install(FILES ${completions}/clevis.bash RENAME clevis
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${completions}/clevis.zsh RENAME _clevis
        DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
install(FILES ${completions}/clevis.fish
        DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

# The package needs clevis, not the tests.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME ${package})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "checks whether the link parts of a mechanism hold")
set(CPACK_PACKAGE_CONTACT "clevis developers <clevis@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONFLICTS clevis)
# `check` meshes .geo files by gmsh; ccx and gnuplot are of `study` and `collect`,
# bubblewrap is round the programs that read files of others.
set(CPACK_DEBIAN_PACKAGE_DEPENDS gmsh)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "bubblewrap, calculix-ccx, gnuplot-nox")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "openmpi-bin, paraview")
include(CPack)

add_custom_target(deb
  COMMAND ${CMAKE_CPACK_COMMAND} --config ${CMAKE_BINARY_DIR}/CPackConfig.cmake
          -B ${CMAKE_BINARY_DIR}
  DEPENDS clevis completions COMMENT "Package of Debian" VERBATIM)
