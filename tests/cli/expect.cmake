# expect(CODE PATTERN ARGUMENTS...): runs PROGRAM in FOLDER, which must end with CODE and say what PATTERN matches.
function(expect code pattern)
  execute_process(COMMAND "${PROGRAM}" ${ARGN} WORKING_DIRECTORY "${FOLDER}"
                  RESULT_VARIABLE result OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT result EQUAL code OR NOT "${out}${err}" MATCHES "${pattern}")
    message(SEND_ERROR "${ARGN}: exit code ${result}, wanted ${code} and: ${pattern}\n${out}${err}")
  endif()
endfunction()
