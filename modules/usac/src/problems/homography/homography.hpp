// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_HOMOGRAPHY_HPP
#define OPENCV_USACV20_HOMOGRAPHY_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

//! Creates a HomographyProblem.
Ptr<Problem> createHomographyProblem();
//! Creates the 4-point solver, see Homography4Solver.
Ptr<MinimalSolver> createHomography4Solver();
//! Creates the least-squares fit of a homography.
Ptr<NonMinimalSolver> createHomographyFit(const Ptr<Residual>& residual);
//! Creates the check for inconsistently oriented samples and for near-singular models, see
//! HomographyOrientation.
Ptr<Degeneracy> createHomographyOrientation();

}  // namespace usacv20
}  // namespace cv

#endif
