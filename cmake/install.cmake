# cmake --install and CPack. Everything lies relative to the prefix, and the program looks for nothing in it: a tree that is
# unpacked or moved anywhere works.
include_guard(GLOBAL)
include(GNUInstallDirs)

# Pages that the program writes of itself, wherever it can start: one for GPUs needs their driver, one for another kind of
# processor that processor or an emulator. Target vug_pages.
set(_starts ON)
if((CMAKE_CROSSCOMPILING AND NOT CMAKE_CROSSCOMPILING_EMULATOR) OR
   (VUG_BACKEND STREQUAL "CUDA" AND NOT EXISTS /proc/driver/nvidia/version) OR
   (VUG_BACKEND STREQUAL "HIP" AND NOT EXISTS /dev/kfd))
  set(_starts OFF)
endif()
option(VUG_PAGES "Start vug when it is built, for its manual page, completion and schema (installed with it)" ${_starts})
set(_everywhere "")
if(VUG_PAGES)
  set(_everywhere ALL)
endif()
set(pages "${PROJECT_BINARY_DIR}/pages")
file(MAKE_DIRECTORY "${pages}")
add_custom_command(OUTPUT "${pages}/vug.1" "${pages}/vug" "${pages}/case.schema.json"
  COMMAND vug man > "${pages}/vug.1"
  COMMAND vug completion bash > "${pages}/vug"
  COMMAND vug schema > "${pages}/case.schema.json"
  DEPENDS vug VERBATIM)
add_custom_target(vug_pages ${_everywhere} DEPENDS "${pages}/vug.1")

# Libraries lie beside the program (tarball), where the system looks (.deb), or where they were linked: in folders that
# modules and environments add, which nobody need load again. Packages for elsewhere leave the last ones out (preset package).
if(NOT DEFINED CMAKE_INSTALL_RPATH_USE_LINK_PATH)
  set(CMAKE_INSTALL_RPATH_USE_LINK_PATH TRUE)
endif()
set_target_properties(vug PROPERTIES INSTALL_RPATH "$ORIGIN/../lib/vug:$ORIGIN/../${CMAKE_INSTALL_LIBDIR}"
  INSTALL_RPATH_USE_LINK_PATH "${CMAKE_INSTALL_RPATH_USE_LINK_PATH}")
if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
  target_link_options(vug PRIVATE -Wl,--disable-new-dtags)  # the libraries that a tarball brings find each other there too
endif()
install(TARGETS vug RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
install(PROGRAMS scripts/plot DESTINATION "${CMAKE_INSTALL_BINDIR}" RENAME vug-plot)
install(DIRECTORY python/vug DESTINATION "${CMAKE_INSTALL_DATADIR}/vug/python" PATTERN __pycache__ EXCLUDE)
install(DIRECTORY cases DESTINATION "${CMAKE_INSTALL_DATADIR}/vug")
install(FILES "${pages}/case.schema.json" DESTINATION "${CMAKE_INSTALL_DATADIR}/vug" OPTIONAL)
install(FILES "${pages}/vug.1" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" OPTIONAL)
install(FILES packaging/vug-plot.1 DESTINATION "${CMAKE_INSTALL_MANDIR}/man1")
install(FILES "${pages}/vug" DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" OPTIONAL)
install(FILES README.md CHANGELOG.md CITATION.cff DESTINATION "${CMAKE_INSTALL_DOCDIR}")
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DOCDIR}" RENAME copyright)
install(DIRECTORY docs DESTINATION "${CMAKE_INSTALL_DOCDIR}")

set(CPACK_PACKAGE_NAME vug)
set(CPACK_PACKAGE_VENDOR "The vug authors")
set(VUG_CONTACT "The vug authors <vug@example.org>" CACHE STRING "Whom a package names as its maintainer")
set(CPACK_PACKAGE_CONTACT "${VUG_CONTACT}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "rock that dissolves and fractures at pore scale")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_FILE_NAME "vug-${PROJECT_VERSION}-Linux-${CMAKE_SYSTEM_PROCESSOR}")
set(CPACK_GENERATOR TGZ)
find_program(VUG_DPKG_SHLIBDEPS dpkg-shlibdeps)  # of dpkg-dev: names the packages that a .deb depends on
mark_as_advanced(VUG_DPKG_SHLIBDEPS)
if(VUG_DPKG_SHLIBDEPS)
  list(APPEND CPACK_GENERATOR DEB)
else()
  message(STATUS "cpack makes the tarball only: dpkg-shlibdeps (Debian: dpkg-dev), which a .deb needs, was not found")
endif()
set(CPACK_PRE_BUILD_SCRIPTS "${PROJECT_SOURCE_DIR}/cmake/package_contents.cmake")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3 (>= 3.11)")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-h5py, python3-matplotlib")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
  "Flow, heat, reactive solutes, dissolution and fracture of rock in two
dimensions: lattice Boltzmann methods for what flows, bonded discrete elements
for the rock.")
if(CMAKE_INSTALL_PREFIX_INITIALIZED_TO_DEFAULT)
  set(CPACK_PACKAGING_INSTALL_PREFIX "/usr")
endif()
include(CPack)
