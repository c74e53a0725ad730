// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "python_usac.hpp"
#include "arrays.hpp"
#include "unlocked.hpp"
#include "correspondences.hpp"
#include "python_sampler.hpp"
#include "python_score.hpp"

namespace cv {
namespace usacv20 {
namespace python {

namespace {

Ptr<Usac> create(int problem, const py::object& points1, const py::object& points2, const Params& params,
                 const py::object& cameraMatrix1, const py::object& cameraMatrix2, const py::object& distCoeffs1,
                 const py::object& distCoeffs2)
{
    CV_Assert(problem >= HOMOGRAPHY && problem <= SIMILARITY_3D);
    return Usac::create((ProblemType)problem, ArrayMat(points1, "points1").mat(), ArrayMat(points2, "points2").mat(),
                        params, ArrayMat(cameraMatrix1, "cameraMatrix1").mat(),
                        ArrayMat(cameraMatrix2, "cameraMatrix2").mat(), ArrayMat(distCoeffs1, "distCoeffs1").mat(),
                        ArrayMat(distCoeffs2, "distCoeffs2").mat());
}

//! Sets a flag while it lives. It is destroyed with the interpreter's lock held.
class Running
{
public:
    explicit Running(bool& flag_) : flag(flag_) { flag = true; }
    ~Running() { flag = false; }

private:
    bool& flag;
    Running(const Running&);
    Running& operator=(const Running&);
};

}  // namespace

PythonUsac::PythonUsac(int problem, const py::object& points1, const py::object& points2, const Params& params,
                       const py::object& cameraMatrix1, const py::object& cameraMatrix2, const py::object& distCoeffs1,
                       const py::object& distCoeffs2)
    : usac(create(problem, points1, points2, params, cameraMatrix1, cameraMatrix2, distCoeffs1, distCoeffs2)),
      ownSampler(usac->components().sampler), ownScore(usac->components().score), running(false)
{}

//! The object is for one thread at a time, and a component must not change what it is part of.
void PythonUsac::checkIdle(const char* what) const
{
    if (running)
        CV_Error_(Error::StsError, ("%s: the estimation is running", what));
}

void PythonUsac::setSampler(const py::object& sampler)
{
    checkIdle("components.sampler");
    usac->components().sampler = sampler.is_none() ? ownSampler : Ptr<Sampler>(makePtr<PythonSampler>(sampler));
}

void PythonUsac::setScore(const py::object& score)
{
    checkIdle("components.score");
    usac->components().score = score.is_none() ? ownScore : Ptr<Score>(makePtr<PythonScore>(score));
}

void PythonUsac::setPoints(const py::object& points1, const py::object& points2)
{
    checkIdle("setPoints");
    usac->setPoints(ArrayMat(points1, "points1").mat(), ArrayMat(points2, "points2").mat());
}

py::tuple PythonUsac::points() const
{
    return fieldsOf(usac->points(), usac->components().minimalSolver->sampleSize());
}

py::tuple PythonUsac::run()
{
    checkIdle("run");
    const Running guard(running);
    Mat model, mask;
    Report report;
    {
        const Unlocked unlocked;
        model = usac->run(mask, &report);
    }
    const std::vector<py::ssize_t> none = {0, 1};
    return py::make_tuple(arrayOf(model), mask.empty() ? py::object(py::array_t<uchar>(none)) : arrayOf(mask), report);
}

void addUsac(py::module_& module)
{
    py::class_<PythonUsac>(module, "Usac")
        .def(py::init<int, const py::object&, const py::object&, const Params&, const py::object&, const py::object&,
                      const py::object&, const py::object&>())
        .def("setSampler", &PythonUsac::setSampler, py::arg("sampler"))
        .def("setScore", &PythonUsac::setScore, py::arg("score"))
        .def("setPoints", &PythonUsac::setPoints, py::arg("points1"), py::arg("points2"))
        .def("points", &PythonUsac::points)
        .def("run", &PythonUsac::run);
}

}  // namespace python
}  // namespace usacv20
}  // namespace cv
