# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# The target `uninstall` of the stand-alone build: removes the files that the last `cmake --install` has written, and then the empty
# folders of the module. With USAC_BUILD_DIR, this file is also the script that the target runs.

if(NOT USAC_BUILD_DIR)
  add_custom_target(uninstall COMMAND "${CMAKE_COMMAND}" "-DUSAC_BUILD_DIR=${PROJECT_BINARY_DIR}" -P "${CMAKE_CURRENT_LIST_FILE}"
    COMMENT "Removing what was installed")
  return()
endif()

# The manifest of `cmake --install`. The manifests of cpack, install_manifest_*.txt, list the files of packages and are not used.
set(manifests "${USAC_BUILD_DIR}/install_manifest.txt")
if(NOT EXISTS "${manifests}")
  message(FATAL_ERROR "${USAC_BUILD_DIR}: nothing has been installed from here")
endif()
foreach(manifest ${manifests})
  file(STRINGS "${manifest}" files)
  foreach(file ${files})
    file(REMOVE "${file}")
    get_filename_component(folder "${file}" DIRECTORY)
    file(REMOVE_RECURSE "${folder}/__pycache__")
    while(folder MATCHES "usac[^/]*(/collection)?$")
      file(GLOB others "${folder}/*")
      if(others)
        break()
      endif()
      file(REMOVE_RECURSE "${folder}")
      get_filename_component(folder "${folder}" DIRECTORY)
    endwhile()
  endforeach()
  file(REMOVE "${manifest}")
endforeach()
