# SPDX-License-Identifier: MIT
# Installs the build tree `build` below `work`, moves the install, and builds and runs project/ against it.
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${work})
run(${CMAKE_COMMAND} --install ${build} --prefix ${work}/first-place)
file(RENAME ${work}/first-place ${work}/prefix)

file(GLOB_RECURSE private_headers ${work}/prefix/include/*/detail/*)
if(private_headers)
  message(FATAL_ERROR "private headers were installed: ${private_headers}")
endif()
run(${work}/prefix/bin/csgcast --help)

run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/project -B ${work}/build -G ${generator}
    -D CMAKE_CXX_COMPILER=${compiler} -D CMAKE_PREFIX_PATH=${work}/prefix -D CMAKE_BUILD_TYPE=Release)
run(${CMAKE_COMMAND} --build ${work}/build)
run(${work}/build/consumer)
run(${work}/build/views)

# The example of a project, in C++ and in C.
run(${CMAKE_COMMAND} -S ${examples}/consumer -B ${work}/plate -G ${generator}
    -D CMAKE_CXX_COMPILER=${compiler} -D CMAKE_PREFIX_PATH=${work}/prefix -D CMAKE_BUILD_TYPE=Release)
run(${CMAKE_COMMAND} --build ${work}/plate)
file(READ ${expected} right)
foreach(program plate plate_in_c)
  execute_process(COMMAND ${work}/plate/${program} OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
  if(NOT printed STREQUAL right)
    message(FATAL_ERROR "${program} printed\n${printed}instead of\n${right}")
  endif()
endforeach()
