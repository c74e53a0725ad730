// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_RIGID_MOTION_HPP
#define OPENCV_USACV20_RIGID_MOTION_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

//! Creates the problem of a rotation and translation of space, see RigidMotionProblem.
Ptr<Problem> createRigid3DProblem();
//! Creates the problem of a rotation, translation and uniform scale of space, see
//! RigidMotionProblem.
Ptr<Problem> createSimilarity3DProblem();
//! Creates the 3-point solver, see TriangleSolver. If `scaled` is false, the scale is 1.
Ptr<MinimalSolver> createTriangleSolver(bool scaled);
//! Creates a least-squares fit: in closed form for SpaceTransferError, otherwise iterative.
Ptr<NonMinimalSolver> createRigidFit(const Ptr<Residual>& residual, bool scaled);
//! Creates the closed-form fit of a motion that minimizes the sum of squared distances in space 2,
//! see RigidLeastSquares.
Ptr<NonMinimalSolver> createRigidLeastSquares(bool scaled);

}  // namespace usacv20
}  // namespace cv

#endif
