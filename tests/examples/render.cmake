# SPDX-License-Identifier: MIT
# Renders `scene` with the program `csgcast` into `picture`, small; fails if the program says anything at all.
file(REMOVE ${picture})
execute_process(COMMAND ${csgcast} render ${scene} -o ${picture} --size 48x36 OUTPUT_VARIABLE said ERROR_VARIABLE said
                RESULT_VARIABLE status)
if(NOT status EQUAL 0 OR NOT said STREQUAL "" OR NOT EXISTS ${picture})
  message(FATAL_ERROR "status ${status}: ${said}")
endif()
