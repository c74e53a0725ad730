// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PYTHON_ARRAYS_HPP
#define OPENCV_USACV20_PYTHON_ARRAYS_HPP

#include "native.hpp"

namespace cv {
namespace usacv20 {
namespace python {

/** @brief A cv::Mat of an array of NumPy's, in the form that cv2 gives it: rows and columns, of
three dimensions the last one is the channels. The numbers are those of the array where its layout
is one that cv::Mat has, else a copy. The array must have numbers of a type that cv::Mat has, in the
order of bytes of this machine. */
class ArrayMat
{
public:
    //! None: an empty matrix. @param name of the argument, for messages
    ArrayMat(const py::object& array, const char* name);

    //! The matrix; as long as this object lives, and nobody else changes the array.
    const Mat& mat() const { return matrix; }
    //! The same with numbers of its own, for use without the interpreter's lock.
    Mat own() const { return matrix.clone(); }

private:
    py::object owner;
    Mat matrix;
};

//! An array with a copy of the numbers; None if the matrix is empty.
py::object arrayOf(const Mat& mat);

}  // namespace python
}  // namespace usacv20
}  // namespace cv

#endif
