# Installs the files for games: shipped libraries, public headers, the CMake package; and the coif program for their builds.
include(CMakePackageConfigHelpers)
set(shipped coif_formats coif_sim coif_skinning coif_drawing coif_c coif_shared)
if(COIF_GL)
  list(APPEND shipped coif_gl coif_research)
endif()
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/coif)

install(TARGETS ${shipped} EXPORT coif-targets FILE_SET HEADERS)
install(EXPORT coif-targets NAMESPACE coif:: DESTINATION ${package_folder})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/coif-config.cmake.in
  ${PROJECT_BINARY_DIR}/coif-config.cmake INSTALL_DESTINATION ${package_folder} PATH_VARS CMAKE_INSTALL_BINDIR)
# Before 1.0 a minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/coif-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/coif-config.cmake ${PROJECT_BINARY_DIR}/coif-config-version.cmake
  ${CMAKE_CURRENT_LIST_DIR}/coif_cook.cmake
  DESTINATION ${package_folder})

# Documents that the headers refer to, in the folders that they name, and shaders for other renderers.
foreach(page LICENSE CHANGELOG.md formats/SPECIFICATION.md runtime/README.md runtime/docs/LANES.md runtime/docs/MODEL.md)
  cmake_path(GET page PARENT_PATH folder)
  install(FILES ${PROJECT_SOURCE_DIR}/${page} DESTINATION ${CMAKE_INSTALL_DOCDIR}/${folder})
endforeach()
install(FILES ${coif_third_party}/THIRD_PARTY_NOTICES.txt ${coif_third_party}/coif.spdx.json DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/runtime/examples DESTINATION ${CMAKE_INSTALL_DOCDIR}/runtime PATTERN CMakeLists.txt EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/shaders DESTINATION ${CMAKE_INSTALL_DOCDIR} PATTERN embed.cmake EXCLUDE)

# Files for pkg-config, for games that are not built by CMake: one per library, and `coif` for the C interface's libcoif.so.
# They find the installed tree relative to themselves, so it may be moved.
file(RELATIVE_PATH coif_pc_up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" coif_pc_up "${coif_pc_up}")

# coif_pc(FILE LIBRARY DESCRIPTION REQUIRES)
function(coif_pc file library description requires)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/pkgconfig/${file}.pc @ONLY CONTENT [[prefix=${pcfiledir}/@coif_pc_up@
libdir=${prefix}/@CMAKE_INSTALL_LIBDIR@
includedir=${prefix}/@CMAKE_INSTALL_INCLUDEDIR@

Name: @file@
Description: @description@
# A C++ compiler needs -std=c++20 or later.
Version: @PROJECT_VERSION@
Requires: @requires@
Cflags: -I${includedir}
Libs: -L${libdir} -l@library@
]])
  install(FILES ${PROJECT_BINARY_DIR}/pkgconfig/${file}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()

# Archives name their own dependencies. The simulation needs Highway if it chooses its instruction set at run time; a shared
# library finds it by itself.
set(coif_pc_simd "")
if(COIF_SIMD STREQUAL "dispatch" AND NOT BUILD_SHARED_LIBS)
  set(coif_pc_simd ", libhwy")
endif()
coif_pc(coif coif "Hair for games, C interface" "")
coif_pc(coif-formats coif_formats "Hair assets for games: the reader" "")
coif_pc(coif-sim coif_sim "Hair simulation for games" "coif-formats${coif_pc_simd}")
coif_pc(coif-skinning coif_skinning "Hair for games, skinned on the processor" "coif-formats")
coif_pc(coif-drawing coif_drawing "What a renderer of hair computes, for any graphics interface" "coif-formats")
coif_pc(coif-c coif_c "Hair for games, C interface as an archive" "coif-sim, coif-skinning, coif-drawing")
if(COIF_GL)
  coif_pc(coif-gl coif_gl "Hair for games, drawn with OpenGL ES 3.0" "coif-drawing, coif-sim")
  coif_pc(coif-research coif_research "Ways to draw hair to compare with, with OpenGL ES 3.0" "coif-gl")
endif()

if(TARGET coif_cli)
  if(BUILD_SHARED_LIBS)
    file(RELATIVE_PATH coif_libraries /${CMAKE_INSTALL_BINDIR} /${CMAKE_INSTALL_LIBDIR})
    set_target_properties(coif_cli PROPERTIES INSTALL_RPATH "$ORIGIN/${coif_libraries}")
  endif()
  install(PROGRAMS ${CMAKE_CURRENT_LIST_DIR}/../tools/farm/coif-farm TYPE BIN)
  install(TARGETS coif_cli RUNTIME)
  install(FILES ${CMAKE_CURRENT_LIST_DIR}/../tools/view/built/view.html DESTINATION ${CMAKE_INSTALL_DATADIR}/coif)
  if(TARGET coif_manual)
    install(FILES ${PROJECT_BINARY_DIR}/man/coif.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  endif()
endif()
