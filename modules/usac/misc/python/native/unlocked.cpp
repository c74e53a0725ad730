// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "unlocked.hpp"
#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

namespace cv {
namespace usacv20 {
namespace python {

namespace {

//! Minimum number of milliseconds between two checks for signals. The checks are rare, because
//! acquiring the interpreter's lock can take 5 ms if other Python threads run.
constexpr double PERIOD = 50;

//! Maximum number of seconds for which the end of the interpreter waits for canceled estimations.
//! Only a component written in Python can take so long.
constexpr double PATIENCE = 5;

//! Number of estimations in other threads than the main thread; used while the lock is held.
int others = 0;
//! True when the interpreter ends.
std::atomic<bool> ending(false);

//! Cancels the estimations of other threads and waits for their end.
void end()
{
    ending = true;
    const int64 start = getTickCount();
    while (others > 0 && (getTickCount() - start) / getTickFrequency() < PATIENCE)
    {
        const py::gil_scoped_release unlocked;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

//! Waits until the process ends.
void waitForever()
{
    const py::gil_scoped_release unlocked;
    for (;;)
        std::this_thread::sleep_for(std::chrono::hours(1));
}

bool isMainThread()
{
    const py::module_ threading = py::module_::import("threading");
    return threading.attr("main_thread")().is(threading.attr("current_thread")());
}

//! Lets Python handle signals, at intervals of at least PERIOD. Throws the exception of a signal
//! handler.
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

/** The implementation of the context manager usacv20.progress, which applies to the thread that
calls enter(), until this thread calls leave(). */
class PythonProgress
{
public:
    explicit PythonProgress(const py::object& function)
        : asked(std::make_shared<Asked>(function)), depth(0)
    {}

    //! If leave() was not called and another thread destroys this object, the scope cannot be
    //! removed from the thread that called enter(). The scope then stays there without effect.
    ~PythonProgress()
    {
        if (scope && thread != std::this_thread::get_id())
        {
            asked->left = true;
            scope.release();
        }
    }

    void enter()
    {
        if (scope)
            CV_Error(Error::StsError, "progress: this object is already in use");
        thread = std::this_thread::get_id();
        const std::shared_ptr<Asked> shared = asked;
        scope.reset(new ProgressScope([shared](const Report& report) {
            if (shared->left)
                return true;
            const Depth deeper;
            const py::gil_scoped_acquire locked;
            return shared->function(report).cast<bool>();
        }));
        depth = Depth::current;
    }

    void leave()
    {
        if (scope && thread != std::this_thread::get_id())
            CV_Error(Error::StsError, "progress: it has to be left by the thread that entered it");
        if (scope && depth != Depth::current)
            CV_Error(Error::StsError, "progress: it cannot be left by a progress function that a "
                                      "running estimation calls");
        scope.reset();
    }

private:
    //! The progress function that the scope calls. `left` true: it is no longer called.
    struct Asked
    {
        explicit Asked(const py::object& function_) : function(function_), left(false) {}
        const py::object function;
        std::atomic<bool> left;
    };

    //! Counts the progress functions that are running in this thread, one inside another.
    struct Depth
    {
        Depth() { ++current; }
        ~Depth() { --current; }
        static thread_local int current;
    };

    const std::shared_ptr<Asked> asked;
    std::unique_ptr<ProgressScope> scope;
    std::thread::id thread;
    int depth;  //!< Depth::current when the scope was made
};

thread_local int PythonProgress::Depth::current = 0;

}  // namespace

Unlocked::Unlocked()
    : inMain(isMainThread()),
      scope(inMain ? Progress(Signals()) : [](const Report&) { return !ending; })
{
    if (!inMain && ending)
        waitForever();
    others += !inMain;
    released.reset(new py::gil_scoped_release);
}

Unlocked::~Unlocked()
{
    released.reset();
    others -= !inMain;
}

void addProgress(py::module_& module)
{
    py::class_<PythonProgress>(module, "Progress")
        .def(py::init<const py::object&>(), py::arg("function"))
        .def("enter", &PythonProgress::enter)
        .def("leave", &PythonProgress::leave);
    py::module_::import("atexit").attr("register")(py::cpp_function(&end));
    const py::module_ os = py::module_::import("os");
    if (py::hasattr(os, "register_at_fork"))  // the other threads do not exist in the child
        os.attr("register_at_fork")(
            py::arg("after_in_child") = py::cpp_function([] { others = 0; }));
}

}  // namespace python
}  // namespace usacv20
}  // namespace cv
