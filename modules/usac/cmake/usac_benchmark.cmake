# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# The programs of samples/benchmark, the same inside OpenCV and stand-alone. The caller defines usac_add_program(name sources).

set(_benchmark "${USAC_PROJECT_DIR}/samples/benchmark")
file(GLOB _shared CONFIGURE_DEPENDS "${_benchmark}/*.cpp" "${_benchmark}/*.hpp")
usac_add_program(usac_benchmark ${_shared})

# Its scenes are those of the tests.
file(GLOB _sources CONFIGURE_DEPENDS "${_benchmark}/synthetic/*.cpp" "${_benchmark}/synthetic/*.hpp")
usac_add_program(usac_synthetic ${_sources} "${_benchmark}/arguments.cpp" "${_benchmark}/program.cpp"
  "${USAC_MODULE_DIR}/test/scenes.cpp")
target_include_directories(usac_synthetic PRIVATE "${_benchmark}" "${USAC_MODULE_DIR}/test")

# The same scenes, the methods and measures of usac_benchmark.
list(FILTER _shared EXCLUDE REGEX "/(main|options|pair_list|runner|tables)\\.cpp$")
file(GLOB _sources CONFIGURE_DEPENDS "${_benchmark}/scale/*.cpp" "${_benchmark}/scale/*.hpp")
usac_add_program(usac_scale ${_sources} ${_shared} "${USAC_MODULE_DIR}/test/scenes.cpp")
target_include_directories(usac_scale PRIVATE "${_benchmark}" "${USAC_MODULE_DIR}/test")

# The same scenes with the structure of real ones.
file(GLOB _sources CONFIGURE_DEPENDS "${_benchmark}/structured/*.cpp" "${_benchmark}/structured/*.hpp")
usac_add_program(usac_structured ${_sources} ${_shared} "${_benchmark}/scale/scene_pair.cpp" "${USAC_MODULE_DIR}/test/scenes.cpp")
target_include_directories(usac_structured PRIVATE "${_benchmark}" "${_benchmark}/scale" "${USAC_MODULE_DIR}/test")
