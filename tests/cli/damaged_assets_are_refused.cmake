# Files cut at several lengths, and one with a changed byte. ASSET: a good one.
cmake_minimum_required(VERSION 3.24)
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")

function(must_refuse name message)
  foreach(command "validate;${name}" "info;${name}" "simulate;${name};--motion;nod;-o;out.csv" "render;${name};-o;out.png")
    execute_process(COMMAND "${PROGRAM}" ${command} WORKING_DIRECTORY "${FOLDER}"
                    RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
    if(NOT code EQUAL 3 OR NOT err MATCHES "error: ${name}: ${message}")
      message(FATAL_ERROR "${command}: exit code ${code}, wanted 3 and '${name}: ${message}'\n${err}")
    endif()
  endforeach()
endfunction()

foreach(cut "0:too short" "31:too short" "32:size differs" "1000:size differs")
  string(REPLACE ":" ";" cut "${cut}")
  list(GET cut 0 bytes)
  list(GET cut 1 message)
  execute_process(COMMAND head -c ${bytes} "${ASSET}" OUTPUT_FILE "${FOLDER}/cut_${bytes}.coif" COMMAND_ERROR_IS_FATAL ANY)
  must_refuse(cut_${bytes}.coif "${message}")
endforeach()

file(SIZE "${ASSET}" size)
math(EXPR last "${size} - 1")
execute_process(COMMAND head -c ${last} "${ASSET}" OUTPUT_FILE "${FOLDER}/head" COMMAND_ERROR_IS_FATAL ANY)
file(WRITE "${FOLDER}/byte" "?")
execute_process(COMMAND cat head byte WORKING_DIRECTORY "${FOLDER}" OUTPUT_FILE "${FOLDER}/changed.coif"
                COMMAND_ERROR_IS_FATAL ANY)
must_refuse(changed.coif "chunk TEXD: the bytes were changed after cooking")
