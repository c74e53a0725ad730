// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PYTHON_CORRESPONDENCES_HPP
#define OPENCV_USACV20_PYTHON_CORRESPONDENCES_HPP

#include "native.hpp"

namespace cv {
namespace usacv20 {
namespace python {

//! The fields of the package's class Correspondences; all arrays are copies. `scores` is
//! Params::scores as given by the caller; it is passed separately, because Correspondences::scores
//! is negated if higher scores are better.
py::tuple fieldsOf(const Correspondences& points, int sampleSize, const std::vector<float>& scores);

}  // namespace python
}  // namespace usacv20
}  // namespace cv

#endif
