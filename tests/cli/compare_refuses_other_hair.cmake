# Two assets of different hair: exit code 3 and a message that says how far apart they are.
cmake_minimum_required(VERSION 3.24)
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")
file(WRITE "${FOLDER}/card.obj" "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
file(WRITE "${FOLDER}/other.obj" "v 0 0 0.5\nv 1 0 0.5\nv 0 1 0.5\nf 1 2 3\n")

foreach(name card other)
  execute_process(COMMAND "${PROGRAM}" cook ${name}.obj -o ${name}.coif WORKING_DIRECTORY "${FOLDER}"
                  RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "cook ${name}.obj: exit code ${code}\n${err}")
  endif()
endforeach()
execute_process(COMMAND "${PROGRAM}" compare card.coif other.coif WORKING_DIRECTORY "${FOLDER}"
                RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
set(wanted "coif compare: error: card.coif and other.coif: the two surfaces differ at rest by .* mm RMS or more")
if(NOT code EQUAL 3 OR NOT err MATCHES "${wanted}")
  message(FATAL_ERROR "exit code ${code}, wanted 3 and '${wanted}'\n${err}")
endif()
