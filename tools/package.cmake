# `cpack` in the build folder makes coif_VERSION_ARCHITECTURE.deb from the installed files: program, libraries, headers, packages
# for CMake and pkg-config, and the manual page. dpkg-shlibdeps finds out which packages the program and libraries need.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME coif)
set(CPACK_PACKAGE_VENDOR "the coif authors")
set(CPACK_PACKAGE_CONTACT "the coif authors <coif@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_DESCRIPTION_FILE ${PROJECT_SOURCE_DIR}/tools/package_description.txt)
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/compress_manual.cmake)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
if(BUILD_SHARED_LIBS)  # the program's, which the package itself brings
  foreach(library ${shipped})
    get_target_property(folder ${library} BINARY_DIR)
    list(APPEND CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${folder})
  endforeach()
endif()
# Packages that a game needs to link the archives.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libhwy-dev")
include(CPack)
