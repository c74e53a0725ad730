// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "optimization/closest_rotation.hpp"
#include "problems/rigid_motion/rigid_motion.hpp"
#include "problems/rigid_motion/rigid_parameterization.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Points count as collinear if the second singular value of their cross-covariance matrix is at
//! most this fraction of the first one, because rounding alone can cause such a value.
constexpr double THINNEST = 1e-14;

Eigen::Vector3d pointOf(const double* const* columns, int i)
{
    return Eigen::Vector3d(columns[0][i], columns[1][i], columns[2][i]);
}

/** Weighted least squares of the distance in space 2, in closed form @cite umeyama1991least. The
rotation is the one closest to the cross-covariance matrix of the points in the two spaces. The
scale is 1 or, if `scaled` is true, the sum of the singular values of this matrix (the last one
negated if the determinant is negative) divided by the variance of the points in space 1. The mean
of the points in space 1 is mapped to that in space 2. Collinear points do not determine the
rotation, so that the fit fails: the second singular value is then at most #THINNEST times the
first. Coordinates are relative to the first point, so that little precision is lost if all points
are close together and far from the origin. */
class RigidLeastSquares : public NonMinimalSolver
{
public:
    explicit RigidLeastSquares(bool scaled_) : scaled(scaled_) {}

    bool fit(const Correspondences& points, const int* indices, int count, const double* weights,
             Model& model, int) const CV_OVERRIDE
    {
        if (count < 3)
            return false;
        const double *const *from = points.exact, *const *to = points.exact + 3;
        const Eigen::Vector3d first1 = pointOf(from, indices[0]), first2 = pointOf(to, indices[0]);
        Eigen::Vector3d sum1 = Eigen::Vector3d::Zero(), sum2 = sum1;
        Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
        double sum = 0, squares = 0;
        for (int i = 0; i < count; ++i)
        {
            const double w = weights ? weights[i] : 1;
            const Eigen::Vector3d x1 = pointOf(from, indices[i]) - first1,
                                  x2 = pointOf(to, indices[i]) - first2;
            sum += w;
            sum1 += w * x1;
            sum2 += w * x2;
            products += (w * x2) * x1.transpose();
            squares += w * x1.squaredNorm();
        }
        const Eigen::Vector3d mean1 = sum1 / sum, mean2 = sum2 / sum;
        const double variance = squares - sum1.dot(mean1);
        const ClosestRotation closest(products - sum2 * mean1.transpose());
        const double scale = scaled ? 3 * closest.scale / variance : 1;
        const bool line = !(closest.singularValues[1] >
                            THINNEST * closest.singularValues[0]);  // NaN counts as a line
        if (line || !(scale > 0 && scale <= DBL_MAX))
            return false;
        const Eigen::Matrix3d A = scale * closest.rotation;
        model = motionOf(A, first2 + mean2 - A * (first1 + mean1));
        return true;
    }

private:
    const bool scaled;
};

}  // namespace

Ptr<NonMinimalSolver> createRigidLeastSquares(bool scaled)
{
    return makePtr<RigidLeastSquares>(scaled);
}

}  // namespace usacv20
}  // namespace cv
