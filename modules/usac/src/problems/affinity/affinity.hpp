// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_AFFINITY_HPP
#define OPENCV_USACV20_AFFINITY_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

//! Affine map from image 1 to image 2, as for a plane that is small or far from the camera.
Ptr<Problem> createAffinity2DProblem();
//! From 3 points, see Affinity3Solver.
Ptr<MinimalSolver> createAffinity3Solver();
//! Least squares of the transfer error, in closed form.
Ptr<NonMinimalSolver> createAffinityLeastSquares();

}  // namespace usacv20
}  // namespace cv

#endif
