# expect_of(CODE SHOWN HIDDEN ARGUMENTS...): runs PROGRAM in FOLDER, which must end with CODE, and say what SHOWN matches and nothing
# that HIDDEN does; "" is not looked for. Its standard output is in `out` afterwards.
function(expect_of code shown hidden)
  execute_process(COMMAND "${PROGRAM}" ${ARGN} WORKING_DIRECTORY "${FOLDER}"
                  RESULT_VARIABLE result OUTPUT_VARIABLE out ERROR_VARIABLE err)
  set(out "${out}" PARENT_SCOPE)
  if(NOT result EQUAL code OR NOT "${out}${err}" MATCHES "${shown}")
    message(SEND_ERROR "${ARGN}: exit code ${result}, wanted ${code} and: ${shown}\n${out}${err}")
  endif()
  if(hidden AND "${out}${err}" MATCHES "${hidden}")
    message(SEND_ERROR "${ARGN}: says what it should not: ${hidden}\n${out}${err}")
  endif()
endfunction()

# expect(CODE PATTERN ARGUMENTS...): expect_of() that hides nothing.
function(expect code pattern)
  expect_of("${code}" "${pattern}" "" ${ARGN})
endfunction()
