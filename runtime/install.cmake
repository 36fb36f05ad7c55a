# What a game takes with it: shipped libraries, public headers, the CMake package; and the coif program for its build.
include(CMakePackageConfigHelpers)
set(shipped coif_formats coif_sim coif_skinning coif_c coif_shared)
if(COIF_GL)
  list(APPEND shipped coif_gl)
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

include(${CMAKE_CURRENT_LIST_DIR}/pkgconfig.cmake)

if(TARGET coif_cli)
  if(BUILD_SHARED_LIBS)
    file(RELATIVE_PATH coif_libraries /${CMAKE_INSTALL_BINDIR} /${CMAKE_INSTALL_LIBDIR})
    set_target_properties(coif_cli PROPERTIES INSTALL_RPATH "$ORIGIN/${coif_libraries}")
  endif()
  install(PROGRAMS ${CMAKE_CURRENT_LIST_DIR}/../tools/farm/coif-farm TYPE BIN)
  install(TARGETS coif_cli RUNTIME)
  if(TARGET coif_manual)
    install(FILES ${PROJECT_BINARY_DIR}/man/coif.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  endif()
endif()
