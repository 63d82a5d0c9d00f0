# Manual pages by help2man from what --help prints, and a package has them too.
# Without help2man there are none, and clevis is the same.
find_program(CLEVIS_HELP2MAN help2man)
find_program(CLEVIS_PYTHON python3 HINTS /usr/bin)
if(CLEVIS_HELP2MAN AND CLEVIS_PYTHON)
  set(folder ${CMAKE_BINARY_DIR}/man)
  add_custom_command(
    OUTPUT ${folder}/clevis.1
    COMMAND ${CLEVIS_PYTHON} ${PROJECT_SOURCE_DIR}/cmake/make_man_pages.py
            ${CLEVIS_HELP2MAN} $<TARGET_FILE:clevis> ${folder}
    DEPENDS clevis ${PROJECT_SOURCE_DIR}/cmake/make_man_pages.py
    COMMENT "Manual pages")
  add_custom_target(man_pages ALL DEPENDS ${folder}/clevis.1)
  add_dependencies(deb man_pages)
  install(DIRECTORY ${folder}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1
          FILES_MATCHING PATTERN "*.1")
endif()
