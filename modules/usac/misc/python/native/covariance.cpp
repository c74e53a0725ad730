// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "arrays.hpp"
#include "native.hpp"

// Functions for the covariance of a model. They hold the interpreter's lock, because they are fast.

namespace cv {
namespace usacv20 {
namespace python {

namespace {

py::object tangent(int problem, const py::object& model)
{
    return arrayOf(tangentOfModel((ProblemType)problem, ArrayMat(model, "model").mat()));
}

py::object entries(int problem, const py::object& model, const py::object& covariance)
{
    return arrayOf(covarianceOfModel((ProblemType)problem, ArrayMat(model, "model").mat(),
                                     ArrayMat(covariance, "covariance").mat()));
}

py::object pose(const py::object& essential, const py::object& covariance, const py::object& R,
                const py::object& t)
{
    return arrayOf(covarianceOfPose(ArrayMat(essential, "essential").mat(),
                                    ArrayMat(covariance, "covariance").mat(),
                                    ArrayMat(R, "R").mat(), ArrayMat(t, "t").mat()));
}

py::object places(int problem, const py::object& model, const py::object& covariance,
                  const py::object& points1, const py::object& points2,
                  const py::object& cameraMatrix1, const py::object& cameraMatrix2)
{
    return arrayOf(pointCovariance(
        (ProblemType)problem, ArrayMat(model, "model").mat(),
        ArrayMat(covariance, "covariance").mat(), ArrayMat(points1, "points1").mat(),
        ArrayMat(points2, "points2").mat(), ArrayMat(cameraMatrix1, "cameraMatrix1").mat(),
        ArrayMat(cameraMatrix2, "cameraMatrix2").mat()));
}

}  // namespace

void addCovariance(py::module_& module)
{
    module.def("tangentOfModel", &tangent);
    module.def("covarianceOfModel", &entries);
    module.def("covarianceOfPose", &pose);
    module.def("pointCovariance", &places);
}

}  // namespace python
}  // namespace usacv20
}  // namespace cv
