// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PYTHON_PYTHON_SAMPLER_HPP
#define OPENCV_USACV20_PYTHON_PYTHON_SAMPLER_HPP

#include "native.hpp"

namespace cv {
namespace usacv20 {
namespace python {

/** @brief A sampler that calls a Python object of the package's class Sampler. The methods acquire
the interpreter's lock. A Python exception passes through the search as py::error_already_set and
reaches the caller unchanged. */
class PythonSampler : public Sampler
{
public:
    explicit PythonSampler(const py::object& sampler);
    virtual ~PythonSampler();

    void start(const Context& context) CV_OVERRIDE;
    void sample(const Context& context, State& state, int* sample) CV_OVERRIDE;

private:
    //! `rng` is the Python object with which Python code uses the random number generator of the
    //! current iteration.
    py::object sampler, rng;
    int sampleSize;
};

}  // namespace python
}  // namespace usacv20
}  // namespace cv

#endif
