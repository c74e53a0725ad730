# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# Installation of the stand-alone build: headers, library, CMake package, pkg-config file, the programs of the benchmark that the
# documents use, and the license for each Debian package. All paths are relative to the prefix. The CMake package can also be used
# from the build tree.

include(CMakePackageConfigHelpers)
set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/opencv_usac")
install(DIRECTORY "${USAC_MODULE_DIR}/include/opencv2" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/opencv${OpenCV_VERSION_MAJOR}"
  COMPONENT dev FILES_MATCHING PATTERN "*.hpp")
install(TARGETS opencv_usac EXPORT opencv_usac-targets
  RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT library
  LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT library NAMELINK_COMPONENT dev
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT dev)
install(EXPORT opencv_usac-targets DESTINATION "${package_dir}" COMPONENT dev)
export(EXPORT opencv_usac-targets)
configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/opencv_usac-config.cmake.in"
  "${PROJECT_BINARY_DIR}/opencv_usac-config.cmake" INSTALL_DESTINATION "${package_dir}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/opencv_usac-config-version.cmake" VERSION ${PROJECT_VERSION}
  COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/opencv_usac-config.cmake" "${PROJECT_BINARY_DIR}/opencv_usac-config-version.cmake"
  DESTINATION "${package_dir}" COMPONENT dev)

include("${CMAKE_CURRENT_LIST_DIR}/usac_pkgconfig.cmake")
configure_file("${CMAKE_CURRENT_LIST_DIR}/opencv_usac.pc.in" "${PROJECT_BINARY_DIR}/opencv_usac.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/opencv_usac.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig" COMPONENT dev)

# The programs find the library in the same prefix, even if the prefix is moved; in /usr, the system finds the library.
if(BUILD_SAMPLES)
  set(programs usac_benchmark usac_synthetic usac_structured usac_tracking)
  if(NOT CMAKE_INSTALL_PREFIX STREQUAL "/usr")
    file(RELATIVE_PATH to_library "${CMAKE_INSTALL_FULL_BINDIR}" "${CMAKE_INSTALL_FULL_LIBDIR}")
    set_target_properties(${programs} PROPERTIES INSTALL_RPATH "$ORIGIN/${to_library}")
  endif()
  install(TARGETS ${programs} RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT benchmark)
endif()

set(USAC_LIBRARY_PACKAGE "libopencv-usac${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
function(usac_install_license component package)
  install(FILES "${USAC_PROJECT_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/doc/${package}" RENAME copyright
    COMPONENT ${component})
endfunction()
usac_install_license(library ${USAC_LIBRARY_PACKAGE})
usac_install_license(dev libopencv-usac-dev)
if(BUILD_SAMPLES)
  usac_install_license(benchmark usac-benchmark)
endif()
if(BUILD_PYTHON)
  usac_install_license(python python3-usacv20)
endif()
