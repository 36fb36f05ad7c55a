# A cook tells a terminal what it is doing and leaves nothing of that behind; a pipe hears nothing of it. SOURCE: a model.
cmake_minimum_required(VERSION 3.24)
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")

execute_process(COMMAND "${PROGRAM}" cook "${SOURCE}" -o piped.coif WORKING_DIRECTORY "${FOLDER}"
                RESULT_VARIABLE code OUTPUT_QUIET ERROR_VARIABLE piped)
if(NOT code EQUAL 0 OR piped MATCHES "strands")
  message(FATAL_ERROR "into a pipe: exit code ${code}, and it says:\n${piped}")
endif()

# script(1) gives the program a terminal.
find_program(SCRIPT script)
if(NOT SCRIPT)
  message("skipped: no script(1) here to make a terminal with")
  return()
endif()
execute_process(COMMAND "${SCRIPT}" -q -e -c true probe.log WORKING_DIRECTORY "${FOLDER}" RESULT_VARIABLE code
                OUTPUT_QUIET ERROR_QUIET)
if(NOT code EQUAL 0)
  message("skipped: no pseudo-terminals on this machine")
  return()
endif()
execute_process(COMMAND ${CMAKE_COMMAND} -E env TERM=xterm
                        "${SCRIPT}" -q -e -c "'${PROGRAM}' cook '${SOURCE}' -o seen.coif" seen.log
                WORKING_DIRECTORY "${FOLDER}" RESULT_VARIABLE code OUTPUT_VARIABLE seen)
string(ASCII 27 escape)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "on a terminal: exit code ${code}:\n${seen}")
endif()
foreach(step "import" "strands" "write")
  if(NOT seen MATCHES "bob.glb: ${step} \\([0-9.]+ s\\)")
    message(FATAL_ERROR "a terminal does not hear of '${step}':\n${seen}")
  endif()
endforeach()
# The last progress is erased before the result.
if(NOT seen MATCHES "write \\([0-9.]+ s\\)[^(]*${escape}\\[K[^(]*seen.coif: ")
  message(FATAL_ERROR "progress is left on the terminal:\n${seen}")
endif()
