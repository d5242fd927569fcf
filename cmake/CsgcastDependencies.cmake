# SPDX-License-Identifier: MIT
# What the libraries link. The installed package looks for the same: csgcast-config.cmake.in.
find_package(fmt REQUIRED)
find_package(TBB REQUIRED)
find_package(Eigen3 REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(gmpxx REQUIRED IMPORTED_TARGET gmpxx)
pkg_check_modules(libhwy REQUIRED IMPORTED_TARGET libhwy)
# pkg-config first: Debian's OpenImageIOConfig.cmake stops with an error unless packages are there that nobody else needs.
pkg_check_modules(OpenImageIO IMPORTED_TARGET OpenImageIO)
if(NOT TARGET PkgConfig::OpenImageIO)
  find_package(OpenImageIO REQUIRED)
  add_library(PkgConfig::OpenImageIO ALIAS OpenImageIO::OpenImageIO)
endif()
