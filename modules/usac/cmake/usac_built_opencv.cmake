# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# For projects in misc/ that are linked with OpenCV in its build tree: adds the folders of OpenCV's headers in OPENCV_SOURCE and
# OPENCV_BUILD, and sets USAC_BUILT_OPENCV to the list of OpenCV's libraries, opencv_ts first.

include_directories(SYSTEM "${OPENCV_BUILD}")
set(USAC_BUILT_OPENCV "${OPENCV_BUILD}/lib/libopencv_ts.a")
foreach(name calib3d features2d flann highgui imgcodecs imgproc videoio ts core)
  include_directories(SYSTEM "${OPENCV_SOURCE}/modules/${name}/include")
  if(NOT name STREQUAL ts)
    list(APPEND USAC_BUILT_OPENCV "${OPENCV_BUILD}/lib/libopencv_${name}.so")
  endif()
endforeach()
