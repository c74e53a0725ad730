// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/homography/homography.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Three points count as collinear if twice the area of their triangle is at most this fraction of
//! the largest squared distance between the last point of the sample and one of its other points.
constexpr double COLLINEAR = 1e-6;

/** Computes the matrix B that maps the standard projective basis to four given points. Its columns
are the first three points in homogeneous coordinates, scaled so that their sum is a multiple of the
fourth point. False if three of the four points are collinear. */
bool fromBasis(const double* x, const double* y, const int* s, double* B)
{
    // the weights are determinants of point triples, that is, twice the signed areas of the
    // triangles
    const double x3 = x[s[3]], y3 = y[s[3]];
    double dx[3], dy[3];
    for (int k = 0; k < 3; ++k)
    {
        dx[k] = x[s[k]] - x3;
        dy[k] = y[s[k]] - y3;
    }
    const double w0 = dx[1] * dy[2] - dx[2] * dy[1];
    const double w1 = dx[2] * dy[0] - dx[0] * dy[2];
    const double w2 = dx[0] * dy[1] - dx[1] * dy[0];
    const double all = w0 + w1 + w2;  // twice the area of the triangle 0, 1, 2
    double extent = 0;
    for (int k = 0; k < 3; ++k)
        extent = std::max(extent, dx[k] * dx[k] + dy[k] * dy[k]);
    const double smallest = std::min(std::min(std::abs(w0), std::abs(w1)),
                                     std::min(std::abs(w2), std::abs(all)));
    if (!(smallest > COLLINEAR * extent))  // a NaN is rejected, too
        return false;
    const double w[3] = {w0, w1, w2};
    for (int k = 0; k < 3; ++k)
    {
        B[k] = w[k] * x[s[k]];
        B[3 + k] = w[k] * y[s[k]];
        B[6 + k] = w[k];
    }
    return true;
}

/** @brief The homography that maps four points exactly, in closed form.

The matrices B1 and B2 map the standard projective basis to the four points in image 1 and in image
2, see fromBasis(); H = B2 adj(B1), up to scale @cite hartley2003multiple. A sample with three
(nearly) collinear points or two equal points in either image is degenerate. The solver takes about
150 operations. */
class Homography4Solver : public MinimalSolver
{
public:
    int sampleSize() const CV_OVERRIDE { return 4; }

    int solve(const Correspondences& p, const int* sample, Model* models) const CV_OVERRIDE
    {
        double B1[9], B2[9];
        if (!fromBasis(p.exact[X1], p.exact[Y1], sample, B1) ||
            !fromBasis(p.exact[X2], p.exact[Y2], sample, B2))
            return 0;
        // rows of adj(B1) are cross products of the columns of B1
        const double adj[9] = {B1[4] * B1[8] - B1[5] * B1[7], B1[2] * B1[7] - B1[1] * B1[8],
                               B1[1] * B1[5] - B1[2] * B1[4], B1[5] * B1[6] - B1[3] * B1[8],
                               B1[0] * B1[8] - B1[2] * B1[6], B1[2] * B1[3] - B1[0] * B1[5],
                               B1[3] * B1[7] - B1[4] * B1[6], B1[1] * B1[6] - B1[0] * B1[7],
                               B1[0] * B1[4] - B1[1] * B1[3]};
        double squares = 0;
        Matx33d H;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
            {
                const double h = B2[3 * i] * adj[j] + B2[3 * i + 1] * adj[3 + j] +
                                 B2[3 * i + 2] * adj[6 + j];
                H(i, j) = h;
                squares += h * h;
            }
        if (!(squares >= DBL_MIN && squares <= DBL_MAX))
            return 0;
        models[0] = H * (1 / std::sqrt(squares));
        return 1;
    }
};

}  // namespace

Ptr<MinimalSolver> createHomography4Solver() { return makePtr<Homography4Solver>(); }

}  // namespace usacv20
}  // namespace cv
