# SPDX-License-Identifier: MIT
# The installed package: libraries, public headers, CMake config.
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/csgcast)

install(TARGETS csgcast_csg csgcast_raycast csgcast_measure csgcast_query csgcast_capi csgcast_shade csgcast_verify EXPORT csgcast-targets)
install(DIRECTORY csg raycast measure query capi shade verify DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/csgcast
        FILES_MATCHING PATTERN "*.h" PATTERN detail EXCLUDE)
install(EXPORT csgcast-targets NAMESPACE csgcast:: DESTINATION ${package_dir})

configure_package_config_file(cmake/csgcast-config.cmake.in csgcast-config.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(csgcast-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/csgcast-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/csgcast-config-version.cmake
        DESTINATION ${package_dir})
