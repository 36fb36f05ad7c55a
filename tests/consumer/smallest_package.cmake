# Part of consume.cmake: reader and simulation for one instruction set, on a machine without OpenGL's headers.
set(fence ${WORK}/fence)
foreach(header EGL/egl.h GL/gl.h GLES2/gl2.h GLES3/gl3.h GLES3/gl31.h GLES3/gl32.h KHR/khrplatform.h)
  file(WRITE ${fence}/${header} "#error this machine has no OpenGL\n")
endforeach()
set(configure ${CMAKE_COMMAND} -G Ninja -S ${SOURCE} -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_FLAGS=-I${fence}
    -D COIF_TOOLS=OFF -D COIF_TESTS=OFF -D COIF_SIMD=static)
set(no_headers -D CMAKE_IGNORE_PATH=/usr/include)

run(${configure} -B ${WORK}/build ${no_headers} -D COIF_GL=OFF)
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${CMAKE_COMMAND} --install ${WORK}/build --prefix ${prefix})
# The fence holds: with the renderer, neither a search for OpenGL nor a build that skipped it gets through.
must_fail(MATCHES "COIF_GLES3_INCLUDE" ${configure} -B ${WORK}/fenced ${no_headers} -D COIF_GL=ON)
run(${configure} -B ${WORK}/fenced -D COIF_GL=ON -D COIF_GLES3_INCLUDE=${fence})
must_fail(MATCHES "this machine has no OpenGL" ${CMAKE_COMMAND} --build ${WORK}/fenced --target coif_gl)

build_game(game "${sim_games};only_skin" -D PARTS=sim,skinning -D README=${SOURCE}/README.md -D CMAKE_CXX_FLAGS=-I${fence}
  ${without_highway})

include(${consumer}/pkg_config.cmake)

# The part that was not built is missed when the game is configured, by name, and has left nothing behind.
must_fail(MATCHES "built without 'gl'" ${configure_game} -B ${WORK}/absent -D PARTS=gl)
must_fail(MATCHES "no component 'smi'; it has formats, sim," ${configure_game} -B ${WORK}/unknown -D PARTS=formats,smi)
file(GLOB_RECURSE left ${prefix}/*coif_gl* ${prefix}/*renderer.h)
if(left)
  message(FATAL_ERROR "installed although not built: ${left}")
endif()
