# Compilers' flags after which NaN or the bits of results are not what vug counts on are refused when it is configured.
# cmake -DROOT=<project> -DWORK=<empty folder> -P refused_flags.cmake
cmake_minimum_required(VERSION 3.25)

# Includes the options after SETTING and requires that the first error says EXPECTED.
function(require_error SETTING EXPECTED)
  file(WRITE "${WORK}/refused_flags.cmake" "cmake_minimum_required(VERSION 3.25)\n${SETTING}\ninclude(\"${ROOT}/cmake/compile_options.cmake\")\n")
  execute_process(COMMAND "${CMAKE_COMMAND}" -E env --unset=CXXFLAGS --unset=NVCC_PREPEND_FLAGS --unset=NVCC_APPEND_FLAGS
    "${CMAKE_COMMAND}" -P "${WORK}/refused_flags.cmake" RESULT_VARIABLE code ERROR_VARIABLE said)
  if(code EQUAL 0 OR NOT said MATCHES "${EXPECTED}")
    message(FATAL_ERROR "after ${SETTING}: ${said}")
  endif()
endfunction()

require_error("set(CMAKE_CXX_FLAGS \"-O3 -g\")" "add_library")  # not refused: goes on to what only a project may do
require_error("set(CMAKE_CXX_FLAGS \"-Ofast\")" "by +NaN")
require_error("set(ENV{CXXFLAGS} -ffast-math)" "by +NaN")
require_error("set(CMAKE_CXX_FLAGS_RELEASE \"-O3 --use_fast_math\")" "-use_fast_math +is +refused")
require_error("set(ENV{NVCC_APPEND_FLAGS} -use_fast_math)" "-use_fast_math +is +refused")
