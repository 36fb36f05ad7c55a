# Installs a build tree into an empty place and builds the consumer against it.
#   cmake -D BUILD=... -D WORK=... [-D ASSET=...] -P consume.cmake
# -D SOURCE=... instead of BUILD: configure and build that source tree here first, without OpenGL, tools and tests.
# -D EMBED=... instead of BUILD: install nothing; the consumer adds that source tree to its own build.
set(consumer ${CMAKE_CURRENT_LIST_DIR})
set(prefix ${WORK}/installed)
file(REMOVE_RECURSE ${WORK})

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE log ERROR_VARIABLE log)
  if(NOT code EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}: exit code ${code}\n${log}")
  endif()
endfunction()

function(build_consumer folder)
  run(${CMAKE_COMMAND} -G Ninja -S ${consumer} -B ${WORK}/${folder} -D CMAKE_BUILD_TYPE=Release ${ARGN})
  run(${CMAKE_COMMAND} --build ${WORK}/${folder})
  run(${WORK}/${folder}/load_and_step ${ASSET})
endfunction()

if(EMBED)
  build_consumer(embedded -D COIF_SOURCE=${EMBED})
  return()
endif()

if(BUILD)
  run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})
  # A header that no file set lists would compile here and be absent from the package.
  set(project ${consumer}/../..)
  file(GLOB public RELATIVE ${project} ${project}/formats/include/coif/*.h ${project}/runtime/include/coif/*.h)
  foreach(header IN LISTS public)
    cmake_path(GET header FILENAME name)
    if(NOT EXISTS ${prefix}/include/coif/${name})
      message(FATAL_ERROR "${header} is public and was not installed; add it to its target's file set")
    endif()
  endforeach()
  build_consumer(game -D CMAKE_PREFIX_PATH=${prefix} -D DRAW=ON)
  run(${WORK}/game/make_renderer)
  return()
endif()

run(${CMAKE_COMMAND} -G Ninja -S ${SOURCE} -B ${WORK}/build -D CMAKE_BUILD_TYPE=Release
    -D COIF_GL=OFF -D COIF_TOOLS=OFF -D COIF_TESTS=OFF)
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${CMAKE_COMMAND} --install ${WORK}/build --prefix ${prefix})
build_consumer(game -D CMAKE_PREFIX_PATH=${prefix} -D README=${SOURCE}/README.md)

# The part that was not built is missed when the game is configured, by name, and has left nothing behind.
execute_process(COMMAND ${CMAKE_COMMAND} -G Ninja -S ${consumer} -B ${WORK}/absent -D CMAKE_PREFIX_PATH=${prefix}
                        -D DRAW=ON RESULT_VARIABLE code OUTPUT_QUIET ERROR_VARIABLE log)
if(code EQUAL 0 OR NOT log MATCHES "built[ \n]+without[ \n]+'gl'")
  message(FATAL_ERROR "asking for 'gl' was not refused by name:\n${log}")
endif()
file(GLOB_RECURSE left ${prefix}/*coif_gl* ${prefix}/*renderer.h)
if(left)
  message(FATAL_ERROR "installed although not built: ${left}")
endif()
