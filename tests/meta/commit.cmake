# The commit that a program names: that of its own repository, never that of one in which its source merely lies.
# cmake -DROOT=<project> -DWORK=<empty folder> -P commit.cmake
cmake_minimum_required(VERSION 3.25)
include("${ROOT}/cmake/commit.cmake")

file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}/outer/vug")
foreach(variable GIT_DIR GIT_WORK_TREE GIT_INDEX_FILE)
  unset(ENV{${variable}})
endforeach()

function(git FOLDER)
  execute_process(COMMAND git -c user.name=vug -c user.email=vug@example.org ${ARGN} WORKING_DIRECTORY "${FOLDER}"
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(require_commit FOLDER EXPECTED)
  vug_commit("${WORK}/outer/${FOLDER}" commit)
  if(NOT commit STREQUAL EXPECTED)
    message(FATAL_ERROR "the commit is \"${commit}\", not \"${EXPECTED}\"")
  endif()
endfunction()

git("${WORK}/outer" init -q)
git("${WORK}/outer" commit -q --allow-empty -m "of somebody")
git("${WORK}/outer" tag somebody)
require_commit(vug unknown)
set(VUG_COMMIT v0-of-an-archive)
require_commit(vug v0-of-an-archive)

git("${WORK}/outer/vug" init -q)
git("${WORK}/outer/vug" commit -q --allow-empty -m "of vug")
git("${WORK}/outer/vug" tag own)
require_commit(vug own)
git("${WORK}/outer/vug" worktree add -q ../linked)
require_commit(linked own)
