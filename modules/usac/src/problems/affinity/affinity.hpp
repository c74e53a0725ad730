// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_AFFINITY_HPP
#define OPENCV_USACV20_AFFINITY_HPP

#include "problems/two_view/plane_parameterization.hpp"

namespace cv {
namespace usacv20 {

//! The parameters of an affine map: the entries of its first two rows.
struct AffinityMap
{
    enum { DIMENSION = 6 };

    static void read(const double* m, double* p) { std::copy(m, m + 6, p); }
    static void write(const double* p, double* m) { std::copy(p, p + 6, m); }
    static bool isRegular(const double* p)
    {
        // A determinant of the linear part that is at most this fraction of the sum of the squared
        // entries can be due to rounding alone.
        const double LEAST_DETERMINANT = 1e-9;
        const double a = p[0], b = p[1], c = p[3], d = p[4];
        return std::abs(a * d - b * c) > LEAST_DETERMINANT * (a * a + b * b + c * c + d * d);
    }
};

typedef PlaneParameterization<AffinityMap> AffinityParameterization;

//! Creates the problem of an affine map from image 1 to image 2. Such a map approximates the
//! homography of a planar surface that is small compared with its distance from the cameras.
Ptr<Problem> createAffinity2DProblem();
//! Creates the 3-point solver, see Affinity3Solver.
Ptr<MinimalSolver> createAffinity3Solver();
//! Creates the fit that minimizes the sum of squared transfer errors in closed form.
Ptr<NonMinimalSolver> createAffinityLeastSquares();

}  // namespace usacv20
}  // namespace cv

#endif
