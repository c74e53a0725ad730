// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PROBLEMS_HPP
#define OPENCV_USACV20_PROBLEMS_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

/** @brief Creates the problem of a type. A new problem needs its folder, its enumerator and one
line in this function. Camera arguments as for Usac::create. */
Ptr<Problem> createProblem(ProblemType type, InputArray cameraMatrix1, InputArray cameraMatrix2,
                           InputArray distCoeffs1, InputArray distCoeffs2);

}  // namespace usacv20
}  // namespace cv

#endif
