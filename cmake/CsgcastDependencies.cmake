# What the libraries link. Shared by the build and by the installed package.
find_package(fmt REQUIRED)
find_package(TBB REQUIRED)
find_package(Eigen3 REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(gmpxx REQUIRED IMPORTED_TARGET gmpxx)
pkg_check_modules(OpenImageIO REQUIRED IMPORTED_TARGET OpenImageIO)
