// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_ESSENTIAL_PARAMETERIZATION_HPP
#define OPENCV_USACV20_ESSENTIAL_PARAMETERIZATION_HPP

#include "optimization/tangent_space.hpp"

namespace cv {
namespace usacv20 {

/** @brief An essential matrix and a minimal parameterization around it; zero parameters give the
matrix itself.

E = U diag(1, 1, 0) V^T / sqrt(2) has 5 parameters, angles in radians: 3 rotations of U and 2 of V.
The third rotation of V, about the last column, would change E in the same way as a rotation of U
does. @cite helmke2007essential */
class EssentialParameterization
{
public:
    enum { DIMENSION = 5, NUMBERS = 9, SMOOTH = 0 };
    typedef Eigen::Matrix<double, 9, DIMENSION> Basis;
    typedef Eigen::Matrix<double, DIMENSION, 1> Step;
    typedef Eigen::Matrix<double, DIMENSION, DIMENSION> Matrix;

    //! The parameterization around the essential matrix closest to `model`.
    explicit EssentialParameterization(const Model& model);

    static int dimension() { return DIMENSION; }
    bool hasFullRank() const { return true; }
    bool wellConditioned() const { return hasFullRank(); }
    //! Derivatives of the model, as a 9-vector row by row, with respect to the parameters at 0.
    Basis tangent() const;
    //! Converts normal equations in the entries of the model to normal equations in the
    //! parameters: B^T JtJ B and B^T Jtr with B = tangent().
    void project(const NormalEquations& sums, Matrix& A, Step& b) const
    {
        projectOnTangents<DIMENSION>(sums, tangent(), A, b);
    }
    //! The parameterization around the model with the parameters `step`.
    EssentialParameterization plus(const Step& step) const;
    Model model() const;

private:
    Eigen::Matrix3d U, V;
};

}  // namespace usacv20
}  // namespace cv

#endif
