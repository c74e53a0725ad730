// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "native.hpp"

namespace cv {
namespace usacv20 {
namespace python {

//! Raises usacv20.error in Python, with the attributes that cv2.error has.
static void raise(const cv::Exception& exception)
{
    try
    {
        using namespace py::literals;
        const py::object error = py::module_::import("usacv20._errors")
                                     .attr("fromNative")(
                                         exception.what(), "code"_a = (int)exception.code,
                                         "err"_a = exception.err, "file"_a = exception.file,
                                         "func"_a = exception.func, "line"_a = exception.line,
                                         "msg"_a = exception.msg);
        PyErr_SetObject((PyObject*)Py_TYPE(error.ptr()), error.ptr());
    }
    catch (py::error_already_set& failure)
    {
        failure.restore();
    }
}

void addErrors(py::module_&)
{
    py::register_local_exception_translator([](std::exception_ptr thrown) {
        try
        {
            if (thrown)
                std::rethrow_exception(thrown);
        }
        catch (const cv::Exception& exception)
        {
            raise(exception);
        }
    });
}

}  // namespace python
}  // namespace usacv20
}  // namespace cv
