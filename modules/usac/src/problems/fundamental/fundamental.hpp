// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_FUNDAMENTAL_HPP
#define OPENCV_USACV20_FUNDAMENTAL_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

//! Creates a FundamentalProblem.
Ptr<Problem> createFundamentalProblem();
//! Creates the 7-point solver, see Fundamental7Solver.
Ptr<MinimalSolver> createFundamental7Solver();
//! Creates the least-squares fit of a fundamental matrix.
Ptr<NonMinimalSolver> createFundamentalFit(const Ptr<Residual>& residual);
//! Creates the check for samples dominated by a plane, see Degensac.
Ptr<Degeneracy> createDegensac();

}  // namespace usacv20
}  // namespace cv

#endif
