// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PYTHON_PYTHON_USAC_HPP
#define OPENCV_USACV20_PYTHON_PYTHON_USAC_HPP

#include "native.hpp"

namespace cv {
namespace usacv20 {
namespace python {

//! An estimation in which Python code can replace components.
class PythonUsac
{
public:
    PythonUsac(int problem, const py::object& points1, const py::object& points2,
               const Params& params, const py::object& cameraMatrix1,
               const py::object& cameraMatrix2, const py::object& distCoeffs1,
               const py::object& distCoeffs2);

    //! Replaces a component; None restores the component that the options select. The estimator
    //! keeps a reference that Python's garbage collector cannot see. Therefore the package passes
    //! weak proxies, and its class Components keeps the components alive.
    void setSampler(const py::object& sampler);
    void setScore(const py::object& score);
    void setPoints(const py::object& points1, const py::object& points2);
    //! Sets other options, and other points unless they are None. Components written in Python are
    //! kept. If an argument is wrong, an exception is raised and nothing changes.
    void renew(const py::object& points1, const py::object& points2, const Params& params);
    py::tuple points() const;
    //! Runs without the interpreter's lock; components written in Python acquire the lock when they
    //! are called. @return model, mask, report
    py::tuple run();

private:
    void checkIdle(const char* what) const;
    void build(const Mat& points1, const Mat& points2, const Params& options);

    const ProblemType problem;
    const Mat K1, K2, d1, d2;
    Mat first, second;  //!< points, kept for renew()
    Params params;
    Ptr<Usac> usac;
    Ptr<Sampler> ownSampler;  //!< sampler that the options select
    Ptr<Score> ownScore;      //!< score that the options select
    bool running;             //!< read and written only while the interpreter's lock is held
};

}  // namespace python
}  // namespace usacv20
}  // namespace cv

#endif
