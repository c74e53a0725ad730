# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# Inside OpenCV: the CMake package opencv_usac, so that programs find the module in the same way as after a stand-alone build. The
# package is in the folder of OpenCV's package (OpenCV_DIR), in the build tree and in an installation. Except on Windows, an
# installation also has the package in a folder of its own name, which CMake finds through CMAKE_PREFIX_PATH.

include(CMakePackageConfigHelpers)
include("${CMAKE_CURRENT_LIST_DIR}/usac_version.cmake")

get_filename_component(USAC_OPENCV_PACKAGE "${OPENCV_CONFIG_INSTALL_PATH}" NAME)
set(_config "${CMAKE_BINARY_DIR}/opencv_usac-config.cmake")
set(_version "${CMAKE_BINARY_DIR}/opencv_usac-config-version.cmake")
configure_file("${CMAKE_CURRENT_LIST_DIR}/opencv_usac-config-in-opencv.cmake.in" "${_config}" @ONLY)
write_basic_package_version_file("${_version}" VERSION ${USAC_VERSION} COMPATIBILITY SameMinorVersion)

set(_directories "${OPENCV_CONFIG_INSTALL_PATH}")
if(OPENCV_CONFIG_INSTALL_PATH MATCHES "/cmake/[^/]+$")  # not on Windows, where packages are in the root of the installation
  get_filename_component(_parent "${OPENCV_CONFIG_INSTALL_PATH}" DIRECTORY)
  list(APPEND _directories "${_parent}/opencv_usac")
endif()
foreach(_directory ${_directories})
  install(FILES "${_config}" "${_version}" DESTINATION "${_directory}" COMPONENT dev)
endforeach()
