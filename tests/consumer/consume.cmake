# Installs coif into an empty place and builds games against it.
#   cmake -D BUILD=... -D SIMD=dispatch|static -D SHARED=ON|OFF -D WORK=... [-D ASSET=...] -P consume.cmake
# Installs that build tree, which has all parts.
#   cmake -D SOURCE=... ... instead of BUILD: build that source tree first, with as little as can be: no OpenGL, no tools.
#   cmake -D EMBED=... ... instead of BUILD: install nothing; the game adds that source tree to its own build.
#   cmake -D SHARE=... -D GL=ON|OFF ... instead of BUILD: shared libraries, as part of a game's build and installed.
#   cmake -D PACK=... ... instead of BUILD: the Debian package of that build tree, unpacked somewhere.
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

# must_fail(MATCHES regex COMMAND...): the command fails, and says why.
function(must_fail MATCHES regex)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE log ERROR_VARIABLE log)
  string(REGEX REPLACE "[ \n]+" " " log "${log}")
  if(code EQUAL 0 OR NOT log MATCHES "${regex}")
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}: exit code ${code}, without '${regex}':\n${log}")
  endif()
endfunction()

set(configure_game ${CMAKE_COMMAND} -G Ninja -S ${consumer} -D CMAKE_BUILD_TYPE=Release -D CMAKE_PREFIX_PATH=${prefix})
set(without_highway -D CMAKE_DISABLE_FIND_PACKAGE_hwy=ON)

set(sim_games only_open only_lod only_head_bone load_and_step step_by_thesis step_cascade step_character step_world)

# build_game(FOLDER PROGRAMS ARGUMENTS...): configures with the arguments, builds, runs these programs.
function(build_game folder programs)
  run(${configure_game} -B ${WORK}/${folder} ${ARGN})
  run(${CMAKE_COMMAND} --build ${WORK}/${folder})
  foreach(program IN LISTS programs)
    run(${WORK}/${folder}/${program} ${ASSET})
  endforeach()
endfunction()

# build_with(PACKAGES PROGRAM COMMAND...): source files, linked with these packages.
function(build_with packages program)
  execute_process(COMMAND pkg-config --cflags --libs ${packages} RESULT_VARIABLE code OUTPUT_VARIABLE flags ERROR_VARIABLE log)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "pkg-config ${packages}: ${log}")
  endif()
  separate_arguments(flags UNIX_COMMAND "${flags}")
  run(${ARGN} -o ${WORK}/${program} ${flags} -lm -Wl,-rpath,${libraries})
endfunction()

# compile(PACKAGE PROGRAM COMMAND...): one source file, linked with that package, and run.
function(compile package program)
  build_with(${package} ${program} ${ARGN})
  run(${WORK}/${program} ${ASSET})
endfunction()

# compile_by_hand(): games built with what pkg-config says of an installed tree that was moved since. Sets `libraries`.
macro(compile_by_hand)
  set(moved ${WORK}/moved)
  file(COPY ${prefix}/ DESTINATION ${moved})
  file(GLOB_RECURSE description ${moved}/*/coif.pc)
  cmake_path(GET description PARENT_PATH descriptions)
  cmake_path(GET descriptions PARENT_PATH libraries)
  set(ENV{PKG_CONFIG_PATH} ${descriptions})
  find_program(C_COMPILER NAMES cc gcc REQUIRED)
  find_program(CXX_COMPILER NAMES c++ g++ REQUIRED)

  set(cxx ${CXX_COMPILER} -std=c++20 -Wall -Wextra -Werror -Wno-missing-field-initializers)
  compile(coif-formats pkg_only_open ${cxx} -DGAME_only_open ${consumer}/games.cpp)
  compile(coif-sim pkg_load_and_step ${cxx} ${consumer}/load_and_step.cpp)
  compile(coif-skinning pkg_only_skin ${cxx} -DGAME_only_skin ${consumer}/games.cpp)
  compile(coif-drawing pkg_only_cull ${cxx} -DGAME_only_cull ${consumer}/games.cpp)
  if(EXISTS ${descriptions}/coif-gl.pc)
    compile(coif-gl pkg_only_draw ${cxx} -DGAME_only_draw ${consumer}/games.cpp)
  endif()
  if(ASSET)
    file(GLOB_RECURSE step_in_c ${moved}/share/doc/*/step_in_c.c)
    foreach(package coif coif-c)
      compile(${package} pkg_step_in_${package} ${C_COMPILER} -std=c11 -Wall -Wextra -Werror ${step_in_c})
    endforeach()
  endif()
  if(ASSET AND EXISTS ${descriptions}/coif-gl.pc)
    # A renderer of its own takes the shaders that were installed with their page; coif gives it no OpenGL.
    file(GLOB_RECURSE draw_in_c ${moved}/share/doc/*/draw_in_c.c)
    cmake_path(GET draw_in_c PARENT_PATH draw_in_c)
    file(GLOB draw_in_c ${draw_in_c}/*.c)
    file(GLOB_RECURSE shader ${moved}/share/doc/*/hair.vert)
    cmake_path(GET shader PARENT_PATH shaders)
    foreach(package coif coif-c)
      set(program pkg_draw_in_${package})
      build_with("${package};egl;glesv2" ${program} ${C_COMPILER} -std=c11 -Wall -Wextra -Werror ${draw_in_c})
      run(${WORK}/${program} ${ASSET} ${shaders} ${WORK}/drawn.ppm 30 5)
    endforeach()
  endif()
endmacro()

# Reader and simulation for one instruction set, on a machine without OpenGL's headers.
function(smallest_package)
  set(fence ${WORK}/fence)
  foreach(header EGL/egl.h GL/gl.h GLES2/gl2.h GLES3/gl3.h GLES3/gl31.h GLES3/gl32.h KHR/khrplatform.h)
    file(WRITE ${fence}/${header} "#error this machine has no OpenGL\n")
  endforeach()
  # For the instruction set that games ask for, where this is a machine of its kind.
  set(simd -D COIF_SIMD=static)
  set(march "")
  cmake_host_system_information(RESULT processor QUERY OS_PLATFORM)  # a script has no CMAKE_HOST_SYSTEM_PROCESSOR
  if(processor STREQUAL "x86_64")
    set(simd -D COIF_SIMD=avx2)
    set(march " -march=x86-64-v3")
  endif()
  set(configure ${CMAKE_COMMAND} -G Ninja -S ${SOURCE} -D CMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_FLAGS=-I${fence}${march}"
      -D COIF_TOOLS=OFF -D COIF_TESTS=OFF ${simd})
  must_fail(MATCHES "COIF_SIMD is avx512, but the compiler's flags allow" ${configure} -B ${WORK}/asked -D COIF_SIMD=avx512)
  set(no_headers -D CMAKE_IGNORE_PATH=/usr/include)

  run(${configure} -B ${WORK}/build ${no_headers} -D COIF_GL=OFF)
  run(${CMAKE_COMMAND} --build ${WORK}/build)
  run(${CMAKE_COMMAND} --install ${WORK}/build --prefix ${prefix})
  # Highway's headers are all that it needs of it.
  run(${configure} -B ${WORK}/headers_only ${without_highway} -D COIF_GL=OFF)
  # What the headers point to came with them.
  file(GLOB_RECURSE public ${prefix}/include/*.h)
  file(GLOB_RECURSE documents RELATIVE ${prefix} ${prefix}/share/doc/*)
  foreach(header IN LISTS public)
    file(STRINGS ${header} lines REGEX "[a-z]+/[a-zA-Z/]+[.]md")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE ".*[^a-z/]([a-z]+/[a-zA-Z/]+[.]md).*" "\\1" page "${line}")
      if(NOT documents MATCHES "/${page}(;|$)")
        message(FATAL_ERROR "${header} points to ${page}, which is not installed")
      endif()
    endforeach()
  endforeach()
  if(NOT documents MATCHES "/LICENSE(;|$)")
    message(FATAL_ERROR "installed without a licence")
  endif()

  # The fence holds: with the renderer, neither a search for OpenGL nor a build that skipped it gets through.
  must_fail(MATCHES "COIF_GLES3_INCLUDE" ${configure} -B ${WORK}/fenced ${no_headers} -D COIF_GL=ON)
  run(${configure} -B ${WORK}/fenced -D COIF_GL=ON -D COIF_GLES3_INCLUDE=${fence})
  must_fail(MATCHES "this machine has no OpenGL" ${CMAKE_COMMAND} --build ${WORK}/fenced --target coif_gl)

  build_game(game "${sim_games};only_skin;only_cull" -D PARTS=sim,skinning,drawing -D README=${SOURCE}/README.md,${SOURCE}/runtime/README.md
    -D CMAKE_CXX_FLAGS=-I${fence} ${without_highway})

  compile_by_hand()

  # The part that was not built is missed when the game is configured, by name, and has left nothing behind.
  must_fail(MATCHES "built without 'gl'" ${configure_game} -B ${WORK}/absent -D PARTS=gl)
  must_fail(MATCHES "no component 'smi'; it has formats, sim," ${configure_game} -B ${WORK}/unknown -D PARTS=formats,smi)
  file(GLOB_RECURSE left ${prefix}/*coif_gl* ${prefix}/*renderer.h)
  if(left)
    message(FATAL_ERROR "installed although not built: ${left}")
  endif()
endfunction()

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

# Shared libraries. A game with the sources in its own build makes and installs them; others find them installed, and those
# that were moved find each other.
function(shared_package)
  set(parts sim,skinning,drawing,c,shared)
  set(programs ${sim_games} only_skin only_cull)
  if(GL)
    string(APPEND parts ,gl,research)
    list(APPEND programs make_renderer only_draw draw_exactly draw_jittered)
  endif()
  if(ASSET)
    list(APPEND programs step_in_c_c step_in_c_shared)
  endif()

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

  compile_by_hand()
  finds(${WORK}/pkg_load_and_step ${libraries})
  finds(${WORK}/pkg_only_skin ${libraries})
endfunction()

# finds_its_page(): the program in ${prefix} fills in the page that was installed with it, and not another one.
function(finds_its_page)
  set(page ${prefix}/share/coif/view.html)
  run(${prefix}/bin/coif view ${ASSET} -o ${WORK}/page.html)
  file(RENAME ${page} ${page}.kept)
  file(WRITE ${page} "notes")
  must_fail(MATCHES "share/coif/view.html: not the page of coif view" ${prefix}/bin/coif view ${ASSET} -o ${WORK}/page.html)
  file(RENAME ${page}.kept ${page})
endfunction()

# Everything, as one build tree installs it.
function(whole_package)
  run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})

  if(ASSET)
    finds_its_page()
  endif()

  # A header that no file set lists would compile in the project and be absent from the package.
  set(project ${consumer}/../..)
  file(GLOB_RECURSE public RELATIVE ${project} ${project}/formats/include/*.h ${project}/runtime/include/*.h)
  foreach(header IN LISTS public)
    string(REGEX REPLACE "^(formats|runtime)/include/" "" name ${header})
    if(NOT EXISTS ${prefix}/include/${name})
      message(FATAL_ERROR "${header} is public and was not installed; add it to its target's file set")
    endif()
  endforeach()

  set(c_games "")
  if(ASSET)
    set(c_games step_in_c_c step_in_c_shared)
  endif()
  build_game(game "${sim_games};${c_games};only_skin;only_cull;make_renderer;only_draw;draw_exactly;draw_hashed;draw_jittered;draw_by_bones;cast_plainly"
    -D PARTS=formats,sim,skinning,drawing,gl,research,c,shared -D README=${project}/README.md,${project}/runtime/README.md)
  compile_by_hand()
  # Only who simulates needs Highway, and is told when it is not there.
  build_game(reader "only_open;only_skin;only_cull" -D PARTS=formats,skinning,drawing ${without_highway})
  if(SIMD STREQUAL "dispatch" AND NOT SHARED)
    must_fail(MATCHES "(module|dependency) hwy" ${configure_game} -B ${WORK}/lacking ${without_highway})
  endif()
endfunction()

# The Debian package: the program runs, a game links what is in it, and it asks for what it needs.
function(deb_package)
  set(prefix ${WORK}/unpacked/usr)
  run(${CMAKE_CPACK_COMMAND} --config ${PACK}/CPackConfig.cmake -B ${WORK})
  file(GLOB package ${WORK}/coif_*.deb)
  run(dpkg-deb -x ${package} ${WORK}/unpacked)

  execute_process(COMMAND dpkg-deb -f ${package} Depends OUTPUT_VARIABLE needs)
  foreach(library libassimp libc6 libegl1 libfmt)
    if(NOT needs MATCHES "${library}")
      message(FATAL_ERROR "${package} does not depend on ${library}: ${needs}")
    endif()
  endforeach()
  execute_process(COMMAND ${prefix}/bin/coif --version OUTPUT_VARIABLE version RESULT_VARIABLE code)
  if(NOT code EQUAL 0 OR NOT package MATCHES "coif_[0-9.]+_" OR NOT version MATCHES "^coif [0-9.]+")
    message(FATAL_ERROR "the packaged program: exit code ${code}, '${version}'")
  endif()
  run(${prefix}/bin/coif validate ${ASSET})
  finds_its_page()
  execute_process(COMMAND gzip -dc ${prefix}/share/man/man1/coif.1.gz OUTPUT_VARIABLE packed)
  execute_process(COMMAND ${prefix}/bin/coif --man OUTPUT_VARIABLE printed)
  if(NOT packed OR NOT packed STREQUAL printed)
    message(FATAL_ERROR "the packaged manual page is not the one that the program prints")
  endif()
  compile_by_hand()
endfunction()

if(EMBED)
  # For one instruction set and not optimized, which is quicker; the shared libraries are built for all sets.
  # Builds only the parts of coif that these games link.
  run(${configure_game} -B ${WORK}/embedded -D COIF_SOURCE=${EMBED} -D COIF_SIMD=scalar -D CMAKE_BUILD_TYPE=Debug)
  run(${CMAKE_COMMAND} --build ${WORK}/embedded --target ${sim_games})
  foreach(program IN LISTS sim_games)
    run(${WORK}/embedded/${program})
  endforeach()
elseif(SHARE)
  shared_package()
elseif(PACK)
  deb_package()
elseif(BUILD)
  whole_package()
else()
  smallest_package()
endif()
