// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_REGISTRY_HPP
#define OPENCV_USACV20_REGISTRY_HPP

// The rows of registry.inl.hpp generate the factory of all problems (registry.cpp). From the same
// rows, misc/python/make_names.py generates the functions in Python; it also compares the rows with
// the public headers. Tests take their lists of problems from these rows.

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

/** @brief Creates the problem of a type. The camera arguments are those of Usac::create. Raises
cv::Exception for a number that is not a ProblemType. */
Ptr<Problem> createProblem(ProblemType type, InputArray cameraMatrix1, InputArray cameraMatrix2,
                           InputArray distCoeffs1, InputArray distCoeffs2);

}  // namespace usacv20
}  // namespace cv

#endif
