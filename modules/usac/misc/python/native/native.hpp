// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PYTHON_NATIVE_HPP
#define OPENCV_USACV20_PYTHON_NATIVE_HPP

// Declarations shared by the files of the extension module usacv20._native. Its functions are
// described in _native.pyi.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include "opencv2/usac.hpp"

namespace cv {
namespace usacv20 {
namespace python {

namespace py = pybind11;

//! Each function adds its part to the module.
void addErrors(py::module_& module);
void addParams(py::module_& module);
void addReport(py::module_& module);
void addEstimate(py::module_& module);
void addBatch(py::module_& module);
void addFind(py::module_& module);
void addLens(py::module_& module);
void addGiven(py::module_& module);
void addCovariance(py::module_& module);
void addTwoView(py::module_& module);
void addProgress(py::module_& module);
void addRng(py::module_& module);
void addUsac(py::module_& module);

}  // namespace python
}  // namespace usacv20
}  // namespace cv

#endif
