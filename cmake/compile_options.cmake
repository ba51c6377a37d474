# What every target of vug is compiled with: C++20, warnings (errors with VUG_WERROR), this machine's vector
# instructions. Finite-math flags are refused: the guards of a run rest on NaN being NaN. So are flags after which the
# compiler rearranges sums, and nvcc's -use_fast_math, which fuses products and sums and rounds divisions as it likes; and
# compilers of which it is not known how they are kept from doing so unasked.
include_guard(GLOBAL)

option(VUG_WERROR "Treat warnings as errors (scripts/test and scripts/ci-matrix do where CI is set)" OFF)
option(VUG_NATIVE "On x86-64: compile for this machine's processor" ON)
option(VUG_SANITIZE "Address and undefined-behaviour sanitizers" OFF)

set(_flags "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_RELEASE} ${CMAKE_CXX_FLAGS_RELWITHDEBINFO} ${CMAKE_CXX_FLAGS_MINSIZEREL} ${CMAKE_CXX_FLAGS_DEBUG} $ENV{CXXFLAGS}")
if(_flags MATCHES "-ffast-math|-ffinite-math-only|-Ofast|-fp-model[= ]*fast|-ffp-model=(fast|aggressive)")
  message(FATAL_ERROR "vug detects diverging runs by NaN: -ffast-math, -ffinite-math-only, -Ofast and -fp-model=fast are refused")
endif()
if(_flags MATCHES "-funsafe-math-optimizations|-fassociative-math")
  message(FATAL_ERROR "vug's results have the same bits in every kernel: -funsafe-math-optimizations and -fassociative-math are refused")
endif()
if("${_flags} $ENV{NVCC_PREPEND_FLAGS} $ENV{NVCC_APPEND_FLAGS}" MATCHES "-use_fast_math")
  message(FATAL_ERROR "vug's results have the same bits in every kernel: -use_fast_math is refused")
endif()

# What keeps a compiler from fusing a product with a sum. A node may fall to the vector or to the scalar part of a loop, or
# to one of two kernels of a GPU, in which it would fuse others: unfused, where a node stands in a list changes no bits.
# Without the first two a square root or a choice between two values keeps a loop from vectorising; results and NaN stay.
set(_arithmetic -fno-math-errno -fno-trapping-math -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL "IntelLLVM")
  list(PREPEND _arithmetic -fp-model=precise)  # unasked it takes -fp-model=fast
elseif(NOT CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  message(FATAL_ERROR "The compiler is ${CMAKE_CXX_COMPILER} (\"${CMAKE_CXX_COMPILER_ID}\" to CMake). vug is compiled by GCC, "
    "Clang (also a vendor's) or Intel's icpx: of others it is not known here how they are kept from fast arithmetic, after "
    "which results and the search for NaN are not what they should be. Choose one by -DCMAKE_CXX_COMPILER=g++.")
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
target_compile_options(vug_options INTERFACE ${_arithmetic})
if(VUG_BACKEND STREQUAL "CUDA")
  target_compile_options(vug_options INTERFACE --fmad=false)  # nothing is fused on the device either
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
