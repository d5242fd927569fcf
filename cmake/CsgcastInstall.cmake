# SPDX-License-Identifier: MIT
# The installed package: libraries, public headers, CMake config.
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/csgcast)

set(libraries csg raycast measure query shade model capi verify)
list(TRANSFORM libraries PREPEND csgcast_)
install(TARGETS ${libraries} EXPORT csgcast-targets FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/csgcast)
install(EXPORT csgcast-targets NAMESPACE csgcast:: DESTINATION ${package_dir})

configure_package_config_file(cmake/csgcast-config.cmake.in csgcast-config.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(csgcast-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/csgcast-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/csgcast-config-version.cmake
        DESTINATION ${package_dir})
include(CsgcastPkgConfig)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
