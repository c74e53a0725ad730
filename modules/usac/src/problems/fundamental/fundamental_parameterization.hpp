// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_FUNDAMENTAL_PARAMETERIZATION_HPP
#define OPENCV_USACV20_FUNDAMENTAL_PARAMETERIZATION_HPP

#include "optimization/tangent_space.hpp"

namespace cv {
namespace usacv20 {

//! Smallest ratio of the two singular values of F that counts as rank 2.
constexpr double LEAST_RATIO = 1e-6;

/** @brief A fundamental matrix and a minimal parameterization around it; parameters 0 are the model
itself.

F = U S V^T with rotations U and V and a 2x2 matrix, of unit norm, in the upper left corner of S. A
tangent of the matrices of rank 2 has any entries in the place of S but the last one
@cite vandereycken2013low; those of unit norm are orthogonal to S, too. That leaves 3 directions of
the corner, 2 of the last column and 2 of the last row: 7, orthogonal, whatever the singular values
are. (The angles of U and V are no such parameters: where both singular values are equal, as under a
pure translation, turning both about the third axis leaves F as it is.) */
class FundamentalParameterization
{
public:
    enum { DIMENSION = 7, NUMBERS = 9 };
    typedef Eigen::Matrix<double, 9, DIMENSION> Basis;
    typedef Eigen::Matrix<double, DIMENSION, 1> Step;
    typedef Eigen::Matrix<double, DIMENSION, DIMENSION> Matrix;

    //! Around the closest model of rank 2 and unit norm.
    explicit FundamentalParameterization(const Model& model);

    //! False for F of rank 1.
    bool hasFullRank() const;
    //! Derivatives of the model, as a 9-vector row by row, by the parameters at zero.
    Basis tangent() const;
    //! Normal equations in the parameters from those in the entries of the model: B^T JtJ B, B^T
    //! Jtr with B = tangent().
    void project(const NormalEquations& sums, Matrix& A, Step& b) const
    {
        projectOnTangents<DIMENSION>(sums, tangent(), A, b);
    }
    //! The parameterization around the model that has these parameters.
    FundamentalParameterization plus(const Step& step) const;
    Model model() const;

private:
    //! The three directions of the corner: an orthonormal basis of the complement of its four
    //! entries.
    void cornerDirections(Eigen::Matrix2d (&directions)[3]) const;

    Eigen::Matrix3d U, V;    //!< orthogonal, of either sign
    Eigen::Matrix2d corner;  //!< of S
};

}  // namespace usacv20
}  // namespace cv

#endif
