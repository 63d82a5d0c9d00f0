# Installation, and a package of Debian by `cpack --config build/release/CPackConfig.cmake`.
# Debian has another program called clevis (unlocking of disks): both cannot be
# installed at once, so the package is called clevis-links.
include(GNUInstallDirs)
install(FILES README.md CHANGELOG.md LICENSE.md TYPE DOC)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR}
        FILES_MATCHING PATTERN "*.md" PATTERN "*.json" PATTERN "*.svg"
        PATTERN "*.txt")
foreach(name compare error faces impact modes plan result scene simulate study
        transmission view_motion view_part)
  install(FILES docs/${name}.schema.json
          DESTINATION ${CMAKE_INSTALL_DATADIR}/clevis)
endforeach()
install(DIRECTORY geometry DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples
        FILES_MATCHING PATTERN "*.toml" PATTERN "*.geo" PATTERN "*.msh" PATTERN "*.step"
        PATTERN "*.csv")
install(DIRECTORY meshes DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples
        FILES_MATCHING PATTERN "*.msh")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME clevis-links)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "checks whether the link parts of a mechanism hold")
set(CPACK_PACKAGE_CONTACT "clevis developers <clevis@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONFLICTS clevis)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "gmsh, calculix-ccx")
include(CPack)
