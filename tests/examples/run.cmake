# SPDX-License-Identifier: MIT
# Runs `program` with `arguments`; fails unless its output is the text of the file `expected`. list_parts and all_questions get a scene of the folder
# `scenes`.
if(program MATCHES "/list_parts$")
  set(arguments ${scenes}/flange.csg)
elseif(program MATCHES "/all_questions$")
  set(arguments ${scenes}/rook.csg)
endif()
execute_process(COMMAND ${program} ${arguments} OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
file(READ ${expected} text)
if(NOT printed STREQUAL text)
  message(FATAL_ERROR "printed:\n${printed}\nexpected:\n${text}")
endif()
