# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# Finds the installed OpenCV, version 4.5.4 to 5. USAC_OPENCV_GEOMETRY is the module with findHomography and similar functions,
# USAC_OPENCV_FEATURES the module with feature detectors. CMAKE_CXX_STANDARD is set to the version of C++ that OpenCV's headers
# need, unless the caller has set it.

set(USAC_OPENCV_MINIMUM 4.5.4)

# usac_find_opencv(<QUIET | REQUIRED> [optional modules]): sets OpenCV_FOUND like find_package. With OpenCV 4, the module name
# `features` means features2d.
macro(usac_find_opencv mode)
  find_package(OpenCV QUIET)
  if(OpenCV_FOUND AND OpenCV_VERSION VERSION_LESS USAC_OPENCV_MINIMUM)
    set(OpenCV_FOUND FALSE)
  endif()
  set(USAC_OPENCV_GEOMETRY calib3d)
  set(USAC_OPENCV_FEATURES features2d)
  set(_standard 11)
  if(OpenCV_FOUND AND OpenCV_VERSION VERSION_GREATER_EQUAL 5)
    set(USAC_OPENCV_GEOMETRY geometry)
    set(USAC_OPENCV_FEATURES features)
    set(_standard 17)
  endif()
  if(NOT CMAKE_CXX_STANDARD)
    set(CMAKE_CXX_STANDARD ${_standard})
    set(CMAKE_CXX_EXTENSIONS OFF)
  endif()
  if(OpenCV_FOUND)
    string(REGEX REPLACE "(^|;)features(;|$)" "\\1${USAC_OPENCV_FEATURES}\\2" _optional "${ARGN}")
    find_package(OpenCV ${mode} COMPONENTS core imgproc flann ${USAC_OPENCV_GEOMETRY} OPTIONAL_COMPONENTS ${_optional})
  elseif("${mode}" STREQUAL REQUIRED)
    message(FATAL_ERROR "OpenCV ${USAC_OPENCV_MINIMUM} or later was not found (Debian: libopencv-dev; elsewhere: -DOpenCV_DIR=...)")
  endif()
endmacro()
