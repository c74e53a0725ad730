// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_POSE_PARAMETERIZATION_HPP
#define OPENCV_USACV20_POSE_PARAMETERIZATION_HPP

#include "optimization/tangent_space.hpp"

namespace cv {
namespace usacv20 {

/** @brief The pose of a camera and a minimal parameterization around it. The parameters are the
rotation vector, in radians, of a rotation that is applied after the present rotation, and an
increment of the translation. Zero parameters give the pose itself. */
class PoseParameterization
{
public:
    enum { DIMENSION = 6, NUMBERS = 12, SMOOTH = 1 };
    typedef Eigen::Matrix<double, NUMBERS, DIMENSION> Basis;
    typedef Eigen::Matrix<double, DIMENSION, 1> Step;
    typedef Eigen::Matrix<double, DIMENSION, DIMENSION> Matrix;

    //! Creates the parameterization around the pose that is closest to a model, a 3x4 matrix
    //! K [R t].
    struct Around
    {
        explicit Around(const Matx33d& K_) : K(K_) {}
        PoseParameterization operator()(const Model& model) const
        {
            return PoseParameterization(K, model);
        }

        Matx33d K;
    };

    PoseParameterization(const Matx33d& K, const Model& model);
    PoseParameterization(const Matx33d& K, const Matx33d& rotation, const Vec3d& translation);

    static int dimension() { return DIMENSION; }
    bool hasFullRank() const { return true; }
    bool wellConditioned() const { return hasFullRank(); }
    //! Derivatives of the model, as a 12-vector row by row, with respect to the parameters at 0.
    Basis tangent() const;
    //! Converts normal equations in the entries of the model to normal equations in the parameters.
    void project(const SpaceEquations& sums, Matrix& A, Step& b) const
    {
        projectOnTangents<DIMENSION>(sums, tangent(), A, b);
    }
    //! The parameterization around the model with the parameters `step`.
    PoseParameterization plus(const Step& step) const;
    //! The matrix K [R t].
    Model model() const;
    Matx33d rotation() const;
    Vec3d translation() const { return Vec3d(t[0], t[1], t[2]); }

private:
    Model withCamera(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& translation) const;

    Eigen::Matrix3d K, R;
    Eigen::Vector3d t;
};

}  // namespace usacv20
}  // namespace cv

#endif
