# A page of issues shows the patches that have some, where there is something to draw with, and says why where not.
cmake_minimum_required(VERSION 3.24)
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")

function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY "${FOLDER}"
                  RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGN}: exit code ${code}\n${out}${err}")
  endif()
endfunction()

function(must_match file text)
  file(READ "${FOLDER}/${file}" page)
  if(NOT page MATCHES "${text}")
    message(SEND_ERROR "${file} lacks: ${text}")
  endif()
endfunction()

# One card, three heads wide.
file(WRITE "${FOLDER}/card.obj" "o hair\nv -0.3 0 0.1\nv 0.3 0 0.1\nv 0.3 -0.3 0.1\nv -0.3 -0.3 0.1\n"
                                "vt 0 1\nvt 1 1\nvt 1 0\nvt 0 0\nf 1/1 4/4 3/3\nf 1/1 3/3 2/2\n")
file(WRITE "${FOLDER}/card.recipe.json" "{\"source\": {\"metres_per_unit\": 1}, \"patches\": {\"widest\": 10},
  \"head\": {\"center\": [0, 0, 0], \"radii\": [0.1, 0.1, 0.1]}, \"strands\": {\"root\": \"low_v\"}}")
run("${PROGRAM}" cook card.obj -o card.coif)

run("${PROGRAM}" validate card.coif --report page.html)
must_match(page.html "1 of 1 files are valid.*A242.*m wide across its strands.*patch 0.*patches.widest")
must_match(page.html "Patch 0, in red.*\"png\":\"iVBOR|\"why_no_pictures\":\"no ")

run(${CMAKE_COMMAND} -E env __EGL_VENDOR_LIBRARY_FILENAMES=/none
    "${PROGRAM}" validate card.coif card.obj --report blind.html)
must_match(blind.html "A242.*\"why_no_pictures\":\"no EGL display")
run("${PROGRAM}" validate card.coif --ignore A242 --report calm.html)
file(READ "${FOLDER}/calm.html" page)
if(page MATCHES "A242|iVBOR")
  message(SEND_ERROR "calm.html shows what is ignored")
endif()
