# An asset that was stripped of its mesh has no picture: refused with what, where and the cure, and nothing is written.
cmake_minimum_required(VERSION 3.24)
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")

execute_process(COMMAND "${PROGRAM}" strip "${ASSET}" -o bald.coif --without INDX WORKING_DIRECTORY "${FOLDER}"
                RESULT_VARIABLE code OUTPUT_QUIET ERROR_VARIABLE err)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "strip: exit code ${code}\n${err}")
endif()
execute_process(COMMAND "${PROGRAM}" report bald.coif order -o out.html WORKING_DIRECTORY "${FOLDER}"
                RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
if(NOT code EQUAL 3 OR NOT err MATCHES "coif report: error: bald.coif: the asset has no mesh to draw; cook it again without")
  message(FATAL_ERROR "exit code ${code}, wanted 3, what is missing and the cure\n${out}\n${err}")
endif()
if(EXISTS "${FOLDER}/out.html")
  message(FATAL_ERROR "left a page behind")
endif()
