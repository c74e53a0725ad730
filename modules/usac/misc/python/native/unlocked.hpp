// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PYTHON_UNLOCKED_HPP
#define OPENCV_USACV20_PYTHON_UNLOCKED_HPP

#include <memory>
#include "native.hpp"

namespace cv {
namespace usacv20 {
namespace python {

/** @brief While an object exists, the interpreter's lock is released, and estimations can be
interrupted.

Estimations of the main thread, where Python handles signals, check for signals regularly. An
exception of a signal handler, such as KeyboardInterrupt, passes through the estimation as
py::error_already_set. Estimations of other threads are canceled when the interpreter ends, which
waits for them: Python ends a daemon thread when it next acquires the lock, and this would abort the
process if a function of C++ was running in the thread. */
class Unlocked
{
public:
    Unlocked();
    ~Unlocked();

private:
    const bool inMain;
    const ProgressScope scope;
    std::unique_ptr<py::gil_scoped_release> released;

    Unlocked(const Unlocked&);
    Unlocked& operator=(const Unlocked&);
};

}  // namespace python
}  // namespace usacv20
}  // namespace cv

#endif
