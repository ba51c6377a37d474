# Which commit a program says that it is of.
include_guard(GLOBAL)

set(VUG_COMMIT "" CACHE STRING "Commit that the program names, where the source lies in no repository of its own")

# Puts the commit of the source tree SOURCE into OUT, VUG_COMMIT or "unknown" where it is no repository: one that it
# merely lies in is somebody else's. CMake configures again when the commit changes, so that `git pull && cmake --build`
# has the new one.
function(vug_commit SOURCE OUT)
  if(EXISTS "${SOURCE}/.git")  # a folder, of a linked work tree a file
    execute_process(COMMAND git describe --always --dirty --tags WORKING_DIRECTORY "${SOURCE}"
      OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE ignored)
    execute_process(COMMAND git rev-parse --git-path logs/HEAD WORKING_DIRECTORY "${SOURCE}"
      OUTPUT_VARIABLE log_of_commits OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE ignored)
    get_filename_component(log_of_commits "${log_of_commits}" ABSOLUTE BASE_DIR "${SOURCE}")
    if(NOT CMAKE_SCRIPT_MODE_FILE AND EXISTS "${log_of_commits}" AND NOT IS_DIRECTORY "${log_of_commits}")
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${log_of_commits}")
    endif()
  endif()
  if(NOT commit)
    set(commit "${VUG_COMMIT}")
  endif()
  if(NOT commit)
    set(commit unknown)
  endif()
  set(${OUT} "${commit}" PARENT_SCOPE)
endfunction()
