# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# The Python package of the stand-alone build: the same package as that of `pip install modules/usac`, but linked with the library
# and installed where Debian's python3 finds it.

set(PYBIND11_FINDPYTHON ON)
# The package is for Debian's python3, so this interpreter is used even if another python3 (of pyenv or conda) is first on the PATH.
if(NOT Python_EXECUTABLE AND NOT Python_ROOT_DIR AND EXISTS /usr/lib/python3/dist-packages)
  set(Python_EXECUTABLE /usr/bin/python3)
endif()
find_package(Python COMPONENTS Interpreter Development.Module REQUIRED)
find_package(pybind11 2.8 REQUIRED CONFIG)
include("${CMAKE_CURRENT_LIST_DIR}/usac_python.cmake")
usac_add_python_module()
target_link_libraries(_native PRIVATE opencv_usac)
if(NOT USAC_INSTALL)
  return()
endif()

set(python_dir lib/python3/dist-packages/usacv20)
install(DIRECTORY "${USAC_MODULE_DIR}/misc/python/package/usacv20/" DESTINATION "${python_dir}" COMPONENT python
  FILES_MATCHING PATTERN "*.py" PATTERN "*.pyi" PATTERN "py.typed" PATTERN "__pycache__" EXCLUDE)
install(TARGETS _native LIBRARY DESTINATION "${python_dir}" COMPONENT python)
file(WRITE "${PROJECT_BINARY_DIR}/usacv20-collection" "#!/usr/bin/python3
import sys

from usacv20.collection._command import main

sys.exit(main())
")
install(PROGRAMS "${PROJECT_BINARY_DIR}/usacv20-collection" DESTINATION bin COMPONENT python)

# Metadata of the package for `importlib.metadata` and pip, with the texts of pyproject.toml.
file(READ "${USAC_MODULE_DIR}/pyproject.toml" project)
foreach(name description requires-python dependencies)
  if(NOT project MATCHES "\n${name} = \\[?\"([^\"]*)\"")
    message(FATAL_ERROR "pyproject.toml: ${name} was not found")
  endif()
  set(usac_${name} "${CMAKE_MATCH_1}")
endforeach()
set(info "${PROJECT_BINARY_DIR}/usacv20-${PROJECT_VERSION}.dist-info")
file(WRITE "${info}/METADATA" "Metadata-Version: 2.1
Name: usacv20
Version: ${PROJECT_VERSION}
Summary: ${usac_description}
License: Apache-2.0
Requires-Python: ${usac_requires-python}
Requires-Dist: ${usac_dependencies}
")
file(WRITE "${info}/INSTALLER" "cmake\n")
install(DIRECTORY "${info}" DESTINATION lib/python3/dist-packages COMPONENT python)
