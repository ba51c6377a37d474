# Compilers' flags after which NaN or the bits of results are not what vug counts on are refused when it is configured, and
# compilers whose arithmetic is not known.
# cmake -DROOT=<project> -DWORK=<empty folder> -P refused_flags.cmake
cmake_minimum_required(VERSION 3.25)

# Includes the options after SETTING and requires that the first error says EXPECTED.
function(require_error SETTING EXPECTED)
  file(WRITE "${WORK}/refused_flags.cmake" "cmake_minimum_required(VERSION 3.25)\nset(CMAKE_CXX_COMPILER_ID GNU)\n${SETTING}\ninclude(\"${ROOT}/cmake/compile_options.cmake\")\n")
  execute_process(COMMAND "${CMAKE_COMMAND}" -E env --unset=CXXFLAGS --unset=NVCC_PREPEND_FLAGS --unset=NVCC_APPEND_FLAGS
    "${CMAKE_COMMAND}" -P "${WORK}/refused_flags.cmake" RESULT_VARIABLE code ERROR_VARIABLE said)
  if(code EQUAL 0 OR NOT said MATCHES "${EXPECTED}")
    message(FATAL_ERROR "after ${SETTING}: ${said}")
  endif()
endfunction()

require_error("set(CMAKE_CXX_FLAGS \"-O3 -g\")" "add_library")  # not refused: goes on to what only a project may do
require_error("set(CMAKE_CXX_FLAGS \"-Ofast\")" "by +NaN")
require_error("set(ENV{CXXFLAGS} -ffast-math)" "by +NaN")
foreach(configuration RELEASE RELWITHDEBINFO MINSIZEREL DEBUG)
  require_error("set(CMAKE_CXX_FLAGS_${configuration} \"-O2 -ffast-math\")" "by +NaN")
endforeach()
foreach(model "-fp-model=fast" "-fp-model=fast=2" "-fp-model fast" "-ffp-model=fast")
  require_error("set(CMAKE_CXX_FLAGS \"${model}\")" "by +NaN")
endforeach()
require_error("set(CMAKE_CXX_FLAGS \"-fp-model=precise -ffp-contract=fast\")" "add_library")  # ours come later
require_error("set(CMAKE_CXX_FLAGS -funsafe-math-optimizations)" "same +bits")
require_error("set(CMAKE_CXX_FLAGS -fassociative-math)" "same +bits")
require_error("set(CMAKE_CXX_FLAGS_RELEASE \"-O3 --use_fast_math\")" "-use_fast_math +is +refused")
require_error("set(ENV{NVCC_APPEND_FLAGS} -use_fast_math)" "-use_fast_math +is +refused")

foreach(known GNU Clang AppleClang ARMClang IntelLLVM)
  require_error("set(CMAKE_CXX_COMPILER_ID ${known})" "add_library")
endforeach()
foreach(unknown NVHPC Cray Fujitsu Intel MSVC)
  require_error("set(CMAKE_CXX_COMPILER_ID ${unknown})" "\"${unknown}\" to +CMake")
endforeach()

# What a compiler is given against fast arithmetic: its own defaults are not what vug wants.
function(require_options COMPILER EXPECTED)
  file(WRITE "${WORK}/options.cmake" "cmake_minimum_required(VERSION 3.25)\nset(CMAKE_CXX_COMPILER_ID ${COMPILER})\n"
    "foreach(command add_library target_compile_features target_include_directories target_compile_definitions target_link_options)\n"
    "  function(\${command})\n  endfunction()\nendforeach()\n"
    "function(target_compile_options TARGET)\n  message(\"\${ARGN}\")\nendfunction()\n"
    "set(VUG_PACKS native)\ninclude(\"${ROOT}/cmake/compile_options.cmake\")\n")
  execute_process(COMMAND "${CMAKE_COMMAND}" -P "${WORK}/options.cmake" RESULT_VARIABLE code ERROR_VARIABLE said)
  if(NOT code EQUAL 0 OR NOT said MATCHES "${EXPECTED}")
    message(FATAL_ERROR "${COMPILER}: ${said}")
  endif()
endfunction()
require_options(GNU "\nINTERFACE;-fno-math-errno;-fno-trapping-math;-ffp-contract=off\n")
require_options(IntelLLVM "\nINTERFACE;-fp-model=precise;-fno-math-errno;-fno-trapping-math;-ffp-contract=off\n")
