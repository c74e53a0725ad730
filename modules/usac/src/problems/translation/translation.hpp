// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TRANSLATION_HPP
#define OPENCV_USACV20_TRANSLATION_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

//! Translation from image 1 to image 2.
Ptr<Problem> createTranslation2DProblem();
//! From 1 point, see Translation1Solver.
Ptr<MinimalSolver> createTranslation1Solver();
//! Least squares of the transfer error, in closed form.
Ptr<NonMinimalSolver> createTranslationLeastSquares();

}  // namespace usacv20
}  // namespace cv

#endif
