// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "arrays.hpp"
#include "unlocked.hpp"

namespace cv {
namespace usacv20 {
namespace python {

/** Estimates the model of any problem. Arrays and options are copied while the interpreter's lock
is held. The run, including its preparation, does not hold the lock; other threads can then change
the originals. */
static py::tuple estimate(int problem, const py::object& points1, const py::object& points2,
                          const Params& params, const py::object& cameraMatrix1,
                          const py::object& cameraMatrix2, const py::object& distCoeffs1,
                          const py::object& distCoeffs2)
{
    const Mat first = ArrayMat(points1, "points1").own(),
              second = ArrayMat(points2, "points2").own();
    const Mat K1 = ArrayMat(cameraMatrix1, "cameraMatrix1").own(),
              K2 = ArrayMat(cameraMatrix2, "cameraMatrix2").own();
    const Mat d1 = ArrayMat(distCoeffs1, "distCoeffs1").own(),
              d2 = ArrayMat(distCoeffs2, "distCoeffs2").own();
    const Params options = params;
    Mat model, mask;
    Report report;
    {
        const Unlocked unlocked;
        model = estimateModel((ProblemType)problem, first, second, options, mask, report, K1, K2,
                              d1, d2);
    }
    return py::make_tuple(arrayOf(model), arrayOf(mask), report);
}

void addEstimate(py::module_& module)
{
    module.def("estimate", &estimate, py::arg("problem"), py::arg("points1"), py::arg("points2"),
               py::arg("params"), py::arg("cameraMatrix1") = py::none(),
               py::arg("cameraMatrix2") = py::none(), py::arg("distCoeffs1") = py::none(),
               py::arg("distCoeffs2") = py::none());
}

}  // namespace python
}  // namespace usacv20
}  // namespace cv
