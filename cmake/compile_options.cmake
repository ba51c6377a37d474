# What every target of vug is compiled with: C++20, warnings (errors with VUG_WERROR), this machine's vector
# instructions. Finite-math flags are refused: the guards of a run rest on NaN being NaN. So is nvcc's -use_fast_math, which
# fuses products and sums and rounds divisions as it likes.
include_guard(GLOBAL)

set(_werror OFF)
if(DEFINED ENV{CI})
  set(_werror ON)
endif()
option(VUG_WERROR "Treat warnings as errors (on where CI is set in the environment)" ${_werror})
option(VUG_NATIVE "On x86-64: compile for this machine's processor" ON)
option(VUG_SANITIZE "Address and undefined-behaviour sanitizers" OFF)

if("${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_RELEASE} $ENV{CXXFLAGS}" MATCHES "-ffast-math|-ffinite-math-only|-Ofast")
  message(FATAL_ERROR "vug detects diverging runs by NaN: -ffast-math, -ffinite-math-only and -Ofast are refused")
endif()
if("${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_RELEASE} $ENV{CXXFLAGS} $ENV{NVCC_PREPEND_FLAGS} $ENV{NVCC_APPEND_FLAGS}" MATCHES "-use_fast_math")
  message(FATAL_ERROR "vug's results have the same bits in every kernel: -use_fast_math is refused")
endif()

add_library(vug_options INTERFACE)
target_compile_features(vug_options INTERFACE cxx_std_20)
target_include_directories(vug_options INTERFACE "${PROJECT_SOURCE_DIR}/src")
target_compile_options(vug_options INTERFACE -Wall -Wextra -Wshadow -Wnon-virtual-dtor $<$<BOOL:${VUG_WERROR}>:-Werror>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # false alarms on std::string and on the intrinsics of AVX-512 (GCC bugs 105651 and 105593)
  target_compile_options(vug_options INTERFACE -Wno-restrict -Wno-maybe-uninitialized)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # packs wider than this processor's registers are handed over in memory: true, and nobody else's code calls ours
  target_compile_options(vug_options INTERFACE -Wno-psabi)
endif()
if(VUG_BACKEND STREQUAL "CUDA")
  # nvcc's own front end repeats host warnings for code that Kokkos generates
  target_compile_options(vug_options INTERFACE -Wno-shadow -Wno-unused-parameter -Wno-unknown-pragmas)
  # nor can it evaluate fmt's format strings while compiling: they are checked when they are used
  target_compile_definitions(vug_options INTERFACE FMT_CONSTEVAL= FMT_USE_CONSTEXPR=1)
endif()
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  # without them a square root or a choice between two values keeps a loop from vectorising; results and NaN stay
  target_compile_options(vug_options INTERFACE -fno-math-errno -fno-trapping-math)
endif()
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  # A node may fall to the vector or to the scalar part of a loop, or to one of two kernels of a GPU, in which the compiler
  # would fuse other products with other sums: unfused, where a node stands in a list changes no bits.
  target_compile_options(vug_options INTERFACE -ffp-contract=off)
endif()
if(VUG_BACKEND STREQUAL "CUDA")
  target_compile_options(vug_options INTERFACE --fmad=false)  # the same for the device
endif()
if(VUG_NATIVE AND NOT VUG_BACKEND STREQUAL "CUDA" AND CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
  target_compile_options(vug_options INTERFACE -march=native -mprefer-vector-width=512)
endif()
if(VUG_PACKS STREQUAL "portable")
  target_compile_definitions(vug_options INTERFACE VUG_PORTABLE_PACKS)
elseif(NOT VUG_PACKS STREQUAL "native")
  message(FATAL_ERROR "VUG_PACKS is \"${VUG_PACKS}\"; expected native or portable")
endif()
if(VUG_DEVICE_PATH)
  target_compile_definitions(vug_options INTERFACE VUG_DEVICE_PATH)
endif()
if(VUG_SANITIZE)
  target_compile_options(vug_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(vug_options INTERFACE -fsanitize=address,undefined)
endif()
