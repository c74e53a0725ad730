// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SIMILARITY_HPP
#define OPENCV_USACV20_SIMILARITY_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

//! Rotation, uniform scale and translation from image 1 to image 2.
Ptr<Problem> createSimilarity2DProblem();
//! From 2 points, see Similarity2Solver.
Ptr<MinimalSolver> createSimilarity2Solver();
//! Least squares of the transfer error, in closed form.
Ptr<NonMinimalSolver> createSimilarityLeastSquares();

}  // namespace usacv20
}  // namespace cv

#endif
