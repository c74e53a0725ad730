// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/eigenvalues.hpp"

#include <Eigen/Eigenvalues>

namespace opencv_test {

MatrixXcl eigenvaluesOf(const MatrixXl& matrix, MatrixXcl* vectors)
{
    const Eigen::EigenSolver<MatrixXl> solver(matrix, vectors != 0);
    if (vectors)
        *vectors = solver.eigenvectors();
    return solver.eigenvalues();
}

}  // namespace opencv_test
