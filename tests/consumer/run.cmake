# Commands of these tests, and what they say where they fail.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE log ERROR_VARIABLE log)
  if(NOT code EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}: exit code ${code}\n${log}")
  endif()
endfunction()

# must_fail(MATCHES regex COMMAND...): the command fails, and says why.
function(must_fail MATCHES regex)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE log ERROR_VARIABLE log)
  string(REGEX REPLACE "[ \n]+" " " log "${log}")
  if(code EQUAL 0 OR NOT log MATCHES "${regex}")
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}: exit code ${code}, without '${regex}':\n${log}")
  endif()
endfunction()
