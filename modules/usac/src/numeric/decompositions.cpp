// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/decompositions.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>

namespace cv {
namespace usacv20 {

Eigen::VectorXd singularValues(const Eigen::MatrixXd& A)
{
    return Eigen::JacobiSVD<Eigen::MatrixXd>(A).singularValues();
}

Eigen::MatrixXd solveLeastSquares(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B)
{
    return Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(A).solve(B);
}

Eigen::MatrixXd orthonormalBasis(const Eigen::MatrixXd& A)
{
    return Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(A).householderQ() *
           Eigen::MatrixXd::Identity(A.rows(), A.cols());
}

}  // namespace usacv20
}  // namespace cv
