# One static library per folder. The repository root is the only include path of our own headers.
#
#   tilemend_library(NAME SOURCES a.cc b.cc DEPS x y PCH std BATCH 4)
#   tilemend_test(NAME SOURCES a_test.cc ALONE b_test.cc DEPS x)
#
# PCH: the set of precompiled headers (cmake/headers.cmake), `geometry` by default, `test` for tests.
# BATCH: how many sources are compiled as one with TILEMEND_UNITY; 8 by default, 6 for tests, 1 for none.
# ALONE: sources that are in no batch, since they define a name that another source of the target defines.
#
# In release, tests and what includes gRPC's headers are compiled with -O1 (docs/decisions/2026-11-26-build-time.md).
# Floating-point contraction is off everywhere: the bytes of an output must not depend on the instruction set.
function(tilemend_settings target)
  target_include_directories(${target} PUBLIC ${PROJECT_SOURCE_DIR})
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(${target} PRIVATE -ffp-contract=off -pthread ${TILEMEND_WARNINGS})
endfunction()

# How much TARGET, with the headers of SET, is optimised in release.
function(tilemend_optimise target set)
  if(set MATCHES "services|test$")
    # GCC 12 warns of arrays and strings that it takes for too short at -O1. clang-tidy does not know all of these names.
    target_compile_options(${target} PRIVATE "$<$<CONFIG:Release>:-O1;-Wno-unknown-warning-option;-Wno-array-bounds;-Wno-restrict;-Wno-stringop-overflow;-Wno-stringop-overread>")
  endif()
endfunction()

# Precompiled headers, batches and optimisation of TARGET.
function(tilemend_cheaper target default_set set batch)
  if(NOT set)
    set(set ${default_set})
  endif()
  tilemend_use_headers(${target} ${set})
  tilemend_optimise(${target} ${set})
  if(NOT batch)
    set(batch 8)
  endif()
  if(TILEMEND_UNITY AND batch GREATER 1)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${batch})
  endif()
endfunction()

function(tilemend_library name)
  cmake_parse_arguments(ARG "" "PCH;BATCH" "SOURCES;ALONE;DEPS;PRIVATE_DEPS" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES} ${ARG_ALONE})
  set_source_files_properties(${ARG_ALONE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  tilemend_settings(${name})
  tilemend_cheaper(${name} geometry "${ARG_PCH}" "${ARG_BATCH}")
  target_link_libraries(${name} PUBLIC ${ARG_DEPS} PRIVATE ${ARG_PRIVATE_DEPS})
endfunction()

function(tilemend_binary name)
  cmake_parse_arguments(ARG "" "PCH;BATCH" "SOURCES;DEPS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  tilemend_settings(${name})
  tilemend_cheaper(${name} geometry "${ARG_PCH}" "${ARG_BATCH}")
  target_link_libraries(${name} PRIVATE ${ARG_DEPS})
  # A tenth of the relocations' size: a program that fills one small hole spends a good part of its memory on them.
  target_link_options(${name} PRIVATE -Wl,-z,pack-relative-relocs)
endfunction()

function(tilemend_test name)
  cmake_parse_arguments(ARG "" "TIMEOUT;PCH;BATCH" "SOURCES;DEPS;ALONE" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 120)
  endif()
  if(NOT ARG_BATCH)
    set(ARG_BATCH 6)
  endif()
  add_executable(${name} ${ARG_SOURCES} ${ARG_ALONE})
  set_source_files_properties(${ARG_ALONE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  tilemend_settings(${name})
  tilemend_cheaper(${name} test "${ARG_PCH}" "${ARG_BATCH}")
  target_link_libraries(${name} PRIVATE ${ARG_DEPS} GTest::gmock GTest::gtest_main)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  # The first start of a test on a slow disk, with GDAL's hundred libraries, took longer than CMake's five seconds.
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 120 PROPERTIES TIMEOUT ${ARG_TIMEOUT})
endfunction()

# Links Abseil and gRPC from the archives beside their shared libraries: to load and bind the 50 of them takes longer than
# to fill a small hole.
function(tilemend_link_archives)
  get_property(targets DIRECTORY PROPERTY IMPORTED_TARGETS)
  list(FILTER targets INCLUDE REGEX "^(absl|gRPC)::")
  foreach(target IN LISTS targets)
    get_target_property(configurations ${target} IMPORTED_CONFIGURATIONS)
    foreach(configuration IN LISTS configurations)
      get_target_property(location ${target} IMPORTED_LOCATION_${configuration})
      string(REGEX REPLACE "\\.so[.0-9]*$" ".a" archive "${location}")
      if(EXISTS "${archive}")
        set_target_properties(${target} PROPERTIES IMPORTED_LOCATION_${configuration} "${archive}")
      endif()
    endforeach()
  endforeach()
endfunction()
