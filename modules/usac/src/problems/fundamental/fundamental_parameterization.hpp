// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_FUNDAMENTAL_PARAMETERIZATION_HPP
#define OPENCV_USACV20_FUNDAMENTAL_PARAMETERIZATION_HPP

#include "optimization/tangent_space.hpp"

namespace cv {
namespace usacv20 {

/** @brief A fundamental matrix and a minimal parameterization around it; zero parameters give the
matrix itself.

F = U S V^T with orthogonal U and V. S has a 2x2 matrix of unit norm in its upper left corner and is
0 elsewhere. A tangent vector of the manifold of matrices of rank 2 is U D V^T, where the last entry
of D is 0 and the other entries are arbitrary @cite vandereycken2013low; for unit norm D is also
orthogonal to S. This leaves 3 directions of the corner, 2 of the last column and 2 of the last row:
7 orthogonal directions for any singular values. (Rotation angles of U and V are not suitable
parameters: if both singular values are equal, as for a pure translation, rotating U and V together
about the third axis does not change F.) */
class FundamentalParameterization
{
public:
    enum { DIMENSION = 7, NUMBERS = 9, SMOOTH = 0 };
    typedef Eigen::Matrix<double, 9, DIMENSION> Basis;
    typedef Eigen::Matrix<double, DIMENSION, 1> Step;
    typedef Eigen::Matrix<double, DIMENSION, DIMENSION> Matrix;

    //! The parameterization around the matrix of rank 2 and unit norm that is closest to `model`.
    explicit FundamentalParameterization(const Model& model);

    static int dimension() { return DIMENSION; }
    //! False if F has rank 1, up to rounding.
    bool hasFullRank() const;
    //! False if F is close to rank 1. Only for the normalized coordinates of Correspondences,
    //! because the limit depends on the unit of length.
    bool wellConditioned() const;
    //! Derivatives of the model, as a 9-vector row by row, with respect to the parameters at 0.
    Basis tangent() const;
    //! Converts normal equations in the entries of the model to normal equations in the
    //! parameters: B^T JtJ B and B^T Jtr with B = tangent().
    void project(const NormalEquations& sums, Matrix& A, Step& b) const
    {
        projectOnTangents<DIMENSION>(sums, tangent(), A, b);
    }
    //! The parameterization around the model with the parameters `step`.
    FundamentalParameterization plus(const Step& step) const;
    Model model() const;

private:
    //! Computes the three directions of the corner: an orthonormal basis of the 2x2 matrices that
    //! are orthogonal to the corner.
    void cornerDirections(Eigen::Matrix2d (&directions)[3]) const;

    Eigen::Matrix3d U, V;    //!< orthogonal, with a determinant of 1 or -1
    Eigen::Matrix2d corner;  //!< upper left 2x2 block of S
};

}  // namespace usacv20
}  // namespace cv

#endif
