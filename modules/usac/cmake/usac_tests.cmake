# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# The C++ tests against an installed OpenCV. Inside OpenCV, the tests are built with OpenCV's module `ts`; here they are built with
# the system's GoogleTest. The tests use components that the library does not export, so they are linked with the library's object
# files instead of the library. The speed of the tests' own files does not matter, so these files are compiled with little
# optimization, which takes half the time.
#
# Targets: opencv_test_usac; usac_fuzz (libFuzzer, needs clang) and usac_replay (the fuzzer's inputs without libFuzzer). misc/sanitize.sh
# passes the flags of its tools in CMAKE_CXX_FLAGS_RELEASE (for all files) or USAC_SOURCE_FLAGS (for the library's files), and in
# CMAKE_EXE_LINKER_FLAGS.

find_package(GTest REQUIRED)
find_package(Threads REQUIRED)

option(USAC_COUNT_ALLOCATIONS "The tests count calls of malloc; OFF if a tool such as a sanitizer replaces malloc" ON)
option(USAC_THREADS_BACKEND "The tests run cv::parallel_for_ with misc/sanitize/threads_backend.cpp, not with OpenCV's threads" OFF)

set(_tests "${USAC_MODULE_DIR}/test")
file(GLOB_RECURSE _sources CONFIGURE_DEPENDS "${_tests}/*.cpp")
if(NOT USAC_COUNT_ALLOCATIONS)
  list(REMOVE_ITEM _sources "${_tests}/support/allocation_counter.cpp")
endif()
if(USAC_THREADS_BACKEND)
  set(_backend "${USAC_MODULE_DIR}/misc/sanitize/threads_backend.cpp")
  set_source_files_properties("${_backend}" PROPERTIES COMPILE_OPTIONS "${USAC_SOURCE_FLAGS}" SKIP_PRECOMPILE_HEADERS ON)
  list(APPEND _sources "${_backend}")
endif()

# The library's object files come first: if they and the tests instantiate the same template, the linker keeps the library's instance.
function(usac_add_test_program name)
  add_executable(${name} EXCLUDE_FROM_ALL $<TARGET_OBJECTS:opencv_usac> ${ARGN})
  usac_target_options(${name})
  target_compile_options(${name} PRIVATE ${USAC_ARITHMETIC_FLAGS})
  if(NOT MSVC)
    target_compile_options(${name} PRIVATE -O1)
  endif()
  target_compile_definitions(${name} PRIVATE
    USAC_SYSTEM_GTEST USAC_TEST_DATA_DIR="${USAC_PROJECT_DIR}/test_data" ${USAC_DEFINITIONS})
  target_include_directories(${name} PRIVATE "${USAC_MODULE_DIR}/include" "${USAC_MODULE_DIR}/src" "${USAC_MODULE_DIR}/test")
  target_include_directories(${name} SYSTEM PRIVATE $<TARGET_PROPERTY:Eigen3::Eigen,INTERFACE_INCLUDE_DIRECTORIES>)
  usac_unite(${name})
  target_link_libraries(${name} PRIVATE
    opencv_core opencv_${USAC_OPENCV_GEOMETRY} opencv_imgproc opencv_flann GTest::gtest Threads::Threads ${CMAKE_DL_LIBS})
endfunction()

usac_add_test_program(opencv_test_usac ${_sources})
if(COMMAND target_precompile_headers)
  target_precompile_headers(opencv_test_usac PRIVATE "${_tests}/test_precomp.hpp")
endif()

set(_sources "${USAC_MODULE_DIR}/misc/fuzz/target.cpp")
foreach(_name fuzz/fuzz_input fuzz/fuzz_pose fuzz/fuzz_rigid fuzz/fuzz_contracts
    support/result_oracle support/lens_oracle support/pose_oracle support/rigid_oracle support/scenes support/scene_scores
    support/scene_geometry problems/absolute_pose/pose_scenes problems/rigid_motion/rigid_scenes)
  list(APPEND _sources "${_tests}/${_name}.cpp")
endforeach()
usac_add_test_program(usac_replay ${_sources})
target_compile_definitions(usac_replay PRIVATE USAC_FUZZ_REPLAY)
if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
  usac_add_test_program(usac_fuzz ${_sources})
  target_compile_options(usac_fuzz PRIVATE ${USAC_SOURCE_FLAGS})
  target_link_libraries(usac_fuzz PRIVATE -fsanitize=fuzzer)
endif()
