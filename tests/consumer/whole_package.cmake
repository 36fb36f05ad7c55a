# Part of consume.cmake: everything, as one build tree installs it.
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})

# A header that no file set lists would compile in the project and be absent from the package.
set(project ${consumer}/../..)
file(GLOB public RELATIVE ${project} ${project}/formats/include/coif/*.h ${project}/runtime/include/coif/*.h)
foreach(header IN LISTS public)
  cmake_path(GET header FILENAME name)
  if(NOT EXISTS ${prefix}/include/coif/${name})
    message(FATAL_ERROR "${header} is public and was not installed; add it to its target's file set")
  endif()
endforeach()

set(c_games "")
if(ASSET)
  set(c_games step_in_c_c step_in_c_shared)
endif()
build_game(game "${sim_games};${c_games};only_skin;make_renderer;only_draw;draw_exactly;draw_hashed;cast_plainly" -D PARTS=formats,sim,skinning,gl,c,shared
  -D README=${project}/README.md)
include(${consumer}/pkg_config.cmake)
# Only who simulates needs Highway, and is told when it is not there.
build_game(reader "only_open;only_skin" -D PARTS=formats,skinning ${without_highway})
if(SIMD STREQUAL "dispatch" AND NOT SHARED)
  must_fail(MATCHES "(module|dependency) hwy" ${configure_game} -B ${WORK}/lacking ${without_highway})
endif()
