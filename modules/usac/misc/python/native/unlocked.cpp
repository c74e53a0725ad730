// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "unlocked.hpp"
#include <thread>

namespace cv {
namespace usacv20 {
namespace python {

namespace {

//! Milliseconds between two checks for signals. While other Python threads run, taking the lock may
//! need up to 5 ms.
constexpr double PERIOD = 50;

bool isMainThread()
{
    const py::module_ threading = py::module_::import("threading");
    return threading.attr("main_thread")().is(threading.attr("current_thread")());
}

//! Asks Python, at intervals of at least PERIOD, whether a signal has arrived.
class Signals
{
public:
    Signals() : looked(getTickCount()) {}

    bool operator()(const Report&)
    {
        if ((getTickCount() - looked) / getTickFrequency() * 1e3 < PERIOD)
            return true;
        const py::gil_scoped_acquire locked;
        if (PyErr_CheckSignals() != 0)
            throw py::error_already_set();
        looked = getTickCount();
        return true;
    }

private:
    int64 looked;
};

/** The context manager behind usacv20.progress. It applies to the thread that enters it, until that
thread leaves it. */
class PythonProgress
{
public:
    explicit PythonProgress(const py::object& function_) : function(function_) {}

    void enter()
    {
        if (scope)
            CV_Error(Error::StsError, "progress: it is in use");
        thread = std::this_thread::get_id();
        scope.reset(new ProgressScope([this](const Report& report) {
            const py::gil_scoped_acquire locked;
            return function(report).cast<bool>();
        }));
    }

    void leave()
    {
        if (scope && thread != std::this_thread::get_id())
            CV_Error(Error::StsError, "progress: it has to be left by the thread that entered it");
        scope.reset();
    }

private:
    const py::object function;
    std::unique_ptr<ProgressScope> scope;
    std::thread::id thread;
};

}  // namespace

Unlocked::Unlocked() : scope(isMainThread() ? new ProgressScope(Signals()) : 0), released() {}

void addProgress(py::module_& module)
{
    py::class_<PythonProgress>(module, "Progress")
        .def(py::init<const py::object&>(), py::arg("function"))
        .def("enter", &PythonProgress::enter)
        .def("leave", &PythonProgress::leave);
}

}  // namespace python
}  // namespace usacv20
}  // namespace cv
