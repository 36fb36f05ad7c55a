# One and two threads, the same folder and another one: the same bytes. SOURCE: what is cooked.
cmake_minimum_required(VERSION 3.24)
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}/elsewhere")
get_filename_component(source_folder "${SOURCE}" DIRECTORY)
get_filename_component(source_name "${SOURCE}" NAME)
file(COPY "${source_folder}/" DESTINATION "${FOLDER}/elsewhere")

function(cook source output threads)
  execute_process(COMMAND "${PROGRAM}" cook "${source}" -o "${output}" --threads ${threads}
                  WORKING_DIRECTORY "${FOLDER}" RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "cook ${source} --threads ${threads}: exit code ${code}\n${err}")
  endif()
endfunction()

cook("${SOURCE}" one.coif 1)
cook("${SOURCE}" two.coif 2)
cook("elsewhere/${source_name}" elsewhere.coif 2)
foreach(other two elsewhere)
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files "${FOLDER}/one.coif" "${FOLDER}/${other}.coif"
                  RESULT_VARIABLE differs)
  if(differs)
    message(FATAL_ERROR "one.coif and ${other}.coif differ")
  endif()
endforeach()
