# VUG_SEPARATE_MEMORY: a host build whose Views lie in memory that the host may not touch, as a GPU's do
# (tests/separate_memory).
include_guard(GLOBAL)
if(NOT VUG_DEVICE_PATH OR NOT VUG_BACKEND MATCHES "OPENMP|SERIAL")
  message(FATAL_ERROR "VUG_SEPARATE_MEMORY needs VUG_DEVICE_PATH on a back end of the host")
endif()
add_library(vug_separate_memory OBJECT tests/separate_memory/device_memory.cpp)
target_link_libraries(vug_separate_memory PRIVATE Kokkos::kokkos)
target_compile_features(vug_separate_memory PRIVATE cxx_std_20)
target_compile_definitions(vug_options INTERFACE VUG_SEPARATE_MEMORY)
target_compile_options(vug_options INTERFACE "SHELL:-include ${PROJECT_SOURCE_DIR}/tests/separate_memory/mirrors.hpp")
target_link_libraries(vug_options INTERFACE $<TARGET_OBJECTS:vug_separate_memory>)
target_link_options(vug_options INTERFACE -rdynamic)
