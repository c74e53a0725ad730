# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# The programs of benchmark/, for builds inside OpenCV and stand-alone builds. The caller defines usac_add_program(name sources) and
# usac_add_sample_library(name sources).

set(_benchmark "${USAC_MODULE_DIR}/benchmark")

# The benchmark without its main(), for programs that register methods of their own, see doc/benchmark.md.
file(GLOB _sources CONFIGURE_DEPENDS "${_benchmark}/*.cpp" "${_benchmark}/*.hpp" "${_benchmark}/problems/*.cpp"
  "${_benchmark}/problems/*.hpp")
list(REMOVE_ITEM _sources "${_benchmark}/main.cpp")
usac_add_sample_library(usac_benchmark_lib ${_sources})
target_include_directories(usac_benchmark_lib PUBLIC "${_benchmark}")

# The synthetic scenes of the tests.
usac_add_sample_library(usac_benchmark_scenes
  "${USAC_MODULE_DIR}/test/support/scenes.cpp" "${USAC_MODULE_DIR}/test/support/scene_scores.cpp"
  "${USAC_MODULE_DIR}/test/support/scene_geometry.cpp" "${USAC_MODULE_DIR}/test/problems/absolute_pose/pose_scenes.cpp"
  "${USAC_MODULE_DIR}/test/problems/rigid_motion/rigid_scenes.cpp")
target_include_directories(usac_benchmark_scenes PUBLIC "${USAC_MODULE_DIR}/test")
target_link_libraries(usac_benchmark_scenes PUBLIC usac_benchmark_lib)

# Adds a program of the benchmark: name, sources, and libraries after LIBRARIES.
function(usac_add_benchmark name)
  cmake_parse_arguments(PARSE_ARGV 1 _program "" "" LIBRARIES)
  usac_add_program(${name} ${_program_UNPARSED_ARGUMENTS})
  target_link_libraries(${name} PRIVATE ${_program_LIBRARIES})
endfunction()

usac_add_benchmark(usac_benchmark "${_benchmark}/main.cpp" LIBRARIES usac_benchmark_lib)
foreach(_name synthetic structured tracking covariance)
  file(GLOB _sources CONFIGURE_DEPENDS "${_benchmark}/${_name}/*.cpp" "${_benchmark}/${_name}/*.hpp")
  usac_add_benchmark(usac_${_name} ${_sources} LIBRARIES usac_benchmark_scenes)
endforeach()

# Programs with custom methods: those of the example, and those of the tests.
usac_add_benchmark(usac_custom_benchmark "${_benchmark}/custom/main.cpp" LIBRARIES usac_benchmark_lib)
target_include_directories(usac_custom_benchmark PRIVATE "${USAC_PROJECT_DIR}/samples")
usac_add_benchmark(usac_test_methods "${_benchmark}/custom/test_methods.cpp" LIBRARIES usac_benchmark_lib)
