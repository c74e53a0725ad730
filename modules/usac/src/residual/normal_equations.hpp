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
any number of them): JtJ, Jtr and the cost r^T r. A parameterization then projects them onto its
tangent space, so that the work per point is the same for all parameterizations. */
template <int SIZE>
struct NormalEquationsOf
{
    enum { MOST = SIZE == Eigen::Dynamic ? (int)MAX_MODEL_SIZE : SIZE };
    Eigen::Matrix<double, SIZE, SIZE, Eigen::RowMajor, MOST, MOST> JtJ;
    Eigen::Matrix<double, SIZE, 1, Eigen::ColMajor, MOST, 1> Jtr;
    double cost;

    //! Computes the sums over the points by a kernel; if the residual has none, by
    //! Residual::linearize(). The model has `SIZE` numbers.
    void accumulate(const Residual& residual, const PointChunks& points, const Model& model);

    //! The cost alone, in a fraction of the time.
    static double costOf(const Residual& residual, const PointChunks& points, const Model& model);
};

//! For a 3x3 matrix, and for the 3x4 matrix of a camera or of a 3-D motion.
typedef NormalEquationsOf<9> NormalEquations;
typedef NormalEquationsOf<12> SpaceEquations;

}  // namespace usacv20
}  // namespace cv

#endif
