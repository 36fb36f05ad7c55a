# The Debian package, unpacked somewhere: the program runs, a game links what is in it, and it asks for what it needs.
#   cmake -D BUILD=... -D WORK=... -D ASSET=... -P deb_package.cmake
set(consumer ${CMAKE_CURRENT_LIST_DIR})
set(prefix ${WORK}/unpacked/usr)
file(REMOVE_RECURSE ${WORK})
include(${consumer}/run.cmake)

run(${CMAKE_CPACK_COMMAND} --config ${BUILD}/CPackConfig.cmake -B ${WORK})
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
include(${consumer}/pkg_config.cmake)
