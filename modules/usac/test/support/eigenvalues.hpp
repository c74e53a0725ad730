// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_EIGENVALUES_HPP
#define OPENCV_USACV20_TEST_EIGENVALUES_HPP

#include <complex>
#include <Eigen/Core>

namespace opencv_test {

typedef Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic> MatrixXl;
typedef Eigen::Matrix<std::complex<long double>, Eigen::Dynamic, Eigen::Dynamic> MatrixXcl;

//! Eigenvalues of a square matrix, as a column.
//! @param vectors output unless null: eigenvectors, as columns
MatrixXcl eigenvaluesOf(const MatrixXl& matrix, MatrixXcl* vectors = 0);

}  // namespace opencv_test

#endif
