# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# The C++ tests against an installed OpenCV: those that are built inside OpenCV with `ts`, here with GoogleTest of the system. They
# look into components that a library does not export, so they are linked with the library's own objects in its place. The tests
# themselves, whose speed is not tested, are compiled with little optimization, which takes half the time.

find_package(GTest REQUIRED)
find_package(Threads REQUIRED)

set(_tests "${USAC_MODULE_DIR}/test")
file(GLOB_RECURSE _sources CONFIGURE_DEPENDS "${_tests}/*.cpp")
add_executable(opencv_test_usac EXCLUDE_FROM_ALL $<TARGET_OBJECTS:opencv_usac> ${_sources})
usac_target_options(opencv_test_usac)
target_compile_options(opencv_test_usac PRIVATE ${USAC_ARITHMETIC_FLAGS})
if(NOT MSVC)
  target_compile_options(opencv_test_usac PRIVATE -O1)
endif()
target_compile_definitions(opencv_test_usac PRIVATE
  USAC_SYSTEM_GTEST USAC_TEST_DATA_DIR="${USAC_PROJECT_DIR}/test_data" ${USAC_DEFINITIONS})
target_include_directories(opencv_test_usac PRIVATE "${USAC_MODULE_DIR}/include" "${USAC_MODULE_DIR}/src" "${_tests}")
target_include_directories(opencv_test_usac SYSTEM PRIVATE $<TARGET_PROPERTY:Eigen3::Eigen,INTERFACE_INCLUDE_DIRECTORIES>)
target_link_libraries(opencv_test_usac PRIVATE
  opencv_core opencv_${USAC_OPENCV_GEOMETRY} opencv_imgproc opencv_flann GTest::gtest Threads::Threads ${CMAKE_DL_LIBS})
if(COMMAND target_precompile_headers)
  target_precompile_headers(opencv_test_usac PRIVATE "${_tests}/test_precomp.hpp")
endif()
