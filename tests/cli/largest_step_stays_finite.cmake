# The sample at the longest step the runtime takes, 0.1 s, through every motion: all numbers finite, and no hair farther
# from the head than a stretched chain could be. ASSET: a cooked asset.
cmake_minimum_required(VERSION 3.24)
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")

foreach(motion still nod turn charge run jump tumble teleport)
  execute_process(COMMAND "${PROGRAM}" simulate "${ASSET}" --motion ${motion} --fps 10 --seconds 20 -o ${motion}.csv
                  WORKING_DIRECTORY "${FOLDER}" RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "simulate --motion ${motion} --fps 10: exit code ${code}\n${err}")
  endif()
  file(READ "${FOLDER}/${motion}.csv" csv)
  string(REGEX MATCHALL "\n[0-9]+," rows "${csv}")
  list(LENGTH rows count)
  if(count LESS 2000)
    message(SEND_ERROR "${motion}: ${count} rows, so nothing was checked")
  endif()
  if(csv MATCHES "[^a-z](nan|-nan|inf|-inf)")
    message(SEND_ERROR "${motion}: a position is not finite")
  endif()
  # Head-space coordinates are columns 5 to 7; two digits before the point would be 10 m, the length of the teleport.
  if(csv MATCHES "\n[0-9]+,[0-9.]+,[0-9]+,[A-Za-z0-9_]*,(-?[0-9.]+,)?(-?[0-9.]+,)?-?[0-9][0-9]+\\.[0-9]+,")
    message(SEND_ERROR "${motion}: hair is 10 m or more from its head: ${CMAKE_MATCH_0}")
  endif()
endforeach()
