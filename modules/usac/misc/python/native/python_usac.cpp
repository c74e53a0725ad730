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

//! Sets a flag to true during the lifetime of this object. The object must be destroyed while the
//! interpreter's lock is held.
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

PythonUsac::PythonUsac(int problem_, const py::object& points1, const py::object& points2,
                       const Params& params_, const py::object& cameraMatrix1,
                       const py::object& cameraMatrix2, const py::object& distCoeffs1,
                       const py::object& distCoeffs2)
    : problem((ProblemType)problem_), K1(own(cameraMatrix1, "cameraMatrix1")),
      K2(own(cameraMatrix2, "cameraMatrix2")), d1(own(distCoeffs1, "distCoeffs1")),
      d2(own(distCoeffs2, "distCoeffs2")), running(false)
{
    build(own(points1, "points1"), own(points2, "points2"), params_);
}

void PythonUsac::build(const Mat& points1, const Mat& points2, const Params& options)
{
    const Ptr<Usac> made = Usac::create(problem, points1, points2, options, K1, K2, d1, d2);
    Components& parts = made->components();
    const Ptr<Sampler> sampler = parts.sampler;
    const Ptr<Score> score = parts.score;
    if (usac && usac->components().sampler != ownSampler)
        parts.sampler = usac->components().sampler;
    if (usac && usac->components().score != ownScore)
        parts.score = usac->components().score;
    usac = made;
    ownSampler = sampler;
    ownScore = score;
    params = options;
    first = points1;
    second = points2;
}

//! Raises cv::Exception during a run: the object must be used by one thread at a time, and a
//! component must not change the estimator that calls it.
void PythonUsac::checkIdle(const char* what) const
{
    if (running)
        CV_Error_(Error::StsError, ("%s: the estimation is running", what));
}

void PythonUsac::setSampler(const py::object& sampler)
{
    checkIdle("components.sampler");
    usac->components().sampler = sampler.is_none() ? ownSampler
                                                   : Ptr<Sampler>(makePtr<PythonSampler>(sampler));
}

void PythonUsac::setScore(const py::object& score)
{
    checkIdle("components.score");
    usac->components().score = score.is_none() ? ownScore : Ptr<Score>(makePtr<PythonScore>(score));
}

void PythonUsac::setPoints(const py::object& points1, const py::object& points2)
{
    checkIdle("setPoints");
    const Mat points1Read = own(points1, "points1"), points2Read = own(points2, "points2");
    usac->setPoints(points1Read, points2Read);
    first = points1Read;
    second = points2Read;
}

void PythonUsac::renew(const py::object& points1, const py::object& points2, const Params& options)
{
    checkIdle("params");
    build(points1.is_none() ? first : own(points1, "points1"),
          points2.is_none() ? second : own(points2, "points2"), options);
}

py::tuple PythonUsac::points() const
{
    return fieldsOf(usac->points(), usac->components().minimalSolver->sampleSize(), params.scores);
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
    return py::make_tuple(arrayOf(model),
                          mask.empty() ? py::object(py::array_t<uchar>(none)) : arrayOf(mask),
                          report);
}

void addUsac(py::module_& module)
{
    py::class_<PythonUsac>(module, "Usac")
        .def(py::init<int, const py::object&, const py::object&, const Params&, const py::object&,
                      const py::object&, const py::object&, const py::object&>())
        .def("setSampler", &PythonUsac::setSampler, py::arg("sampler"))
        .def("setScore", &PythonUsac::setScore, py::arg("score"))
        .def("setPoints", &PythonUsac::setPoints, py::arg("points1"), py::arg("points2"))
        .def("renew", &PythonUsac::renew, py::arg("points1"), py::arg("points2"), py::arg("params"))
        .def("points", &PythonUsac::points)
        .def("run", &PythonUsac::run);
}

}  // namespace python
}  // namespace usacv20
}  // namespace cv
