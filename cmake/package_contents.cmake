# CPack runs this when a package's tree is complete, once for each kind of package.
# Tarball: without root nobody installs libraries, so it brings all of them but those of glibc. A .deb names them instead,
# has its pages and its history compressed as Debian wants them, and no search path of its own.
file(GLOB_RECURSE _executable "${CPACK_TEMPORARY_DIRECTORY}/vug")
list(FILTER _executable INCLUDE REGEX "/bin/vug$")

if(CPACK_GENERATOR STREQUAL "TGZ")
  find_program(_objdump objdump REQUIRED)
  set(CMAKE_GET_RUNTIME_DEPENDENCIES_PLATFORM "linux+elf")
  set(CMAKE_GET_RUNTIME_DEPENDENCIES_TOOL "objdump")
  set(CMAKE_GET_RUNTIME_DEPENDENCIES_COMMAND "${_objdump}")
  file(GET_RUNTIME_DEPENDENCIES EXECUTABLES "${_executable}" RESOLVED_DEPENDENCIES_VAR _libraries
    UNRESOLVED_DEPENDENCIES_VAR _missing
    POST_EXCLUDE_REGEXES "/(ld-linux[^/]*|lib(c|m|dl|rt|pthread|resolv|util|mvec|anl|nss_[a-z]+))\\.so[^/]*$")
  if(_missing)
    message(FATAL_ERROR "vug needs libraries that are not here: ${_missing}")
  endif()
  get_filename_component(_prefix "${_executable}" DIRECTORY)
  foreach(_library IN LISTS _libraries)
    file(INSTALL DESTINATION "${_prefix}/../lib/vug" TYPE SHARED_LIBRARY FOLLOW_SYMLINK_CHAIN FILES "${_library}")
  endforeach()
endif()

if(CPACK_GENERATOR STREQUAL "DEB")
  file(RPATH_REMOVE FILE "${_executable}")
  get_filename_component(_documents "${_executable}/../../share/doc/vug" ABSOLUTE)
  string(TIMESTAMP _date "%a, %d %b %Y %H:%M:%S +0000" UTC)
  file(WRITE "${_documents}/changelog" "vug (${CPACK_PACKAGE_VERSION}) unstable; urgency=medium\n\n"
    "  * CHANGELOG.md, beside this file, has the changes.\n\n -- ${CPACK_PACKAGE_CONTACT}  ${_date}\n")
  file(GLOB_RECURSE _pages "${CPACK_TEMPORARY_DIRECTORY}/vug*.1" "${CPACK_TEMPORARY_DIRECTORY}/changelog")
  foreach(_page IN LISTS _pages)
    execute_process(COMMAND gzip -9n "${_page}" COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
endif()
