# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# Variables of opencv_usac.pc. OpenCV's own .pc file does not always exist, and it names all modules of OpenCV. Therefore, its
# compiler flags are used if it exists, but the libraries are always named here.

file(RELATIVE_PATH USAC_PC_PREFIX "${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig" "${CMAKE_INSTALL_PREFIX}")
string(REGEX REPLACE "/$" "" USAC_PC_PREFIX "${USAC_PC_PREFIX}")

find_package(PkgConfig QUIET)
if(PKG_CONFIG_FOUND)
  pkg_check_modules(USAC_OPENCV_PC QUIET opencv${OpenCV_VERSION_MAJOR}=${OpenCV_VERSION})
endif()
set(USAC_PC_REQUIRES "")
set(USAC_PC_CFLAGS "")
if(USAC_OPENCV_PC_FOUND)
  set(USAC_PC_REQUIRES "opencv${OpenCV_VERSION_MAJOR}")
else()
  foreach(dir ${OpenCV_INCLUDE_DIRS})
    set(USAC_PC_CFLAGS "${USAC_PC_CFLAGS} -I${dir}")
  endforeach()
endif()

if(TARGET opencv_world)
  set(USAC_PC_LIBS "-lopencv_world")
  set(target opencv_world)
else()
  set(USAC_PC_LIBS "-lopencv_${USAC_OPENCV_GEOMETRY} -lopencv_flann -lopencv_imgproc -lopencv_core")
  set(target opencv_core)
endif()
get_target_property(file ${target} LOCATION)
get_filename_component(dir "${file}" DIRECTORY)
if(NOT dir IN_LIST CMAKE_CXX_IMPLICIT_LINK_DIRECTORIES)
  set(USAC_PC_LIBS "-L${dir} ${USAC_PC_LIBS}")
endif()
