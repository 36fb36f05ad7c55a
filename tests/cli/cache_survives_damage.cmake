# Whatever happens to a cache, a cook gives the right asset. SOURCE: a model whose cook takes a while.
cmake_minimum_required(VERSION 3.24)
include(${CMAKE_CURRENT_LIST_DIR}/cached_cook.cmake)
write_card(card)
must_take(miss "a first cook" card.obj)
must_take(hit "a second cook" card.obj)

file(GLOB_RECURSE entries "${FOLDER}/cache/*")
list(LENGTH entries count)
if(NOT count EQUAL 1)
  message(FATAL_ERROR "one cook left ${count} files in the cache: ${entries}")
endif()
foreach(damage "" "coifent1" "rubbish")
  file(WRITE "${entries}" "${damage}")
  must_take(miss "a damaged entry" card.obj)
  must_take(hit "an entry that was replaced" card.obj)
endforeach()

# A cache that cannot be written costs a warning.
file(WRITE "${FOLDER}/no_folder" "")
cook(card.obj --recipe quick.json --cache no_folder -o uncached.coif)
if(NOT code EQUAL 0 OR NOT err MATCHES "coif cook: warning: no_folder: cannot create the cache's folder")
  message(FATAL_ERROR "exit code ${code}\n${err}")
endif()
must_be_same(uncached.coif cached.coif)

# Killed at any time, a cook leaves nothing that a later one would believe wrongly.
find_program(TIMEOUT_PROGRAM timeout REQUIRED)
foreach(seconds 0.01 0.03 0.05 0.08 0.12 0.2 0.4 0.8)
  execute_process(COMMAND ${TIMEOUT_PROGRAM} -s KILL ${seconds} "${PROGRAM}" cook "${SOURCE}" --recipe quick.json
                          --cache killed -o killed.coif
                  WORKING_DIRECTORY "${FOLDER}" OUTPUT_QUIET ERROR_QUIET)
endforeach()
cook("${SOURCE}" --recipe quick.json -o plain.coif)
foreach(again 1 2)
  cook("${SOURCE}" --recipe quick.json --cache killed -o cached.coif)
  must_be_same(cached.coif plain.coif)
endforeach()
if(NOT code EQUAL 0 OR NOT out MATCHES "from the cache")
  message(FATAL_ERROR "the cache does not recover: exit code ${code}\n${out}\n${err}")
endif()
