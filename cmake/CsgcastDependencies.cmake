# SPDX-License-Identifier: MIT
# What the libraries link. The installed package looks for the same: csgcast-config.cmake.in.
find_package(fmt REQUIRED)
find_package(TBB REQUIRED)
find_package(Eigen3 REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(gmpxx REQUIRED IMPORTED_TARGET gmpxx)
pkg_check_modules(libhwy REQUIRED IMPORTED_TARGET libhwy)
# The kinds of picture; each library is seen by one file of shade/detail/.
pkg_check_modules(csgcast_pictures REQUIRED IMPORTED_TARGET libpng libjpeg libtiff-4>=4.5 OpenEXR>=3)
