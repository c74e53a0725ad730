# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# cmake --build build --target usac_docs: makes HTML pages from the public headers, tutorials and documents. The first page is
# build/doc/html/index.html. Warnings are errors. The target exists only if doxygen is installed, and bibtex (texlive-binaries) and
# perl, which doxygen calls for citations.

find_package(Doxygen QUIET)
find_program(USAC_BIBTEX bibtex)
find_program(USAC_PERL perl)
mark_as_advanced(USAC_BIBTEX USAC_PERL)
if(NOT DOXYGEN_FOUND OR NOT USAC_BIBTEX OR NOT USAC_PERL)
  message(STATUS "No target usac_docs: doxygen, bibtex or perl was not found")
  return()
endif()

set(USAC_DOCS_MODULE "${PROJECT_SOURCE_DIR}/modules/usac")
file(GLOB files doc/measurements/*.png)
set(USAC_DOCS_FILES "")
foreach(file ${files} "${PROJECT_SOURCE_DIR}/doc/CITATION.cff" "${PROJECT_SOURCE_DIR}/LICENSE")
  string(APPEND USAC_DOCS_FILES " \"${file}\"")
endforeach()
configure_file(modules/usac/cmake/Doxyfile.in "${PROJECT_BINARY_DIR}/Doxyfile" @ONLY)

# Old pages are removed first, because doxygen does not remove those of deleted symbols. Doxygen calls bibtex in the folder of its
# own bibliography style; without the settings of a TeX installation, bibtex must be told to search this folder.
add_custom_target(usac_docs
  COMMAND "${CMAKE_COMMAND}" -E remove_directory "${PROJECT_BINARY_DIR}/doc/html"
  COMMAND "${CMAKE_COMMAND}" -E make_directory "${PROJECT_BINARY_DIR}/doc"
  COMMAND "${CMAKE_COMMAND}" -E env BIBINPUTS=. BSTINPUTS=. "${DOXYGEN_EXECUTABLE}" "${PROJECT_BINARY_DIR}/Doxyfile"
  WORKING_DIRECTORY "${USAC_DOCS_MODULE}"
  COMMENT "Pages: ${PROJECT_BINARY_DIR}/doc/html/index.html"
  VERBATIM)
