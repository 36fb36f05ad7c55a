# Part of consume.cmake: shared libraries. A game with the sources in its own build makes and installs them; others find
# them installed, and those that were moved find each other.
set(parts sim,skinning,c,shared)
set(programs ${sim_games} only_skin)
if(GL)
  string(APPEND parts ,gl)
  list(APPEND programs make_renderer only_draw)
endif()
if(ASSET)
  list(APPEND programs step_in_c_c step_in_c_shared)
endif()

# finds(PROGRAM FOLDER): the program takes coif's libraries, at least one, from that folder and from nowhere else.
function(finds program folder)
  execute_process(COMMAND ldd ${program} OUTPUT_VARIABLE log ERROR_VARIABLE log)
  string(REGEX MATCHALL "libcoif[^\n]*" libraries "${log}")
  foreach(library IN LISTS libraries)
    string(FIND "${library}" " => ${folder}/libcoif" place)
    if(place EQUAL -1)
      message(FATAL_ERROR "${program} does not find this in ${folder}: ${library}")
    endif()
  endforeach()
  if(NOT libraries)
    message(FATAL_ERROR "${program} takes no shared library of coif:\n${log}")
  endif()
endfunction()

# How fast they are is not asked here.
build_game(embedded "${programs}" -D COIF_SOURCE=${SHARE} -D PARTS=${parts} -D CMAKE_BUILD_TYPE=Debug
  -D BUILD_SHARED_LIBS=ON -D COIF_INSTALL=ON -D COIF_GL=${GL} -D COIF_SIMD=${SIMD})
run(${CMAKE_COMMAND} --install ${WORK}/embedded --prefix ${prefix})

# The libraries know of Highway; a game need not.
build_game(game "${programs}" -D PARTS=${parts} ${without_highway})
file(GLOB_RECURSE found ${prefix}/*/libcoif_sim.so)
cmake_path(GET found PARENT_PATH folder)
foreach(program load_and_step only_skin)
  finds(${WORK}/game/${program} ${folder})
endforeach()

include(${consumer}/pkg_config.cmake)
finds(${WORK}/pkg_load_and_step ${libraries})
finds(${WORK}/pkg_only_skin ${libraries})
