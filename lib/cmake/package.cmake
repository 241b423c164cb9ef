# `cpack --config build/release/CPackConfig.cmake` makes a package for Debian of what is installed:
# command, library, headers, CMake's files, man pages, completions, documentation.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME plastica)
set(CPACK_PACKAGE_CONTACT "The Plastica developers <plastica@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "calibration and simulation of lumped beams")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"A lumped beam is a chain of rigid segments held by springs, as physics
engines build it. Plastica fits such beams to measured stress-strain curves
and to tests of beams, thousands in parallel, with the uncertainty of each
parameter; it simulates them at rest and in motion (elastic, yielding,
breaking) and says how many segments and which time step are enough.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "gnuplot-nox")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libhdf5-dev, libnlopt-dev, libeigen3-dev, libdeflate-dev")
if(PLASTICA_PYTHON)
  # The extension is of one version of Python.
  set(minor ${PLASTICA_PYTHON_MINOR})
  math(EXPR next "${minor} + 1")
  string(APPEND CPACK_DEBIAN_PACKAGE_RECOMMENDS
    ", python3 (>= 3.${minor}), python3 (<< 3.${next}), python3-numpy")
  string(APPEND CPACK_DEBIAN_PACKAGE_SUGGESTS ", python3-pandas, python3-matplotlib")
endif()

set(doc ${CMAKE_INSTALL_DATAROOTDIR}/doc/plastica)
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CITATION.cff DESTINATION ${doc})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${doc} PATTERN draw EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${doc} RENAME copyright)
install(CODE "
  find_program(gzip gzip)
  if(gzip)
    execute_process(COMMAND \${gzip} -9nc ${PROJECT_SOURCE_DIR}/CHANGELOG.md
      OUTPUT_FILE \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${doc}/changelog.gz\"
      COMMAND_ERROR_IS_FATAL ANY)
  endif()
")
include(CPack)
