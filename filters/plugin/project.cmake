# SPDX-License-Identifier: BSD-3-Clause
# The project that builds ParaView's plugin BirdStrike alone.
include(GNUInstallDirs)
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(BUILD_SHARED_LIBS ON) # a static plugin cannot be loaded
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CCACHE_PROGRAM}")
endif()

find_package(ParaView 5.11 REQUIRED) # without COMPONENTS: naming some breaks its target files
paraview_plugin_scan(PLUGIN_FILES "${CMAKE_CURRENT_SOURCE_DIR}/plugin/paraview.plugin"
  PROVIDES_PLUGINS plugins REQUIRES_MODULES required ENABLE_BY_DEFAULT ON HIDE_PLUGINS_FROM_CACHE ON)
paraview_plugin_build(PLUGINS ${plugins} RUNTIME_DESTINATION "${CMAKE_INSTALL_BINDIR}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}" LIBRARY_SUBDIRECTORY "paraview-plugins")
