// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_ESSENTIAL_HPP
#define OPENCV_USACV20_ESSENTIAL_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

//! Creates an EssentialProblem. The arguments are the camera arguments of #estimateEssential.
Ptr<Problem> createEssentialProblem(InputArray cameraMatrix1, InputArray cameraMatrix2,
                                    InputArray distCoeffs1, InputArray distCoeffs2);
//! Creates the 5-point solver, see Essential5Solver.
Ptr<MinimalSolver> createEssential5Solver();
//! Creates the least-squares fit of an essential matrix.
Ptr<NonMinimalSolver> createEssentialFit(const Ptr<Residual>& residual);
//! Creates the check for scenes dominated by a plane, see PlanarMotion.
Ptr<Degeneracy> createPlanarMotion();

}  // namespace usacv20
}  // namespace cv

#endif
