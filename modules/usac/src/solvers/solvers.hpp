// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SOLVERS_HPP
#define OPENCV_USACV20_SOLVERS_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! Homography from 4 points, see Homography4Solver.
Ptr<MinimalSolver> createHomography4Solver();
//! Fundamental matrices from 7 points, see Fundamental7Solver.
Ptr<MinimalSolver> createFundamental7Solver();
//! Essential matrices from 5 points, see Essential5Solver.
Ptr<MinimalSolver> createEssential5Solver();
//! Least squares of a geometric error from a starting model, see LeastSquaresSolver.
Ptr<NonMinimalSolver> createLeastSquaresSolver(ProblemType problem, Residual::Kind kind);

} // namespace usacv20
} // namespace cv

#endif
