# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# Inside OpenCV, a hook of OpenCV runs this file after all modules. OpenCV 4.9 and later write a stub, cv2/usacv20/__init__.pyi, from
# what their generator finds in the headers. A type checker would read this stub instead of the Python layer, which has more
# functions, other types of arguments, and types of its own. The stub is therefore removed from the folder where it is generated and
# from which it would be installed, and from the build tree's copy of the layer.

if(TARGET copy_opencv_typing_stubs AND TARGET gen_opencv_python_source AND TARGET opencv_python3)
  set(stub cv2/usacv20/__init__.pyi)
  add_custom_target(usac_typing_stubs
    COMMAND "${CMAKE_COMMAND}" -E remove -f "${OPENCV_PYTHON_BINDINGS_DIR}/${stub}" "${CMAKE_BINARY_DIR}/python_loader/${stub}")
  add_dependencies(usac_typing_stubs copy_opencv_typing_stubs gen_opencv_python_source)
  add_dependencies(opencv_python3 usac_typing_stubs)
endif()
