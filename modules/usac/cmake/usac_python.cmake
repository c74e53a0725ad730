# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# Adds the target of the extension module usacv20._native. find_package(pybind11) must have been called before. The arguments are
# files that are compiled or linked in addition to the module's own sources. If the module is not linked with the library, the
# arguments must be the library's object files.
function(usac_add_python_module)
  file(GLOB native "${USAC_MODULE_DIR}/misc/python/native/*.cpp")
  pybind11_add_module(_native MODULE NO_EXTRAS ${native} ${ARGN})  # no link-time optimization
  usac_target_options(_native)
  set_target_properties(_native PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_include_directories(_native PRIVATE "${USAC_MODULE_DIR}/include")
  target_link_libraries(_native PRIVATE opencv_core opencv_${USAC_OPENCV_GEOMETRY} opencv_imgproc opencv_flann)
  if(NOT MSVC)  # -O1 suffices, because the module's own sources only pass arrays on
    target_compile_options(_native PRIVATE ${USAC_PATH_FLAGS} -O1 -Wall -Wextra -Wshadow -Wundef -Wnon-virtual-dtor)
  endif()
  usac_precompile(_native "${USAC_MODULE_DIR}/misc/python/native/native.hpp")
  usac_unite(_native)
endfunction()
