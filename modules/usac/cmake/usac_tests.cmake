# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# The C++ tests against an installed OpenCV: those that are built inside OpenCV with `ts`, here with GoogleTest of the system. They
# look into components that a library does not export, so they are linked with the library's own objects in its place. The
# fuzzer's oracle without libFuzzer (usac_replay) and, by clang, with it (usac_fuzz). For sanitizers: USAC_TOOL_FLAGS.

find_package(GTest REQUIRED)
find_package(Threads REQUIRED)

set(USAC_TOOL_FLAGS "" CACHE STRING "Compiler options of the library's sources, and of its tests' linker, for tools such as sanitizers")
option(USAC_THREADS_BACKEND "Tests: parallel_for_ by threads_backend.cpp, not by the threads of OpenCV" OFF)
separate_arguments(_flags UNIX_COMMAND "${USAC_TOOL_FLAGS}")
target_compile_options(opencv_usac PRIVATE ${_flags})
target_link_libraries(opencv_usac PRIVATE ${_flags})

set(_tests "${USAC_MODULE_DIR}/test")
file(GLOB_RECURSE _sources CONFIGURE_DEPENDS "${_tests}/*.cpp")
if(USAC_TOOL_FLAGS)
  list(FILTER _sources EXCLUDE REGEX "allocation_counter\\.cpp")  # malloc belongs to the tool
endif()
if(USAC_THREADS_BACKEND)
  list(APPEND _sources "${USAC_MODULE_DIR}/misc/sanitize/threads_backend.cpp")
endif()

# The tests themselves, whose speed is not tested, with little optimization, which takes half the time. The tools see what the
# library does; the tests are compiled without their flags, so that a cache of the compiler serves all tools.
function(usac_add_tests name)
  add_executable(${name} EXCLUDE_FROM_ALL $<TARGET_OBJECTS:opencv_usac> ${ARGN})
  usac_target_options(${name})
  target_compile_options(${name} PRIVATE -O1 ${USAC_ARITHMETIC_FLAGS})
  target_compile_definitions(${name} PRIVATE
    USAC_SYSTEM_GTEST USAC_TEST_DATA_DIR="${USAC_PROJECT_DIR}/test_data" ${USAC_DEFINITIONS})
  target_include_directories(${name} PRIVATE
    "${USAC_MODULE_DIR}/include" "${USAC_MODULE_DIR}/src" "${USAC_MODULE_DIR}/test")
  target_include_directories(${name} SYSTEM PRIVATE
    $<TARGET_PROPERTY:Eigen3::Eigen,INTERFACE_INCLUDE_DIRECTORIES>)
  target_link_libraries(${name} PRIVATE ${_flags} opencv_core opencv_${USAC_OPENCV_GEOMETRY} opencv_imgproc opencv_flann GTest::gtest Threads::Threads
    ${CMAKE_DL_LIBS})
endfunction()

usac_add_tests(opencv_test_usac ${_sources})
if(COMMAND target_precompile_headers)
  target_precompile_headers(opencv_test_usac PRIVATE "${_tests}/test_precomp.hpp")
endif()
