# SPDX-License-Identifier: MIT
# One INTERFACE target holds what every target of the project is compiled with, another the warnings.
add_library(csgcast_options INTERFACE)
target_compile_features(csgcast_options INTERFACE cxx_std_20)
# Floating point is part of the contract: no contraction, no -ffast-math, and no -march=native, so that all machines agree.
target_compile_options(csgcast_options INTERFACE -ffp-contract=off -fno-fast-math)
add_library(csgcast_warnings INTERFACE)
target_compile_options(csgcast_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                                                  -Wnon-virtual-dtor -Woverloaded-virtual -Wimplicit-fallthrough)
if(CSGCAST_SANITIZE)
  target_compile_options(csgcast_options INTERFACE -fsanitize=${CSGCAST_SANITIZE} -fno-omit-frame-pointer
                                                   -fno-sanitize-recover=all)
  # Sanitizers load modules in the program's stead, which only the older kind of run path serves.
  target_link_options(csgcast_options INTERFACE -fsanitize=${CSGCAST_SANITIZE} LINKER:--disable-new-dtags)
endif()
# Of Highway only the headers are needed, and its library takes milliseconds to start.
if(CMAKE_SYSTEM_NAME STREQUAL Linux)
  target_link_options(csgcast_options INTERFACE LINKER:--as-needed)
endif()
# Where programs look for the modules that they load: in the build tree, in a Python package, and where they are installed.
set(module_folder ${CMAKE_INSTALL_FULL_LIBDIR}/csgcast)
set(CMAKE_BUILD_RPATH ${PROJECT_BINARY_DIR}/modules $ORIGIN $ORIGIN/..)
set(CMAKE_INSTALL_RPATH $ORIGIN/../${CMAKE_INSTALL_LIBDIR}/csgcast)
if(BUILD_SHARED_LIBS)
  list(APPEND CMAKE_INSTALL_RPATH $ORIGIN/../${CMAKE_INSTALL_LIBDIR} $ORIGIN $ORIGIN/csgcast)
endif()

# csgcast_library(NAME PUBLIC_HEADERS HEADER.. [BASE_FOLDER FOLDER] [EXCLUDE FOLDER]): csgcast_NAME from the sources of the
# present folder, but for those below EXCLUDE,
# alias csgcast::NAME. The headers that it lists are the ones that are installed; the paths of their includes start at
# BASE_FOLDER, by default the project's.
function(csgcast_library name)
  cmake_parse_arguments(arg "" "BASE_FOLDER;EXCLUDE" "PUBLIC_HEADERS" ${ARGN})
  if(NOT arg_BASE_FOLDER)
    set(arg_BASE_FOLDER ${PROJECT_SOURCE_DIR})
  endif()
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  if(arg_EXCLUDE)
    list(FILTER sources EXCLUDE REGEX ${CMAKE_CURRENT_SOURCE_DIR}/${arg_EXCLUDE})
  endif()
  add_library(csgcast_${name} ${sources})
  add_library(csgcast::${name} ALIAS csgcast_${name})
  set_target_properties(csgcast_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON
                                                   VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  target_sources(csgcast_${name} PUBLIC FILE_SET HEADERS BASE_DIRS ${arg_BASE_FOLDER} FILES ${arg_PUBLIC_HEADERS})
  target_include_directories(csgcast_${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_features(csgcast_${name} PUBLIC cxx_std_20)
  target_link_libraries(csgcast_${name} PRIVATE $<BUILD_INTERFACE:csgcast_options> $<BUILD_INTERFACE:csgcast_warnings>)
endfunction()
