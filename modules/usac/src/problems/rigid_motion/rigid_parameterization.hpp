// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_RIGID_PARAMETERIZATION_HPP
#define OPENCV_USACV20_RIGID_PARAMETERIZATION_HPP

#include "optimization/tangent_space.hpp"

namespace cv {
namespace usacv20 {

//! The 3x4 matrix [A t].
inline Model motionOf(const Eigen::Matrix3d& A, const Eigen::Vector3d& t)
{
    Model result(3, 4);
    Eigen::Map<Eigen::Matrix<double, 3, 4, Eigen::RowMajor>> M(result.val);
    M.leftCols<3>() = A;
    M.col(3) = t;
    return result;
}

/** @brief A motion of space, [sR t], and a minimal parameterization around it. The parameters
are the rotation vector, in radians, of a rotation that is applied after the present rotation, an
increment of the translation and, if `SCALED`, the relative increase of the scale. Zero parameters
give the motion itself. */
template <bool SCALED>
class RigidParameterization
{
public:
    enum { DIMENSION = SCALED ? 7 : 6, NUMBERS = 12, SMOOTH = 1 };
    typedef Eigen::Matrix<double, NUMBERS, DIMENSION> Basis;
    typedef Eigen::Matrix<double, DIMENSION, 1> Step;
    typedef Eigen::Matrix<double, DIMENSION, DIMENSION> Matrix;

    //! The parameterization around the motion whose linear part is closest to that of `model`.
    explicit RigidParameterization(const Model& model);

    static int dimension() { return DIMENSION; }
    //! False if the scale is not positive; a scale of 0 maps all points to a single point.
    bool hasFullRank() const { return scale > 0; }
    bool wellConditioned() const { return hasFullRank(); }
    //! Derivatives of the model, as a 12-vector row by row, with respect to the parameters at 0.
    Basis tangent() const;
    //! Converts normal equations in the entries of the model to normal equations in the parameters.
    void project(const SpaceEquations& sums, Matrix& A, Step& b) const
    {
        projectOnTangents<DIMENSION>(sums, tangent(), A, b);
    }
    //! The parameterization around the model with the parameters `step`.
    RigidParameterization plus(const Step& step) const;
    Model model() const { return motionOf(scale * R, t); }

private:
    Eigen::Matrix3d R;
    Eigen::Vector3d t;
    double scale;
};

}  // namespace usacv20
}  // namespace cv

#endif
