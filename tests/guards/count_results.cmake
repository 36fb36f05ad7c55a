# Drives tests/count_results.sh with a real ctest run: one test passes, one fails, one cannot be started, one skips
# itself, one is disabled. Called with -D SCRIPT=... -D WORK=...
file(REMOVE_RECURSE ${WORK})  # whatever generator an earlier run used
file(WRITE ${WORK}/CMakeLists.txt [[
cmake_minimum_required(VERSION 3.24)
project(five_tests NONE)
enable_testing()
add_test(NAME passes COMMAND ${CMAKE_COMMAND} -E true)
add_test(NAME fails COMMAND ${CMAKE_COMMAND} -E false)
add_test(NAME not_built COMMAND no_such_program)
add_test(NAME skips COMMAND ${CMAKE_COMMAND} -E echo SKIPPED)
set_tests_properties(skips PROPERTIES SKIP_REGULAR_EXPRESSION SKIPPED)
add_test(NAME disabled COMMAND ${CMAKE_COMMAND} -E true)
set_tests_properties(disabled PROPERTIES DISABLED ON)
]])
execute_process(COMMAND ${CMAKE_COMMAND} -G Ninja -S ${WORK} -B ${WORK}/build
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_CTEST_COMMAND} --test-dir ${WORK}/build --output-junit ${WORK}/results.xml
                OUTPUT_QUIET ERROR_QUIET)

function(expect wanted)
  execute_process(COMMAND sh ${SCRIPT} ${ARGN} OUTPUT_VARIABLE counts ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT counts STREQUAL wanted)
    message(SEND_ERROR "count_results.sh ${ARGN} printed '${counts}', not '${wanted}'")
  endif()
endfunction()
expect("1 2 2" ${WORK}/results.xml)
expect("2 4 4" ${WORK}/results.xml ${WORK}/results.xml)
expect("1 3 2" ${WORK}/absent.xml ${WORK}/results.xml)
