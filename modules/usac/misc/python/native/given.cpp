// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "arrays.hpp"
#include "unlocked.hpp"

// Functions without a search (fit, refinement, errors) and the relative pose of two views. They run
// on copies of the arrays and without the interpreter's lock.

namespace cv {
namespace usacv20 {
namespace python {

namespace {

//! Copies of the arrays of a call.
struct Views
{
    Views(int problem_, const py::object& points1, const py::object& points2,
          const py::object& cameraMatrix1, const py::object& cameraMatrix2,
          const py::object& distCoeffs1, const py::object& distCoeffs2)
        : problem((ProblemType)problem_), first(ArrayMat(points1, "points1").own()),
          second(ArrayMat(points2, "points2").own()),
          K1(ArrayMat(cameraMatrix1, "cameraMatrix1").own()),
          K2(ArrayMat(cameraMatrix2, "cameraMatrix2").own()),
          d1(ArrayMat(distCoeffs1, "distCoeffs1").own()),
          d2(ArrayMat(distCoeffs2, "distCoeffs2").own())
    {}

    const ProblemType problem;
    const Mat first, second, K1, K2, d1, d2;
};

py::tuple fit(int problem, const py::object& points1, const py::object& points2,
              const Params& params, const py::object& weights, const py::object& chosen,
              const py::object& cameraMatrix1, const py::object& cameraMatrix2,
              const py::object& distCoeffs1, const py::object& distCoeffs2)
{
    const Views v(problem, points1, points2, cameraMatrix1, cameraMatrix2, distCoeffs1,
                  distCoeffs2);
    const Mat w = ArrayMat(weights, "weights").own(), part = ArrayMat(chosen, "chosen").own();
    const Params options = params;
    Mat model, mask;
    Report report;
    {
        const Unlocked unlocked;
        model = fitModel(v.problem, v.first, v.second, options, mask, report, w, part, v.K1, v.K2,
                         v.d1, v.d2);
    }
    return py::make_tuple(arrayOf(model), arrayOf(mask), report);
}

py::tuple refine(int problem, const py::object& model, const py::object& points1,
                 const py::object& points2, const Params& params, const py::object& chosen,
                 const py::object& cameraMatrix1, const py::object& cameraMatrix2,
                 const py::object& distCoeffs1, const py::object& distCoeffs2)
{
    const Views v(problem, points1, points2, cameraMatrix1, cameraMatrix2, distCoeffs1,
                  distCoeffs2);
    const Mat given = ArrayMat(model, "model").own(), part = ArrayMat(chosen, "chosen").own();
    const Params options = params;
    Mat refined, mask;
    Report report;
    {
        const Unlocked unlocked;
        refined = refineModel(v.problem, given, v.first, v.second, options, mask, report, part,
                              v.K1, v.K2, v.d1, v.d2);
    }
    return py::make_tuple(arrayOf(refined), arrayOf(mask), report);
}

py::object errors(int problem, const py::object& model, const py::object& points1,
                  const py::object& points2, const Params& params, const py::object& cameraMatrix1,
                  const py::object& cameraMatrix2, const py::object& distCoeffs1,
                  const py::object& distCoeffs2)
{
    const Views v(problem, points1, points2, cameraMatrix1, cameraMatrix2, distCoeffs1,
                  distCoeffs2);
    const Mat given = ArrayMat(model, "model").own();
    const Params options = params;
    Mat result;
    {
        const Unlocked unlocked;
        result = modelErrors(v.problem, given, v.first, v.second, options, v.K1, v.K2, v.d1, v.d2);
    }
    return arrayOf(result);
}

//! @return R, t, mask, report, essential, behind, onPlane, otherR, otherT, otherInliers
py::tuple relativePose(const py::object& points1, const py::object& points2,
                       const py::object& cameraMatrix1, const py::object& distCoeffs1,
                       const py::object& cameraMatrix2, const py::object& distCoeffs2,
                       const Params& params)
{
    const Views v(ESSENTIAL, points1, points2, cameraMatrix1, cameraMatrix2, distCoeffs1,
                  distCoeffs2);
    const Params options = params;
    Mat R, t, mask;
    RelativePose pose;
    {
        const Unlocked unlocked;
        estimateRelativePose(v.first, v.second, v.K1, v.d1, v.K2, v.d2, options, R, t, mask, pose);
    }
    return py::make_tuple(arrayOf(R), arrayOf(t), arrayOf(mask), pose.report,
                          arrayOf(pose.essential), pose.behind, pose.onPlane, arrayOf(pose.otherR),
                          arrayOf(pose.otherT), pose.otherInliers);
}

}  // namespace

void addGiven(py::module_& module)
{
    module.def("fitModel", &fit);
    module.def("refineModel", &refine);
    module.def("modelErrors", &errors);
    module.def("estimateRelativePose", &relativePose);
}

}  // namespace python
}  // namespace usacv20
}  // namespace cv
