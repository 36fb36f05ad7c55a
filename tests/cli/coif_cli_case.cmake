# coif_cli_case(NAME EXIT n [STDOUT regex] [STDERR regex] [JSON path...] [TEXT file content]... [WRITES file...]
#               [SAMPLE] [TIMEOUT s] [PROGRAM path] [GROUP name] ARGS ...)
# One run of the program in an empty folder of its own; both the exit code and what it printed must fit.
#   STDOUT, STDERR  regular expressions that must occur there
#   JSON            paths like files,0,valid that must exist in the standard output
#   TEXT            a text file that lies in the folder before the run
#   WRITES          files that must lie there, not empty, afterwards; others must not
#   PROGRAM, GROUP  another program than coif, and the first part of the test's name (default cli)
#   SAMPLE          runs after the sample is cooked; ${COIF_COOKED_SAMPLE} is its path

set(COIF_CLI_FOLDER "${CMAKE_CURRENT_LIST_DIR}")

function(coif_cli_case name)
  cmake_parse_arguments(PARSE_ARGV 1 CASE "SAMPLE" "EXIT;STDOUT;STDERR;TIMEOUT;PROGRAM;GROUP" "JSON;TEXT;WRITES;ARGS")
  if(CASE_UNPARSED_ARGUMENTS OR NOT DEFINED CASE_EXIT)
    message(FATAL_ERROR "coif_cli_case(${name}): needs EXIT; unknown: ${CASE_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT CASE_TIMEOUT)
    set(CASE_TIMEOUT 60)
  endif()
  if(NOT CASE_PROGRAM)
    set(CASE_PROGRAM $<TARGET_FILE:coif_cli>)
  endif()
  if(NOT CASE_GROUP)
    set(CASE_GROUP cli)
  endif()
  add_test(NAME ${CASE_GROUP}.${name}
    COMMAND ${CMAKE_COMMAND} -DPROGRAM=${CASE_PROGRAM} -DFOLDER=${CMAKE_CURRENT_BINARY_DIR}/${name}
            -DEXIT=${CASE_EXIT} "-DSTDOUT=${CASE_STDOUT}" "-DSTDERR=${CASE_STDERR}" "-DJSON=${CASE_JSON}"
            "-DTEXT=${CASE_TEXT}" "-DWRITES=${CASE_WRITES}" "-DARGS=${CASE_ARGS}"
            -P ${COIF_CLI_FOLDER}/run_case.cmake)
  set_tests_properties(${CASE_GROUP}.${name} PROPERTIES TIMEOUT ${CASE_TIMEOUT})
  if(CASE_SAMPLE)
    set_tests_properties(${CASE_GROUP}.${name} PROPERTIES FIXTURES_REQUIRED COIF_COOKED_SAMPLE)
  endif()
endfunction()

# coif_cli_script(NAME [IN file] [SAMPLE] [TIMEOUT s] [LABEL name] [DEFINE NAME=value...]): a test of more than one run, in
# NAME.cmake, or the part of that name in FILE.cmake.
# A script that finds nothing to do prints a line with "skipped:" and is reported as skipped.
function(coif_cli_script name)
  cmake_parse_arguments(PARSE_ARGV 1 CASE "SAMPLE" "IN;TIMEOUT;LABEL" "DEFINE")
  if(NOT CASE_IN)
    set(CASE_IN ${name})
  endif()
  if(NOT CASE_TIMEOUT)
    set(CASE_TIMEOUT 120)
  endif()
  list(TRANSFORM CASE_DEFINE PREPEND -D)
  add_test(NAME cli.${name}
    COMMAND ${CMAKE_COMMAND} -DCASE=${name} -DPROGRAM=$<TARGET_FILE:coif_cli> -DFOLDER=${CMAKE_CURRENT_BINARY_DIR}/${name}
            ${CASE_DEFINE} -P ${COIF_CLI_FOLDER}/${CASE_IN}.cmake)
  set_tests_properties(cli.${name} PROPERTIES TIMEOUT ${CASE_TIMEOUT} SKIP_REGULAR_EXPRESSION "skipped:" LABELS "${CASE_LABEL}")
  if(CASE_SAMPLE)
    set_tests_properties(cli.${name} PROPERTIES FIXTURES_REQUIRED COIF_COOKED_SAMPLE)
  endif()
endfunction()
