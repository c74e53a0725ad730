// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_HOMOGRAPHY_HPP
#define OPENCV_USACV20_HOMOGRAPHY_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

//! See HomographyProblem.
Ptr<Problem> createHomographyProblem();
//! From 4 points, see Homography4Solver.
Ptr<MinimalSolver> createHomography4Solver();
//! Least squares of a residual.
Ptr<NonMinimalSolver> createHomographyFit(const Ptr<Residual>& residual);
//! Orientation of the sample, near-singular models; see HomographyOrientation.
Ptr<Degeneracy> createHomographyOrientation();

}  // namespace usacv20
}  // namespace cv

#endif
