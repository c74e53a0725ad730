// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PYTHON_PYTHON_SCORE_HPP
#define OPENCV_USACV20_PYTHON_PYTHON_SCORE_HPP

#include "native.hpp"

namespace cv {
namespace usacv20 {
namespace python {

/** @brief A score that calls a Python object of the package's class Score. Several threads can call
accumulate() at the same time; each call acquires the interpreter's lock. Exceptions are passed on
as in PythonSampler. */
class PythonScore : public Score
{
public:
    explicit PythonScore(const py::object& score);
    virtual ~PythonScore();

    void start(const Context& context) CV_OVERRIDE;
    void accumulate(float* squaredErrors, int count, float squaredThreshold,
                    Quality& sum) const CV_OVERRIDE;
    bool wholeModel() const CV_OVERRIDE { return whole; }
    double inlierPart() const CV_OVERRIDE { return part; }

private:
    py::object score;
    const bool whole;
    const double part;
};

}  // namespace python
}  // namespace usacv20
}  // namespace cv

#endif
