# What the tests of the package stand on, in the folder WORK: the package that WEB, a build tree of the preset web, has made; the tests
# beside the libraries that they load, so that node finds them; the assets that they play.
# NPM, SOURCE (this folder), COIF (the program), STEP_MOTIONS, SAMPLES (the project's own sources).
cmake_minimum_required(VERSION 3.24)
if(NOT EXISTS ${WEB}/CMakeCache.txt)
  message(FATAL_ERROR "there is no ${WEB}; 'tests/run.sh web' makes it")
endif()

# must(WHAT COMMAND...)
function(must what)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK} RESULT_VARIABLE code OUTPUT_VARIABLE log ERROR_VARIABLE log)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${what}: ${code}\n${log}")
  endif()
endfunction()

file(MAKE_DIRECTORY ${WORK}/assets)
must("${WEB} does not build" ${CMAKE_COMMAND} --build ${WEB} --target coif_web)
file(GLOB files ${SOURCE}/*.mjs ${SOURCE}/package.json ${SOURCE}/package-lock.json)
file(COPY ${files} DESTINATION ${WORK})
must("npm ci" ${NPM} ci --no-audit --no-fund --prefer-offline)
file(CREATE_LINK ${WEB}/npm ${WORK}/node_modules/coif SYMBOLIC)
must("poses of heads" ${STEP_MOTIONS} poses ${WORK}/poses.bin)
foreach(source IN LISTS SAMPLES)
  cmake_path(GET source STEM name)
  must("${source}" ${COIF} cook ${source} --draft -o ${WORK}/assets/${name}.coif)
endforeach()
