// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_DECOMPOSITIONS_HPP
#define OPENCV_USACV20_DECOMPOSITIONS_HPP

#include <Eigen/Core>

namespace cv {
namespace usacv20 {

// Decompositions of matrices of any size. Eigen's templates for them take seconds to compile, so
// all callers share these functions.

//! Singular values in decreasing order.
Eigen::VectorXd singularValues(const Eigen::MatrixXd& A);

//! The X that minimizes |A X - B|, by QR decomposition with column pivoting.
Eigen::MatrixXd solveLeastSquares(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

//! An orthonormal basis of the column space of A. A must have full column rank; the result
//! has as many columns as A.
Eigen::MatrixXd orthonormalBasis(const Eigen::MatrixXd& A);

}  // namespace usacv20
}  // namespace cv

#endif
