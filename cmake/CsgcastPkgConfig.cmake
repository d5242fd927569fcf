# SPDX-License-Identifier: MIT
# A file csgcast-NAME.pc for each library, so that `pkg-config --cflags --libs csgcast-capi` is all that a program needs.
# Paths are relative to the file: the install may be moved.
if(IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}" OR IS_ABSOLUTE "${CMAKE_INSTALL_INCLUDEDIR}")
  set(pc_prefix "${CMAKE_INSTALL_PREFIX}")
else()
  file(RELATIVE_PATH up "/prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/prefix")
  string(REGEX REPLACE "/$" "" up "${up}")
  set(pc_prefix "\${pcfiledir}/${up}")
endif()
foreach(kind LIBDIR INCLUDEDIR)
  if(IS_ABSOLUTE "${CMAKE_INSTALL_${kind}}")
    set(pc_${kind} "${CMAKE_INSTALL_${kind}}")
  else()
    set(pc_${kind} "\${prefix}/${CMAKE_INSTALL_${kind}}")
  endif()
endforeach()
# What C++ itself links: a C program has to say so beside a static library.
set(runtime ${CMAKE_CXX_IMPLICIT_LINK_LIBRARIES})
list(FILTER runtime INCLUDE REGEX "^(stdc\\+\\+|c\\+\\+|m)$")
list(REMOVE_DUPLICATES runtime)
list(TRANSFORM runtime PREPEND "-l")
list(JOIN runtime " " runtime)

# csgcast_pkg_config(NAME DESCRIPTION BELOW LIBRARY.. LINKS MODULE..): the libraries of the project that it builds on, and
# the pkg-config modules of others that it links.
function(csgcast_pkg_config name description)
  cmake_parse_arguments(arg "" "" "BELOW;LINKS" ${ARGN})
  list(TRANSFORM arg_BELOW PREPEND "csgcast-")
  if(BUILD_SHARED_LIBS)
    set(public ${arg_BELOW})
    set(private ${arg_LINKS})
  else()  # a static library does not say what it links
    set(public ${arg_BELOW} ${arg_LINKS})
    set(libraries " ${runtime}")
  endif()
  list(JOIN public ", " public)
  list(JOIN private ", " private)
  file(CONFIGURE OUTPUT csgcast-${name}.pc @ONLY CONTENT [[
prefix=@pc_prefix@
libdir=@pc_LIBDIR@
includedir=@pc_INCLUDEDIR@/csgcast

Name: csgcast-@name@
Description: @description@
Version: @PROJECT_VERSION@
Requires: @public@
Requires.private: @private@
Cflags: -I${includedir}
Libs: -L${libdir} -lcsgcast_@name@@libraries@
]])
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/csgcast-${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()

csgcast_pkg_config(csg "exact solids, and the scene text" LINKS gmpxx fmt)
csgcast_pkg_config(raycast "what rays see of a solid, certified" BELOW csg LINKS fmt tbb)
csgcast_pkg_config(query "many rays and points at once" BELOW raycast LINKS fmt tbb)
csgcast_pkg_config(measure "volume, area, sections and thickness, with bounds" BELOW raycast LINKS fmt tbb)
csgcast_pkg_config(verify "answers beside exact arithmetic" BELOW raycast LINKS fmt tbb)
csgcast_pkg_config(shade "pictures" BELOW raycast LINKS fmt tbb libpng)
csgcast_pkg_config(model "one class for every question to a solid" BELOW query measure shade LINKS fmt tbb)
csgcast_pkg_config(capi "csgcast for C" BELOW model LINKS fmt)
