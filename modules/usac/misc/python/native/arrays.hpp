// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PYTHON_ARRAYS_HPP
#define OPENCV_USACV20_PYTHON_ARRAYS_HPP

#include "native.hpp"

namespace cv {
namespace usacv20 {
namespace python {

/** @brief A cv::Mat of a NumPy array in the form that cv2 gives it: rows and columns; a third
dimension becomes the channels. The matrix shares the array's memory if a cv::Mat can have its
layout; otherwise it is a copy. The array must have a type of numbers that cv::Mat has, in native
byte order. */
class ArrayMat
{
public:
    //! None gives an empty matrix. @param name name of the argument, for messages
    ArrayMat(const py::object& array, const char* name);

    //! The matrix. It is valid while this object lives and nobody changes the array.
    const Mat& mat() const { return matrix; }
    //! A copy of the matrix, for use without the interpreter's lock.
    Mat own() const { return matrix.clone(); }

private:
    py::object owner;
    Mat matrix;
};

//! A copy of an array, for use without the interpreter's lock.
inline Mat own(const py::handle& array, const char* name)
{
    return ArrayMat(py::reinterpret_borrow<py::object>(array), name).own();
}

//! A NumPy array with a copy of the matrix; None if it is empty.
py::object arrayOf(const Mat& mat);

}  // namespace python
}  // namespace usacv20
}  // namespace cv

#endif
