# Installs plastica::plastica, plastica::calibrate and plastica::sweeps with their headers, and what
# find_package(plastica) reads.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set_target_properties(plastica_calibrate PROPERTIES EXPORT_NAME calibrate)
set_target_properties(plastica_sweeps PROPERTIES EXPORT_NAME sweeps)
install(TARGETS plastica EXPORT plasticaTargets
  FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
# "calibrate" and "sweeps" are too general names to stand in the include directory of a machine.
install(TARGETS plastica_calibrate plastica_sweeps EXPORT plasticaTargets
  FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/plastica)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/plastica)
get_property(packages GLOBAL PROPERTY PLASTICA_DEPENDENCIES)
list(TRANSFORM packages REPLACE "(.+)" "find_dependency(\\1)")
list(JOIN packages "\n" PLASTICA_FIND_DEPENDENCIES)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/plasticaConfig.cmake.in
  ${PROJECT_BINARY_DIR}/plasticaConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/plasticaConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/plasticaConfig.cmake
  ${PROJECT_BINARY_DIR}/plasticaConfigVersion.cmake
  DESTINATION ${package_dir})
install(EXPORT plasticaTargets NAMESPACE plastica:: DESTINATION ${package_dir})
