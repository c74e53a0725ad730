// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_ABSOLUTE_POSE_HPP
#define OPENCV_USACV20_ABSOLUTE_POSE_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

//! Creates an AbsolutePoseProblem. The arguments are the camera arguments of cv::solvePnP.
Ptr<Problem> createAbsolutePoseProblem(InputArray cameraMatrix, InputArray distCoeffs);
/** @brief Creates the 3-point solver of the pose, see P3PSolver.
@param camera camera matrix whose last row and last column are 0 0 1; models are `camera` [R t] */
Ptr<MinimalSolver> createP3PSolver(const Matx33d& camera = Matx33d::eye());
//! Creates the least-squares fit of a pose; models are `camera` [R t].
Ptr<NonMinimalSolver> createPoseFit(const Ptr<Residual>& residual, const Matx33d& camera);
//! Creates the check for the second pose of a plane, see SecondPose; models are `camera` [R t].
Ptr<Degeneracy> createSecondPose(const Matx33d& camera);

}  // namespace usacv20
}  // namespace cv

#endif
