# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# Debian packages of the stand-alone build, made by `cpack -G DEB` in its build tree: the library, the development files, with
# BUILD_PYTHON the Python package, and with BUILD_SAMPLES the programs of the benchmark. CMAKE_INSTALL_PREFIX=/usr puts the files
# where Debian expects them. dpkg-shlibdeps (package dpkg-dev) finds out on which packages of shared libraries the packages of the
# library and of the benchmark depend.

set(CPACK_PACKAGE_NAME opencv-usac)
set(CPACK_PACKAGE_CONTACT "The opencv_usac developers <opencv-usac@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX "${CMAKE_INSTALL_PREFIX}")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL library dev)
set(CPACK_STRIP_FILES ON)

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME ${USAC_LIBRARY_PACKAGE})
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "USACv20 robust estimation for OpenCV, library
 Homographies, affine maps, fundamental and essential matrices, poses of cameras
 and rigid motions from matches of which many are wrong.")

set(CPACK_DEBIAN_DEV_PACKAGE_NAME libopencv-usac-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS  # only libopencv-dev has OpenCV's CMake package and pkg-config file
  "${CPACK_DEBIAN_LIBRARY_PACKAGE_NAME} (= ${PROJECT_VERSION}), libopencv-dev")
set(CPACK_COMPONENT_DEV_DESCRIPTION "USACv20 robust estimation for OpenCV, development files
 Headers, the CMake package opencv_usac and the pkg-config file.")

if(BUILD_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-usacv20)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS OFF)  # dpkg-shlibdeps fails, because the library's package is not installed yet
  math(EXPR next "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${CPACK_DEBIAN_LIBRARY_PACKAGE_NAME} (= ${PROJECT_VERSION}), python3-numpy,\
 python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next})")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    "${CMAKE_CURRENT_LIST_DIR}/debian/postinst" "${CMAKE_CURRENT_LIST_DIR}/debian/prerm")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "colmap, python3-distributed, python3-h5py, python3-matplotlib, python3-tqdm")
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "USACv20 robust estimation for OpenCV, Python package
 usacv20.findHomography and similar functions, which need no cv2; the command
 usacv20-collection for all image pairs of a collection.")
endif()

if(BUILD_SAMPLES)
  list(APPEND CPACK_COMPONENTS_ALL benchmark)
  set(CPACK_DEBIAN_BENCHMARK_PACKAGE_NAME usac-benchmark)
  set(CPACK_DEBIAN_BENCHMARK_PACKAGE_SECTION science)
  set(CPACK_DEBIAN_BENCHMARK_PACKAGE_SHLIBDEPS ON)
  # dpkg-shlibdeps finds the library here, because the library's package is not installed.
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${PROJECT_BINARY_DIR}")
  set(CPACK_DEBIAN_BENCHMARK_PACKAGE_DEPENDS "${CPACK_DEBIAN_LIBRARY_PACKAGE_NAME} (= ${PROJECT_VERSION})")
  set(CPACK_COMPONENT_BENCHMARK_DESCRIPTION "USACv20 robust estimation for OpenCV, benchmark programs
 Programs such as usac_benchmark, which measure estimators on lists of image
 pairs and on synthetic scenes.")
endif()

include(CPack)
