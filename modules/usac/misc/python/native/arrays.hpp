// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PYTHON_ARRAYS_HPP
#define OPENCV_USACV20_PYTHON_ARRAYS_HPP

#include "native.hpp"

namespace cv {
namespace usacv20 {
namespace python {

/** @brief A NumPy array as a cv::Mat of the same form as in cv2: rows and columns; a third
dimension becomes the channels. The matrix shares the array's memory if a cv::Mat can have its
layout; otherwise the matrix is a copy. The array must be in native byte order and have a number
type of OpenCV 4's cv::Mat, but not 16-bit floats. */
class ArrayMat
{
public:
    //! None gives an empty matrix. @param name name of the argument, for messages
    ArrayMat(const py::object& array, const char* name);

    //! The matrix, which is valid only during the lifetime of this object. If it shares the array's
    //! memory, changes of the array also change the matrix.
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

//! A NumPy array with a copy of the matrix; None if the matrix is empty.
py::object arrayOf(const Mat& mat);

}  // namespace python
}  // namespace usacv20
}  // namespace cv

#endif
