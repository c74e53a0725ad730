// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TRANSLATION_HPP
#define OPENCV_USACV20_TRANSLATION_HPP

#include "problems/two_view/plane_parameterization.hpp"

namespace cv {
namespace usacv20 {

//! The parameters of a translation with the rows (1 0 x) and (0 1 y): x, y.
struct TranslationMap
{
    enum { DIMENSION = 2 };

    //! Reads the translation that maps the origin to the same point as the map `m` does. In
    //! normalized coordinates, the origin is the center of the points in image 1.
    static void read(const double* m, double* p)
    {
        p[0] = m[2];
        p[1] = m[5];
    }
    static void write(const double* p, double* m)
    {
        m[0] = m[4] = 1;
        m[1] = m[3] = 0;
        m[2] = p[0];
        m[5] = p[1];
    }
    static bool isRegular(const double*) { return true; }
};

typedef PlaneParameterization<TranslationMap> TranslationParameterization;

//! Creates the problem of a translation from image 1 to image 2.
Ptr<Problem> createTranslation2DProblem();
//! Creates the 1-point solver, see Translation1Solver.
Ptr<MinimalSolver> createTranslation1Solver();
//! Creates the fit that minimizes the sum of squared transfer errors in closed form.
Ptr<NonMinimalSolver> createTranslationLeastSquares();

}  // namespace usacv20
}  // namespace cv

#endif
