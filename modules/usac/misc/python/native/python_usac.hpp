// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PYTHON_PYTHON_USAC_HPP
#define OPENCV_USACV20_PYTHON_PYTHON_USAC_HPP

#include "native.hpp"

namespace cv {
namespace usacv20 {
namespace python {

//! An estimation with components that can be replaced by some that are written in Python.
class PythonUsac
{
public:
    PythonUsac(int problem, const py::object& points1, const py::object& points2, const Params& params,
               const py::object& cameraMatrix1, const py::object& cameraMatrix2, const py::object& distCoeffs1,
               const py::object& distCoeffs2);

    //! None: the one of the options.
    void setSampler(const py::object& sampler);
    void setScore(const py::object& score);
    void setPoints(const py::object& points1, const py::object& points2);
    py::tuple points() const;
    //! @return model, mask, report; without the interpreter's lock, which components in Python take.
    py::tuple run();

private:
    void checkIdle(const char* what) const;

    Ptr<Usac> usac;
    const Ptr<Sampler> ownSampler;
    const Ptr<Score> ownScore;
    bool running;  //!< guarded by the interpreter's lock
};

}  // namespace python
}  // namespace usacv20
}  // namespace cv

#endif
