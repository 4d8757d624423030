# Precompiled headers, one set per layer. A target names its set with PCH (cmake/tilemend.cmake):
#
#   std        standard library and Abseil
#   geometry   std, Eigen
#   services   geometry, nlohmann JSON, Protobuf, gRPC and the generated headers
#   test       geometry, GoogleTest
#   services_test   services, GoogleTest
#
# An object library with an empty source compiles each set once, when the first target that needs it is built. GCC takes a
# precompiled header only with the flags that it was compiled with: -pthread is among them for every target, and -O1 in
# release (tilemend_optimise).
set(TILEMEND_STD_HEADERS
  <algorithm> <array> <atomic> <chrono> <cmath> <condition_variable> <cstddef> <cstdint> <cstdlib> <cstring> <deque>
  <filesystem> <functional> <iterator> <limits> <map> <memory> <mutex> <numbers> <numeric> <optional> <queue> <random>
  <set> <span> <string> <string_view> <system_error> <thread> <tuple> <unordered_map> <unordered_set> <utility>
  <variant> <vector>
  <absl/status/status.h> <absl/status/statusor.h> <absl/strings/str_cat.h> <absl/strings/str_format.h>
  <absl/strings/str_join.h> <absl/strings/str_split.h> <absl/time/clock.h> <absl/time/time.h>)
set(TILEMEND_GEOMETRY_HEADERS ${TILEMEND_STD_HEADERS} <Eigen/Core> <Eigen/Geometry>)
set(TILEMEND_SERVICES_HEADERS ${TILEMEND_GEOMETRY_HEADERS} <nlohmann/json.hpp> <grpcpp/grpcpp.h>
  <tilemend/v1/jobs.grpc.pb.h> <tilemend/v1/work.grpc.pb.h> <tilemend/v1/stages.pb.h> <tilemend/v1/error_info.pb.h>)
set(TILEMEND_TEST_HEADERS ${TILEMEND_GEOMETRY_HEADERS} <gmock/gmock.h> <gtest/gtest.h>)
set(TILEMEND_SERVICES_TEST_HEADERS ${TILEMEND_SERVICES_HEADERS} <gmock/gmock.h> <gtest/gtest.h>)

# Target of the headers of a set; made when it is first asked for. DEPS: what has the include folders.
function(tilemend_precompile_set set)
  cmake_parse_arguments(ARG "" "" "DEPS" ${ARGN})
  string(TOUPPER ${set} upper)
  set(source ${CMAKE_BINARY_DIR}/headers/${set}.cc)
  file(CONFIGURE OUTPUT ${source} CONTENT "// Empty: this target compiles headers only.\n")
  add_library(tilemend_headers_${set} OBJECT EXCLUDE_FROM_ALL ${source})
  tilemend_settings(tilemend_headers_${set})
  target_link_libraries(tilemend_headers_${set} PRIVATE ${ARG_DEPS})
  tilemend_optimise(tilemend_headers_${set} ${set})
  target_precompile_headers(tilemend_headers_${set} PRIVATE ${TILEMEND_${upper}_HEADERS})
  # ccache took the set of older generated headers for that of new ones.
  set_target_properties(tilemend_headers_${set} PROPERTIES CXX_COMPILER_LAUNCHER "")
endfunction()

function(tilemend_precompiled_sets)
  if(NOT TILEMEND_PCH)
    return()
  endif()
  tilemend_precompile_set(std)
  tilemend_precompile_set(geometry DEPS Eigen3::Eigen)
  if(TILEMEND_SERVICES)
    tilemend_precompile_set(services DEPS Eigen3::Eigen tilemend_proto gRPC::grpc++)
  endif()
  if(TILEMEND_TESTS)
    tilemend_precompile_set(test DEPS Eigen3::Eigen GTest::gmock GTest::gtest)
    if(TILEMEND_SERVICES)
      tilemend_precompile_set(services_test DEPS Eigen3::Eigen tilemend_proto gRPC::grpc++ GTest::gmock GTest::gtest)
    endif()
  endif()
endfunction()

# Lets TARGET use the headers of SET; SET may be `none`.
function(tilemend_use_headers target set)
  if(TILEMEND_PCH AND NOT set STREQUAL none)
    target_precompile_headers(${target} REUSE_FROM tilemend_headers_${set})
  endif()
endfunction()
