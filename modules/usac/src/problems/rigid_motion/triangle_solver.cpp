// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include <Eigen/Geometry>
#include "problems/rigid_motion/rigid_motion.hpp"
#include "problems/rigid_motion/rigid_parameterization.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Three points with their own coordinate frame: two axes in their plane, and its normal.
struct Triangle
{
    Triangle(const double* const* columns, const int* sample)
    {
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k)
                corners(k, i) = columns[k][sample[i]];
        center = corners.rowwise().mean();
        corners.colwise() -= center;
        const Eigen::Vector3d side = corners.col(1) - corners.col(0),
                              other = corners.col(2) - corners.col(0);
        const Eigen::Vector3d normal = side.cross(other);
        const double area = normal.squaredNorm(),
                     longest = std::max(side.squaredNorm(), other.squaredNorm());
        regular = area > DBL_EPSILON * longest * longest && area <= DBL_MAX;
        axes.col(0) = side.normalized();
        axes.col(1) = normal.normalized().cross(axes.col(0)).normalized();
        // Due to rounding, the vector `normal` is not exactly perpendicular to the sides of a thin
        // triangle.
        axes.col(2) = axes.col(0).cross(axes.col(1));
    }

    //! Coordinates of the corners in the plane of the triangle, relative to the center.
    Eigen::Matrix<double, 2, 3> flat() const { return axes.leftCols<2>().transpose() * corners; }

    Eigen::Matrix3d corners;  //!< relative to the center, as columns
    Eigen::Matrix3d axes;     //!< orthonormal, as columns
    Eigen::Vector3d center;
    //! True if the height above the longer of the two sides at the first corner is more than
    //! sqrt(DBL_EPSILON) times this side, so that the normal is determined. False if numbers
    //! overflow.
    bool regular;
};

/** Rigid motion from three points by least squares @cite horn1987closed. The best rotation maps the
plane of the first triangle to that of the second one, with the corners in the same orientation, and
then rotates within this plane by the least-squares angle. The centroid of the first triangle is
mapped to that of the second one. If `scaled` is true, the scale is the least-squares scale for this
rotation @cite umeyama1991least. A sample of three collinear points is degenerate. */
class TriangleSolver : public MinimalSolver
{
public:
    explicit TriangleSolver(bool scaled_) : scaled(scaled_) {}

    int sampleSize() const CV_OVERRIDE { return 3; }

    int solve(const Correspondences& p, const int* sample, Model* models) const CV_OVERRIDE
    {
        const Triangle from(p.exact, sample), to(p.exact + 3, sample);
        if (!from.regular || !to.regular)
            return 0;
        const Eigen::Matrix<double, 2, 3> a = from.flat(), b = to.flat();
        const double cosine = a.cwiseProduct(b).sum(),
                     sine = a.row(0).dot(b.row(1)) - a.row(1).dot(b.row(0));
        const double size = std::sqrt(cosine * cosine + sine * sine),
                     scale = scaled ? size / a.squaredNorm() : 1;
        Eigen::Matrix3d turned = to.axes;
        turned.col(0) = (cosine * to.axes.col(0) + sine * to.axes.col(1)) / size;
        turned.col(1) = (cosine * to.axes.col(1) - sine * to.axes.col(0)) / size;
        const Eigen::Matrix3d A = scale * turned * from.axes.transpose();
        if (!(size > 0 && size <= DBL_MAX && A.allFinite()))
            return 0;
        models[0] = motionOf(A, to.center - A * from.center);
        return 1;
    }

private:
    const bool scaled;
};

}  // namespace

Ptr<MinimalSolver> createTriangleSolver(bool scaled) { return makePtr<TriangleSolver>(scaled); }

}  // namespace usacv20
}  // namespace cv
