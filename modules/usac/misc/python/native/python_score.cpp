// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "python_score.hpp"
#include "correspondences.hpp"

namespace cv {
namespace usacv20 {
namespace python {

PythonScore::PythonScore(const py::object& score_)
    : score(score_), whole(py::bool_(score_.attr("wholeModel"))),
      part(score_.attr("inlierPart").cast<double>())
{}

PythonScore::~PythonScore()
{
    py::gil_scoped_acquire locked;
    score = py::object();
}

void PythonScore::start(const Context& context)
{
    py::gil_scoped_acquire locked;
    const int sampleSize = context.components.minimalSolver->sampleSize();
    score.attr("_begin")(*fieldsOf(context.points, sampleSize, context.params.scores));
}

void PythonScore::accumulate(float* squaredErrors, int count, float squaredThreshold,
                             Quality& sum) const
{
    py::gil_scoped_acquire locked;
    const py::object rated = score.attr("accumulate")(py::array_t<float>(count, squaredErrors),
                                                      squaredThreshold);
    double cost;
    int inliers;
    try
    {
        const auto pair = rated.cast<std::pair<double, int>>();
        cost = pair.first;
        inliers = pair.second;
    }
    catch (const py::cast_error&)
    {
        CV_Error_(
            Error::StsBadArg,
            ("components.score: accumulate() has to return a cost and a number of inliers, not %s",
             py::repr(rated).cast<std::string>().substr(0, 60).c_str()));
    }
    sum.cost += cost;
    sum.inliers += inliers;
}

}  // namespace python
}  // namespace usacv20
}  // namespace cv
