# cmake --install and CPack. Everything lies relative to the prefix, and the program looks for nothing in it: a tree that is
# unpacked or moved anywhere works.
include_guard(GLOBAL)
include(GNUInstallDirs)

# Pages that the program writes of itself, wherever it can start: one for GPUs needs their driver. Target vug_pages.
set(_everywhere ALL)
if((VUG_BACKEND STREQUAL "CUDA" AND NOT EXISTS /proc/driver/nvidia/version) OR
   (VUG_BACKEND STREQUAL "HIP" AND NOT EXISTS /dev/kfd))
  set(_everywhere "")
endif()
set(pages "${PROJECT_BINARY_DIR}/pages")
file(MAKE_DIRECTORY "${pages}")
add_custom_command(OUTPUT "${pages}/vug.1" "${pages}/vug" "${pages}/case.schema.json"
  COMMAND vug man > "${pages}/vug.1"
  COMMAND vug completion bash > "${pages}/vug"
  COMMAND vug schema > "${pages}/case.schema.json"
  DEPENDS vug VERBATIM)
add_custom_target(vug_pages ${_everywhere} DEPENDS "${pages}/vug.1")

set_target_properties(vug PROPERTIES INSTALL_RPATH "$ORIGIN/../lib/vug:$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
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
set(CPACK_GENERATOR TGZ DEB)
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
