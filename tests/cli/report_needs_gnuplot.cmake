# Without gnuplot a page with plots is refused before anything is measured, with the cure; the numbers are still there.
cmake_minimum_required(VERSION 3.24)
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")
set(ENV{PATH} "${FOLDER}")

execute_process(COMMAND "${PROGRAM}" report "${ASSET}" accuracy -o out.html WORKING_DIRECTORY "${FOLDER}"
                RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
if(NOT code EQUAL 5 OR NOT err MATCHES "coif report: error: gnuplot: not found.*apt-get install gnuplot-nox")
  message(FATAL_ERROR "exit code ${code}, wanted 5 and the cure\n${out}\n${err}")
endif()
if(EXISTS "${FOLDER}/out.html")
  message(FATAL_ERROR "left a page behind")
endif()

execute_process(COMMAND "${PROGRAM}" report "${ASSET}" accuracy -o out.json --motion nod --fps 60 --seconds 0.2
                        --substeps 1 --solver thesis
                WORKING_DIRECTORY "${FOLDER}" RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
if(NOT code EQUAL 0 OR NOT EXISTS "${FOLDER}/out.json")
  message(FATAL_ERROR "exit code ${code}: JSON must not need gnuplot\n${out}\n${err}")
endif()
