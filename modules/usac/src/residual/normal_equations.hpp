// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_NORMAL_EQUATIONS_HPP
#define OPENCV_USACV20_NORMAL_EQUATIONS_HPP

#include <Eigen/Core>
#include "residual/point_chunks.hpp"

namespace cv {
namespace usacv20 {

/** Normal equations of the Gauss-Newton method in the `SIZE` entries of the model (Eigen::Dynamic:
any number of entries): JtJ = J^T J, Jtr = J^T r and the cost r^T r for weighted errors r with the
Jacobian J. A parameterization then projects the equations onto its tangent space, so that the work
per point is the same for all parameterizations. */
template <int SIZE>
struct NormalEquationsOf
{
    enum { MOST = SIZE == Eigen::Dynamic ? (int)MAX_MODEL_SIZE : SIZE };
    Eigen::Matrix<double, SIZE, SIZE, Eigen::RowMajor, MOST, MOST> JtJ;
    Eigen::Matrix<double, SIZE, 1, Eigen::ColMajor, MOST, 1> Jtr;
    double cost;

    //! Computes the sums over the points with a kernel, or with Residual::linearize() if the
    //! residual has no kernels. The model has `SIZE` entries (Eigen::Dynamic: any number).
    void accumulate(const Residual& residual, const PointChunks& points, const Model& model);

    //! Computes only the cost, in a fraction of the time of accumulate().
    static double costOf(const Residual& residual, const PointChunks& points, const Model& model);
};

//! NormalEquations is for models that are 3x3 matrices, SpaceEquations for 3x4 matrices: the pose
//! of a camera or a 3-D motion.
typedef NormalEquationsOf<9> NormalEquations;
typedef NormalEquationsOf<12> SpaceEquations;

}  // namespace usacv20
}  // namespace cv

#endif
