// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SIMILARITY_HPP
#define OPENCV_USACV20_SIMILARITY_HPP

#include "problems/two_view/plane_parameterization.hpp"

namespace cv {
namespace usacv20 {

//! The parameters of a similarity with the rows (a -b x) and (b a y): a, b, x, y.
struct SimilarityMap
{
    enum { DIMENSION = 4 };

    //! Averages the entries of `m` that are equal, up to the sign, in a similarity.
    static void read(const double* m, double* p)
    {
        p[0] = (m[0] + m[4]) / 2;
        p[1] = (m[3] - m[1]) / 2;
        p[2] = m[2];
        p[3] = m[5];
    }
    static void write(const double* p, double* m)
    {
        m[0] = m[4] = p[0];
        m[1] = -p[1];
        m[3] = p[1];
        m[2] = p[2];
        m[5] = p[3];
    }
    static bool isRegular(const double* p) { return p[0] != 0 || p[1] != 0; }
};

typedef PlaneParameterization<SimilarityMap> SimilarityParameterization;

//! Creates the problem of a rotation, uniform scale and translation from image 1 to image 2.
Ptr<Problem> createSimilarity2DProblem();
//! Creates the 2-point solver, see Similarity2Solver.
Ptr<MinimalSolver> createSimilarity2Solver();
//! Creates the fit that minimizes the sum of squared transfer errors in closed form.
Ptr<NonMinimalSolver> createSimilarityLeastSquares();

}  // namespace usacv20
}  // namespace cv

#endif
