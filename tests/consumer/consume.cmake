# Installs coif into an empty place and builds games against it.
#   cmake -D BUILD=... -D SIMD=dispatch|static -D SHARED=ON|OFF -D WORK=... [-D ASSET=...] -P consume.cmake
# Installs that build tree, which has all parts.
#   cmake -D SOURCE=... ... instead of BUILD: build that source tree first, with as little as can be: no OpenGL, no tools.
#   cmake -D EMBED=... ... instead of BUILD: install nothing; the game adds that source tree to its own build.
#   cmake -D SHARE=... -D GL=ON|OFF ... instead of BUILD: shared libraries, as part of a game's build and installed.
set(consumer ${CMAKE_CURRENT_LIST_DIR})
set(prefix ${WORK}/installed)
file(REMOVE_RECURSE ${WORK})

include(${consumer}/run.cmake)

set(configure_game ${CMAKE_COMMAND} -G Ninja -S ${consumer} -D CMAKE_BUILD_TYPE=Release -D CMAKE_PREFIX_PATH=${prefix})
set(without_highway -D CMAKE_DISABLE_FIND_PACKAGE_hwy=ON)

set(sim_games only_open only_lod load_and_step step_by_thesis)

# build_game(FOLDER PROGRAMS ARGUMENTS...): configures with the arguments, builds, runs these programs.
function(build_game folder programs)
  run(${configure_game} -B ${WORK}/${folder} ${ARGN})
  run(${CMAKE_COMMAND} --build ${WORK}/${folder})
  foreach(program IN LISTS programs)
    run(${WORK}/${folder}/${program} ${ASSET})
  endforeach()
endfunction()

if(EMBED)
  build_game(embedded "${sim_games}" -D COIF_SOURCE=${EMBED})
elseif(SHARE)
  include(${consumer}/shared_package.cmake)
elseif(BUILD)
  include(${consumer}/whole_package.cmake)
else()
  include(${consumer}/smallest_package.cmake)
endif()
