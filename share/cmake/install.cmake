# SPDX-License-Identifier: GPL-3.0-or-later
# What `cmake --install` puts where other projects look for it: the program, the libraries with their headers and a
# find_package(BirdStrike) config, and the catalogue with the meshes.
#
# Exported are BirdStrike::core and BirdStrike::geometry, which need Eigen and OpenMP only. The static libraries
# around VTK stay inside the program.
include(CMakePackageConfigHelpers)

set(config_folder "${CMAKE_INSTALL_LIBDIR}/cmake/BirdStrike")
set(share_folder "${CMAKE_INSTALL_DATADIR}/birdstrike")

set_target_properties(birdstrike_options PROPERTIES EXPORT_NAME options)
set_target_properties(birdstrike_core PROPERTIES EXPORT_NAME core)
set_target_properties(birdstrike_geometry PROPERTIES EXPORT_NAME geometry)
set_target_properties(birdstrike_core birdstrike_geometry PROPERTIES INSTALL_RPATH "$ORIGIN")

install(TARGETS birdstrike RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
install(TARGETS birdstrike_options birdstrike_core birdstrike_geometry EXPORT BirdStrikeTargets
  LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
install(DIRECTORY core geometry DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/birdstrike" FILES_MATCHING PATTERN "*.h")

install(EXPORT BirdStrikeTargets NAMESPACE BirdStrike:: DESTINATION "${config_folder}")
configure_package_config_file(share/cmake/BirdStrikeConfig.cmake.in
  "${PROJECT_BINARY_DIR}/BirdStrikeConfig.cmake" INSTALL_DESTINATION "${config_folder}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/BirdStrikeConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/BirdStrikeConfig.cmake" "${PROJECT_BINARY_DIR}/BirdStrikeConfigVersion.cmake"
  DESTINATION "${config_folder}")

install(DIRECTORY cases/ DESTINATION "${share_folder}/cases" FILES_MATCHING PATTERN "*.toml")
install(DIRECTORY share/meshes share/materials share/reference share/rules DESTINATION "${share_folder}")
install(FILES LICENSE README.md DESTINATION "${CMAKE_INSTALL_DOCDIR}")
