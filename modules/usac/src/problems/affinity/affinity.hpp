// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_AFFINITY_HPP
#define OPENCV_USACV20_AFFINITY_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

//! See AffinityProblem.
Ptr<Problem> createAffinityProblem();
//! From 3 points, see Affinity3Solver.
Ptr<MinimalSolver> createAffinity3Solver();
//! Least squares of a residual: in closed form for the transfer error, else a LeastSquaresSolver.
Ptr<NonMinimalSolver> createAffinityFit(const Ptr<Residual>& residual);
//! Least squares of the transfer error.
Ptr<NonMinimalSolver> createAffinityLeastSquares();

}  // namespace usacv20
}  // namespace cv

#endif
