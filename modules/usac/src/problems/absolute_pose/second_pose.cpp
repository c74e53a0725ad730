// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include <numeric>
#include <Eigen/Eigenvalues>
#include "components/point_subset.hpp"
#include "numeric/bits.hpp"
#include "problems/absolute_pose/absolute_pose.hpp"
#include "problems/absolute_pose/pose_parameterization.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Points are nearly coplanar if their standard deviation from a plane is at most this fraction of
//! the smaller of their two standard deviations in the plane. Half and double change nothing: if
//! points are farther from the plane, the pose of a sample leads to the better minimum.
constexpr double FLAT = 0.1;
//! Maximum number of inliers that show whether there is a second pose.
constexpr int FEW = 100;
//! The second pose is compared with the first one over all inliers unless its sum of squared errors
//! over these few inliers is so many times as large.
constexpr double WORSE = 2;
//! Maximum number of steps of a fit. With ten, some fits stop between the minima, where the sum of
//! squared errors is nearly constant; more than 20 change nothing.
constexpr int STEPS = 20;

/** @brief Replaces the pose of a plane with the second pose of the plane if that fits better.

From far away, a plane looks the same if it is mirrored at a plane that is perpendicular to the line
of sight. Thus, the sum of squared errors has two minima @cite schweighofer2006robust, and the model
of a sample often leads to the worse one. With the normal n of the plane in object coordinates and
the direction v of the centroid in camera coordinates, R' = (I - 2 v v^T) R (I - 2 n n^T) is close
to the rotation of the other minimum. The better one of two fits, which start there and from the
first pose, replaces the first pose if it lowers the cost.

Only optimized poses are examined, and only if a few of their inliers are nearly coplanar and have
a second pose. */
class SecondPose : public Degeneracy
{
public:
    explicit SecondPose(const Matx33d& camera_) : camera(camera_) {}

    bool recover(const Context& context, State&, const int* sample, Model& model,
                 Quality& quality) CV_OVERRIDE
    {
        Arena::Scope scope(context.arena);
        int* const inliers = scope.take<int>(context.points.size);
        Model second = model;
        if (sample || !context.components.nonMinimalSolver || !findSecond(context, inliers, second))
            return true;
        const int count = findInliers(context, model, context.points.size, inliers);
        Model starts[] = {model, second};
        for (Model& fitted : starts)
        {
            if (!fit(context, inliers, count, fitted))
                continue;
            const Quality rated = context.rate(fitted, quality.cost);
            if (!rated.betterThan(quality))
                continue;
            model = fitted;
            quality = rated;
        }
        return true;
    }

private:
    static bool fit(const Context& context, const int* indices, int count, Model& model)
    {
        return context.components.nonMinimalSolver->fit(context.points, indices, count, 0, model,
                                                        STEPS);
    }

    //! Finds inliers until there are at least `wanted`. @return their number
    static int findInliers(const Context& context, const Model& model, int wanted, int* inliers)
    {
        const float limit = (float)(context.inlierThreshold() * context.inlierThreshold());
        const int size = context.points.size;
        int count = 0;
        for (int begin = 0; begin < size && count < wanted; begin += WORD_BITS)
        {
            float errors[WORD_BITS];
            const int end = std::min(begin + WORD_BITS, size);
            context.components.residual->squaredErrors(context.points, model, begin, end, errors);
            for (uint64 word = within(errors, end - begin, limit); word; word &= word - 1)
                inliers[count++] = begin + lowestOne(word);
        }
        return count;
    }

    //! Fits the second pose to a few inliers of `model`, which it replaces. @return false if they
    //! are not nearly coplanar, if the fit leads back to the first pose, or if it is much worse
    bool findSecond(const Context& context, int* inliers, Model& model) const
    {
        const Correspondences& p = context.points;
        const Residual& residual = *context.components.residual;
        const int count = std::min(findInliers(context, model, FEW, inliers), FEW);
        Model mirrored = model;
        if (count <= context.components.minimalSolver->sampleSize() ||
            !mirror(p, inliers, count, mirrored))
            return false;
        Model second = mirrored;
        if (!fit(context, inliers, count, second) ||
            distance(second, model) < distance(mirrored, model) / 2)
            return false;
        Arena::Scope scope(context.arena);
        PointSubset few(p, count, scope);
        for (int i = 0; i < count; ++i)
            few.add(inliers[i]);
        const double before = sumOf(few.squaredErrors(residual, model), count);
        model = second;
        return sumOf(few.squaredErrors(residual, model), count) <= WORSE * before;
    }

    static double distance(const Model& a, const Model& b)
    {
        return std::sqrt(normL2Sqr<double, double>(a.val, b.val, a.size()));
    }

    static double sumOf(const double* values, int count)
    {
        return std::accumulate(values, values + count, 0.);
    }

    //! Replaces a pose with the approximate second pose. @return false if the points are not nearly
    //! coplanar
    bool mirror(const Correspondences& p, const int* indices, int count, Model& model) const
    {
        Eigen::Vector3d center = Eigen::Vector3d::Zero();
        Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
        for (int i = 0; i < count; ++i)
        {
            const Eigen::Vector3d X(p.exact[0][indices[i]], p.exact[1][indices[i]],
                                    p.exact[2][indices[i]]);
            center += X;
            squares += X * X.transpose();
        }
        center /= count;
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(squares / count -
                                                                  center * center.transpose());
        if (!(axes.eigenvalues()[0] <= FLAT * FLAT * axes.eigenvalues()[1]))
            return false;
        const PoseParameterization pose(camera, model);
        const Matx33d rotation = pose.rotation();
        const Eigen::Matrix3d R = Eigen::Map<const RowMajor3>(rotation.val);
        const Vec3d t = pose.translation();
        const Eigen::Vector3d n = axes.eigenvectors().col(0),
                              seen = R * center + Eigen::Vector3d(t[0], t[1], t[2]),
                              v = seen.normalized();
        const RowMajor3 mirrored = (R - 2 * v * (v.transpose() * R)) *
                                   (Eigen::Matrix3d::Identity() - 2 * n * n.transpose());
        const Eigen::Vector3d moved = seen - mirrored * center;
        model = PoseParameterization(camera, Matx33d(mirrored.data()),
                                     Vec3d(moved[0], moved[1], moved[2]))
                    .model();
        return true;
    }

    const Matx33d camera;
};

}  // namespace

Ptr<Degeneracy> createSecondPose(const Matx33d& camera) { return makePtr<SecondPose>(camera); }

}  // namespace usacv20
}  // namespace cv
