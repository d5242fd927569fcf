# SPDX-License-Identifier: MIT
# What the libraries link. The installed package looks for the same: csgcast-config.cmake.in.
find_package(fmt REQUIRED)
find_package(TBB REQUIRED)
find_package(Eigen3 REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(gmpxx REQUIRED IMPORTED_TARGET gmpxx)
pkg_check_modules(libhwy REQUIRED IMPORTED_TARGET libhwy)
pkg_check_modules(csgcast_png REQUIRED IMPORTED_TARGET libpng)
# All kinds of pictures but plain .png; without it csgcast writes .png alone. AUTO: if it is there.
set(CSGCAST_OPENIMAGEIO AUTO CACHE STRING "Make the module for pictures with OpenImageIO: AUTO, ON or OFF")
set_property(CACHE CSGCAST_OPENIMAGEIO PROPERTY STRINGS AUTO ON OFF)
# By pkg-config: Debian's CMake files of OpenImageIO want its tools, too.
if(CSGCAST_OPENIMAGEIO STREQUAL ON)
  pkg_check_modules(OpenImageIO REQUIRED IMPORTED_TARGET OpenImageIO libwebp)
elseif(CSGCAST_OPENIMAGEIO STREQUAL AUTO)
  pkg_check_modules(OpenImageIO IMPORTED_TARGET OpenImageIO libwebp)
else()
  set(OpenImageIO_FOUND FALSE)
endif()
if(NOT OpenImageIO_FOUND)
  message(STATUS "OpenImageIO is not used: pictures are .png alone")
endif()
