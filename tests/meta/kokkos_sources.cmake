# Where Kokkos comes from, without the internet: a folder of archives, and a source tree that is kept with the project. One
# that was built before serves again only with the same compiler for GPUs and the same GPU.
# cmake -DROOT=<project> -DWORK=<empty folder> -P kokkos_sources.cmake
cmake_minimum_required(VERSION 3.25)
include("${ROOT}/cmake/kokkos.cmake")

file(REMOVE_RECURSE "${WORK}")

# an archive that is there, with the bytes that are asked for
file(MAKE_DIRECTORY "${WORK}/kokkos-5.0.2" "${WORK}/archives")
file(WRITE "${WORK}/kokkos-5.0.2/CMakeLists.txt"
  "set(Kokkos_VERSION_MAJOR 5)\nset(Kokkos_VERSION_MINOR 0)\nset(Kokkos_VERSION_PATCH 2)\n")
file(ARCHIVE_CREATE OUTPUT "${WORK}/archives/kokkos-5.0.2.tar.gz" PATHS "${WORK}/kokkos-5.0.2" FORMAT gnutar COMPRESSION GZip)
file(SHA256 "${WORK}/archives/kokkos-5.0.2.tar.gz" VUG_KOKKOS_SHA256)
set(VUG_ARCHIVES "${WORK}/archives")
set(VUG_DEPS_DIR "${WORK}/deps")
vug_fetch_kokkos_archive("${WORK}/fetched.tar.gz")
file(SHA256 "${WORK}/fetched.tar.gz" fetched)
if(NOT fetched STREQUAL VUG_KOKKOS_SHA256)
  message(FATAL_ERROR "the archive in VUG_ARCHIVES was not taken")
endif()

# of those that were built before, the one for the GPU and of the nvcc that are asked for, in a folder configured before too
set(VUG_BACKEND CUDA)
set(CMAKE_CXX_COMPILER_ID GNU)
set(CMAKE_CXX_COMPILER_VERSION 12.2.0)
set(ENV{CUDA_ROOT} "${WORK}/cuda")
function(require_kokkos NVCC VUG_GPU_ARCH)
  file(WRITE "${WORK}/cuda/bin/nvcc" "#!/bin/sh\necho 'Cuda compilation tools, release ${NVCC}, V${NVCC}.88'\n")
  file(CHMOD "${WORK}/cuda/bin/nvcc" PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
  set(prefix "${VUG_DEPS_DIR}/install-5.0.2-cuda-GNU12.2.0-${VUG_GPU_ARCH}-nvcc${NVCC}")
  file(WRITE "${prefix}/lib/cmake/Kokkos/KokkosConfig.cmake" "function(kokkos_check)\nendfunction()\n")
  file(WRITE "${prefix}/lib/cmake/Kokkos/KokkosConfigVersion.cmake" "set(PACKAGE_VERSION 5.0.2)\nset(PACKAGE_VERSION_COMPATIBLE TRUE)\n")
  file(TOUCH "${prefix}/complete")
  vug_provide_kokkos()
  if(NOT Kokkos_DIR STREQUAL "${prefix}/lib/cmake/Kokkos")
    message(FATAL_ERROR "nvcc ${NVCC} for ${VUG_GPU_ARCH} took ${Kokkos_DIR}")
  endif()
endfunction()
require_kokkos(12.4 HOPPER90)
require_kokkos(13.0 HOPPER90)
require_kokkos(13.0 ADA89)

# a vendored tree goes before everything, and says its version
set(VUG_KOKKOS_SOURCE "${WORK}/kokkos-5.0.2")
vug_kokkos_source(source)
vug_kokkos_version("${source}" version)
if(NOT source STREQUAL VUG_KOKKOS_SOURCE OR NOT version STREQUAL "5.0.2")
  message(FATAL_ERROR "VUG_KOKKOS_SOURCE gave ${source}, version ${version}")
endif()

# and so does an archive of another version, which is unpacked once
file(WRITE "${WORK}/other/kokkos-5.2.2/CMakeLists.txt"
  "set(Kokkos_VERSION_MAJOR 5)\nset(Kokkos_VERSION_MINOR 2)\nset(Kokkos_VERSION_PATCH 2)\n")
execute_process(COMMAND "${CMAKE_COMMAND}" -E tar czf "${WORK}/kokkos_5.2.2.orig.tar.gz" kokkos-5.2.2
  WORKING_DIRECTORY "${WORK}/other" COMMAND_ERROR_IS_FATAL ANY)
set(VUG_KOKKOS_SOURCE "${WORK}/kokkos_5.2.2.orig.tar.gz")
vug_kokkos_source(source)
vug_kokkos_version("${source}" version)
if(NOT source MATCHES "/deps/kokkos-vendored-[0-9a-f]+$" OR NOT version STREQUAL "5.2.2")
  message(FATAL_ERROR "an archive in VUG_KOKKOS_SOURCE gave ${source}, version ${version}")
endif()
file(WRITE "${source}/mark" "")
vug_kokkos_source(again)
if(NOT EXISTS "${again}/mark")
  message(FATAL_ERROR "the archive was unpacked twice")
endif()

# what is none is refused in words
file(WRITE "${WORK}/refused.cmake" "include(\"${ROOT}/cmake/kokkos.cmake\")\nvug_kokkos_version(\"${WORK}\" version)\n")
execute_process(COMMAND "${CMAKE_COMMAND}" -P "${WORK}/refused.cmake" RESULT_VARIABLE code ERROR_VARIABLE said)
string(REGEX REPLACE "[ \n]+" " " said "${said}")  # CMake breaks lines where the path happens to end
if(code EQUAL 0 OR NOT said MATCHES "not the source tree")
  message(FATAL_ERROR "a folder without Kokkos was taken for one: ${said}")
endif()
