// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "arrays.hpp"

namespace cv {
namespace usacv20 {
namespace python {

/** Any of the problems. The points are read while the interpreter's lock is held, so that another thread may change the
arrays during the run, which is without it. */
static py::tuple estimate(int problem, const py::object& points1, const py::object& points2, const Params& params,
                          const py::object& cameraMatrix1, const py::object& cameraMatrix2,
                          const py::object& distCoeffs1, const py::object& distCoeffs2)
{
    CV_Assert(problem >= HOMOGRAPHY && problem <= SIMILARITY_3D);
    Ptr<Usac> usac = Usac::create(
        (ProblemType)problem, ArrayMat(points1, "points1").mat(), ArrayMat(points2, "points2").mat(), params,
        ArrayMat(cameraMatrix1, "cameraMatrix1").mat(), ArrayMat(cameraMatrix2, "cameraMatrix2").mat(),
        ArrayMat(distCoeffs1, "distCoeffs1").mat(), ArrayMat(distCoeffs2, "distCoeffs2").mat());
    Mat model, mask;
    Report report;
    {
        py::gil_scoped_release unlocked;
        model = usac->run(mask, &report);
        usac.reset();
    }
    return py::make_tuple(arrayOf(model), arrayOf(mask), report);
}

void addEstimate(py::module_& module)
{
    module.def("estimate", &estimate, py::arg("problem"), py::arg("points1"), py::arg("points2"), py::arg("params"),
               py::arg("cameraMatrix1") = py::none(), py::arg("cameraMatrix2") = py::none(),
               py::arg("distCoeffs1") = py::none(), py::arg("distCoeffs2") = py::none());
}

}  // namespace python
}  // namespace usacv20
}  // namespace cv
