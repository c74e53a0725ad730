// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PYOPENCV_USAC_HPP
#define OPENCV_USACV20_PYOPENCV_USAC_HPP

#ifdef HAVE_OPENCV_USAC

//! Makes "cv2.usacv20.Report(cost=0.25, degenerate=False, ...)" from all attributes of an object
//! except methods and names that begin with an underscore.
static PyObject* pyopencv_usacv20_repr(PyObject* self, const char* type)
{
    PySafeObject names(PyObject_Dir(self));
    const Py_ssize_t count = (PyObject*)names ? PyList_Size(names) : 0;
    std::string text;
    for (Py_ssize_t i = 0; i < count; ++i)
    {
        std::string name, value;
        PySafeObject attribute(PyObject_GetAttr(self, PyList_GetItem(names, i)));
        if (!(PyObject*)attribute || !getUnicodeString(PyList_GetItem(names, i), name))
            return NULL;
        if (name[0] == '_' || PyCallable_Check(attribute))
            continue;
        if (PySequence_Check(attribute) && PySequence_Size(attribute) > 0)
            value = cv::format("<%d values>", (int)PySequence_Size(attribute));
        else if (PySequence_Check(attribute))
            value = "()";
        else if (!getUnicodeString(PySafeObject(PyObject_Repr(attribute)), value))
            return NULL;
        text += (text.empty() ? "" : ", ") + name + "=" + value;
    }
    return PyString_FromString(cv::format("cv2.usacv20.%s(%s)", type, text.c_str()).c_str());
}

static PyObject* pyopencv_usacv20_Params_fields(PyObject* self)
{
    return pyopencv_usacv20_repr(self, "Params");
}

static PyObject* pyopencv_usacv20_Report_fields(PyObject* self)
{
    return pyopencv_usacv20_repr(self, "Report");
}

// OpenCV's macros, which are used after this file, register pyopencv_<class>_repr as __repr__. Here
// these two names are replaced with those of the functions above.
#define pyopencv_usacv20_Params_repr pyopencv_usacv20_Params_fields
#define pyopencv_usacv20_Report_repr pyopencv_usacv20_Report_fields

#endif

#endif
