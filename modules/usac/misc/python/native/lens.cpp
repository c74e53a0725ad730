// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "arrays.hpp"
#include "unlocked.hpp"

namespace cv {
namespace usacv20 {
namespace python {

namespace {

//! Runs on copies of the arrays and without the interpreter's lock.
py::object withoutDistortion(const py::object& array, const py::object& cameraMatrix,
                             const py::object& distCoeffs)
{
    const Mat points = ArrayMat(array, "points").own(),
              K = ArrayMat(cameraMatrix, "cameraMatrix").own();
    const Mat distortion = ArrayMat(distCoeffs, "distCoeffs").own();
    Mat result;
    {
        const Unlocked unlocked;
        result = removeDistortion(points, K, distortion);
    }
    return arrayOf(result);
}

}  // namespace

void addLens(py::module_& module) { module.def("removeDistortion", &withoutDistortion); }

}  // namespace python
}  // namespace usacv20
}  // namespace cv
